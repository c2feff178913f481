/// @file
/// Threads that wait for work which comes thousands of times a second.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tumble {

/// Where the share of a member of a pool begins, among `count` of anything; it ends where the next
/// member's begins.
inline std::size_t share_of(std::size_t count, int member, int members) {
  return count * static_cast<std::size_t>(member) / static_cast<std::size_t>(members);
}

/// Some threads, the caller's among them, that do the same piece of work on different bodies. To
/// start a thread costs more than a small world's step, so they are started once. A copy is another
/// pool of the same size, whose threads start with its first task. A pool that is assigned one of
/// its own size keeps its threads.
//! [pool]
class ThreadPool {
 public:
  using Task = std::function<void(int)>;

  /// @throws std::invalid_argument if the size is not from 1 to 1024, std::system_error if the
  /// system gives no more threads.
  explicit ThreadPool(int size = 1) : size_(size) {
    if (size < 1 || size > 1024)
      throw std::invalid_argument(std::to_string(size) +
                                  " threads were asked for; a world can use from 1 to 1024");
    if (size > 1) workers_ = std::make_unique<Workers>(size - 1);
  }
  ThreadPool(const ThreadPool& other) : size_(other.size_) {}
  ThreadPool(ThreadPool&&) = default;
  ThreadPool& operator=(const ThreadPool& other) {
    if (size_ != other.size_) workers_.reset();
    size_ = other.size_;
    return *this;
  }
  ThreadPool& operator=(ThreadPool&&) = default;

  int size() const { return size_; }

  /// Calls `task` with 0, 1, … size − 1, each on a thread of its own, and waits for all of them.
  /// What one of them throws, this throws once all are done.
  void run(const Task& task) {
    if (size_ == 1) return task(0);
    if (!workers_) workers_ = std::make_unique<Workers>(size_ - 1);
    workers_->begin(task);
    workers_->do_share(0);
    workers_->wait_until_done();
  }
  //! [pool]

  /// Calls `task` with the number of each member and how many there are; with 0 and 1 alone if it
  /// is not `worth_it` to wake the others.
  template <class TaskOfThread>
  void parallel_for(bool worth_it, const TaskOfThread& task) {
    if (worth_it)
      run([&](int member) { task(member, size_); });
    else
      task(0, 1);
  }

 private:
  /// All but the caller's thread.
  class Workers {
   public:
    explicit Workers(int count) {
      try {
        for (int member = 1; member <= count; ++member)
          threads_.emplace_back([this, member] { serve(member); });
      } catch (...) {  // those that have come would wait for ever
        end();
        throw;
      }
    }
    ~Workers() { end(); }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    void begin(const Task& task) {
      has_failed_ = false;
      call(&task);
    }
    void do_share(int member) noexcept {
      try {
        (*task_)(member);
      } catch (...) {
        if (!has_failed_.exchange(true)) failure_ = std::current_exception();
      }
    }
    void wait_until_done() {
      for (unsigned busy = busy_.load(); busy > 0; busy = busy_.load()) wait_while(busy_, busy);
      if (has_failed_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

   private:
    // Not by std::jthread, which joins by itself: libc++ has it from its version 20 on.
    void end() {
      call(nullptr);
      for (std::thread& thread : threads_) thread.join();
    }

    void call(const Task* task) {
      task_ = task;
      busy_.store(static_cast<unsigned>(threads_.size()));
      calls_.fetch_add(1);
      calls_.notify_all();
    }

    void serve(int member) {
      for (unsigned seen = 0;; ++seen) {
        while (calls_.load() == seen) wait_while(calls_, seen);
        if (!task_) return;
        do_share(member);
        busy_.fetch_sub(1);
        busy_.notify_all();
      }
    }

    /// The next task comes within microseconds: falling asleep would take longer than looking
    /// again.
    static void wait_while(const std::atomic<unsigned>& number, unsigned old) {
      for (int look = 0; look < 4096; ++look)
        if (number.load(std::memory_order_relaxed) != old) return;
      number.wait(old);
    }

    const Task* task_ = nullptr;
    std::atomic<unsigned> calls_ = 0, busy_ = 0;
    std::atomic<bool> has_failed_ = false;
    std::exception_ptr failure_;  ///< the first one's
    std::vector<std::thread> threads_;
  };

  int size_;
  std::unique_ptr<Workers> workers_;
};

}  // namespace tumble
