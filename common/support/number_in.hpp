/// @file
/// Numbers in what a program was asked.
#pragma once

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

namespace tumble::support {

/// The whole of `text` as a finite decimal number, or nothing. Not by std::from_chars, which libc++
/// has for such numbers from its version 20 on only.
inline std::optional<double> number_in(const std::string& text) {
  // What strtod() takes besides: blanks, a plus, hexadecimal digits, words.
  if (text.empty() || text[0] == '+' ||
      text.find_first_not_of("0123456789.eE+-") != std::string::npos)
    return std::nullopt;
  char* end = nullptr;
  errno = 0;
  const double value = std::strtod(text.c_str(), &end);
  if (errno != 0 || end != text.c_str() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace tumble::support
