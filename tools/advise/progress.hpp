/// @file
/// What is being tried, on a terminal.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <string>

namespace tumble::advise {

/// One line, written anew each time and gone in the end. The answer's own place, the standard
/// output, stays free of it; and where no terminal is, nothing is said.
class Progress {
 public:
  Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { show(""); }

  void show(const std::string& what) const {
    if (is_terminal_) std::fprintf(stderr, "\r\033[K%s", what.c_str());
  }

 private:
  bool is_terminal_ = ::isatty(STDERR_FILENO) == 1;
};

}  // namespace tumble::advise
