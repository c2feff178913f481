/// @file
/// Text as JSON writes it.
#pragma once

#include <string>
#include <string_view>

namespace tumble::support {

/// A text in quotation marks.
inline std::string json_text(std::string_view text) {
  std::string json = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') json += '\\';
    if (static_cast<unsigned char>(letter) < ' ') {
      constexpr std::string_view digits = "0123456789abcdef";
      json.append("\\u00").append(1, digits[static_cast<unsigned char>(letter) / 16]);
      json += digits[static_cast<unsigned char>(letter) % 16];
    } else {
      json += letter;
    }
  }
  return json + '"';
}

}  // namespace tumble::support
