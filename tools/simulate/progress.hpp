/// @file
/// How far the simulation is: a bar with the time left on a terminal, four calm lines elsewhere.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace tumble::simulate {

/// "12 s", "3 min 20 s" or "2 h 5 min".
inline std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

/// What is still to go, s, if a part of the work, 0 to 1, took so many seconds.
inline double time_left(double seconds, double part) {
  return seconds * (1 - part) / part;
}

class Progress {
  using Clock = std::chrono::steady_clock;

 public:
  explicit Progress(std::int64_t steps) : steps_(steps) {}

  void show(std::int64_t step) {
    if (is_terminal_) {
      const Clock::time_point now = Clock::now();
      if (step != steps_ && now - last_shown_ < std::chrono::milliseconds(100)) return;
      last_shown_ = now;
      show_bar(step);
    } else if (4 * step / steps_ != 4 * (step - 1) / steps_) {
      std::printf("%3lld %%: step %lld of %lld\n", static_cast<long long>(100 * step / steps_),
                  static_cast<long long>(step), static_cast<long long>(steps_));
      std::fflush(stdout);
    }
  }

  /// A line of its own, above the bar.
  void say(const std::string& sentence) const {
    std::printf("%s%s\n", is_terminal_ ? "\r\033[K" : "", sentence.c_str());
    std::fflush(stdout);
  }

  /// Leaves the line of the bar.
  void end() const {
    if (is_terminal_) std::printf("\n");
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }

 private:
  void show_bar(std::int64_t step) const {
    const double part = static_cast<double>(step) / static_cast<double>(steps_);
    const auto filled = static_cast<std::size_t>(30 * part);
    const std::string bar = std::string(filled, '#') + std::string(30 - filled, '.');
    std::printf("\r[%s] %3.0f %%  step %lld of %lld, %s left\033[K", bar.c_str(), 100 * part,
                static_cast<long long>(step), static_cast<long long>(steps_),
                duration_text(time_left(seconds(), part)).c_str());
    std::fflush(stdout);
  }

  std::int64_t steps_;
  bool is_terminal_ = ::isatty(STDOUT_FILENO) == 1;
  Clock::time_point started_ = Clock::now(), last_shown_ = started_ - std::chrono::seconds(1);
};

}  // namespace tumble::simulate
