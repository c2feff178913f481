/// @file
/// The text of a page that holds the engine and a scene.
#pragma once

#include <string>
#include <string_view>
#include <support/json_text.hpp>
#include <support/live_files.hpp>
#include <support/player_page.hpp>

namespace tumble::simulate {

/// Bytes as letters that may stand in a script (RFC 4648).
inline std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [bytes](std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u;
  };
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (int shift = 18; shift >= 0; shift -= 6) text += letters[three >> shift & 63];
  }
  for (std::size_t missing = (3 - bytes.size() % 3) % 3; missing > 0; --missing)
    text[text.size() - missing] = '=';
  return text;
}

/// A text for the inside of an element.
inline std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text)
    safe += letter == '<'   ? "&lt;"
            : letter == '>' ? "&gt;"
            : letter == '&' ? "&amp;"
                            : std::string(1, letter);
  return safe;
}

/// The page of a scene; `drawing` is the figure's script, and `module` what computes it.
template <class AnyScene>
std::string live_page(const AnyScene& scene, std::string_view text, std::string_view file,
                      std::string_view drawing, std::string_view module) {
  std::string page = R"(<!DOCTYPE html>
<html lang="en-GB">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>)" + escaped(scene.title) +
                     R"(</title>
<link rel="icon" href="data:,">
<style>
)";
  page.append(support::player_style).append(support::live_style).append(R"(</style>
</head>
<body class="player-page">
<main>
<h1>)");
  page.append(escaped(scene.title)).append("</h1>\n<p>").append(escaped(scene.description));
  page.append(R"(</p>
<noscript><p>The scene is computed and drawn by a script, and this browser runs none.</p></noscript>
<figure class="live" id="live_scene" data-live="scene" data-script="">
<div class="live-picture"></div>
<script type="application/json" class="live-texts">)");
  page.append(support::json_in_script("{\"scene\":" + support::json_text(text) +
                                      ",\"file\":" + support::json_text(file) + "}"));
  page.append("</script>\n</figure>\n</main>\n<script>\n");
  page.append(support::player_script).append(support::live_script).append(drawing);
  page.append("tumble_live.modules.scene = '").append(base64(module));
  return page.append("';\n</script>\n</body>\n</html>\n");
}

}  // namespace tumble::simulate
