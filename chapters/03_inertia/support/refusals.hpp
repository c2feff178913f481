/// @file
/// Programs that try what cannot be, and print the sentence that it gets.
#pragma once

#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>

namespace tumble::support {

/// Prints `text` indented, in lines short enough for a page.
inline void print_wrapped(const std::string& text) {
  const std::string indent = "    ";
  std::istringstream words(text);
  std::string line = indent, word;
  while (words >> word) {
    if (line.size() + 1 + word.size() > 88) {
      std::printf("%s\n", line.c_str());
      line = indent;
    }
    line.append(line == indent ? "" : " ").append(word);
  }
  std::printf("%s\n", line.c_str());
}

/// Does `action` and prints what came of it; returns 1 if it was refused.
template <class Action>
int try_it(const char* what, const Action& action) {
  std::printf("%s\n", what);
  try {
    action();
    print_wrapped("is taken");
    return 0;
  } catch (const std::invalid_argument& error) {
    print_wrapped(error.what());
    return 1;
  }
}

}  // namespace tumble::support
