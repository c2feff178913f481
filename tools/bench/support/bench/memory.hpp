/// @file
/// What the machine's memory can do: the least work on the most bytes.
#pragma once

#include <support/bench/setting.hpp>
#include <support/bench/shares.hpp>
#include <vector>

namespace tumble::support::bench {

/// Which loop reads and writes.
enum class Stream {
  update,  ///< a ← a + s b: reads two numbers and writes one, as a step does
  triad  ///< a ← b + s c, the loop of the STREAM benchmark; a is fetched too before it is written
};

/// Arrays of about `bytes` in all.
template <Stream stream>
class Memory {
 public:
  Memory(std::size_t bytes, int threads)
      : threads_(threads),
        a_(elements(bytes), 1.f),
        b_(a_.size(), 1.f),
        c_(stream == Stream::triad ? a_.size() : 0, 1.f) {}

  /// What one pass reads and writes, bytes, without what the machine fetches in vain.
  static constexpr double moved(std::size_t bytes) {
    return 3 * sizeof(float) * static_cast<double>(elements(bytes));
  }

  void run(int steps) {
    in_shares(a_.size(), threads_, [&](std::size_t first, std::size_t end) {
      for (int step = 0; step < steps; ++step) pass(first, end);
    });
  }

 private:
  static constexpr std::size_t elements(std::size_t bytes) {
    return bytes / sizeof(float) / (stream == Stream::update ? 2 : 3) + 1;
  }

  void pass(std::size_t first, std::size_t end) {
    const float s = 1e-9f;
    float* const a = a_.data();
    const float *const b = b_.data(), *const c = c_.data();
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
    for (std::size_t n = first; n < end; ++n)
      a[n] = stream == Stream::update ? a[n] + s * b[n] : b[n] + s * c[n];
  }

  int threads_;
  std::vector<float> a_, b_, c_;
};

}  // namespace tumble::support::bench
