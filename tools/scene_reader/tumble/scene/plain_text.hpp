/// @file
/// Text that a terminal shows and doesn't obey.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace tumble {

/// A letter that a terminal obeys, at the front of a text; of length 0 if there is none.
struct ControlLetter {
  unsigned number = 0;     ///< Unicode's
  std::size_t length = 0;  ///< in bytes of UTF-8
};

/// The control characters, line ends and tabs excepted, and Unicode's own, which end a line or turn
/// its direction.
inline ControlLetter control_at_front(std::string_view text) {
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(0), second = byte(1), third = byte(2);
  if (first == 0x7f || (first < 0x20 && first != '\n' && first != '\t')) return {first, 1};
  if (first == 0xc2 && second >= 0x80 && second < 0xa0) return {second, 2};
  if (first == 0xd8 && second == 0x9c) return {0x61c, 2};
  if (first != 0xe2) return {};
  const unsigned number = 0x2000 + ((second & 0x3f) << 6) + (third & 0x3f);
  const bool turns_lines = (number >= 0x200e && number <= 0x200f) ||
                           (number >= 0x2028 && number <= 0x202e) ||
                           (number >= 0x2066 && number <= 0x2069);
  return turns_lines ? ControlLetter{number, 3} : ControlLetter{};
}

/// The text with an escape of four hexadecimal digits for each letter that a terminal obeys.
inline std::string plain(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const ControlLetter control = control_at_front(text);
    if (control.length > 0) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", control.number & 0xffff);
      shown += escape;
    } else {
      shown += text[0];
    }
    text.remove_prefix(control.length > 0 ? control.length : 1);
  }
  return shown;
}

}  // namespace tumble
