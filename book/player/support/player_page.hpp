/// @file
/// A page that replays one recording: a single file that needs no network and opens from the disk.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <support/player_files.hpp>

namespace tumble::support {

/// JSON for the inside of a script element, which the letters "</script>" in a name would end.
inline std::string json_in_script(std::string_view json) {
  std::string safe;
  for (const char letter : json) {
    if (letter == '<')
      safe += "\\u003c";
    else
      safe += letter;
  }
  return safe;
}

/// The whole page; `recording_json` is what support::Recording makes.
inline std::string player_page(std::string_view recording_json) {
  std::string page = R"(<!DOCTYPE html>
<html lang="en-GB">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Replay</title>
<link rel="icon" href="data:,">
<style>
)";
  page.append(player_style).append(R"(</style>
</head>
<body class="player-page">
<main>
<h1>Replay</h1>
<noscript><p>The replay is drawn by a script, and this browser runs none.</p></noscript>
<figure class="player"><div class="player-views"><div class="player-view">
<script type="application/json" class="player-recording">)");
  page.append(json_in_script(recording_json)).append(R"(</script>
</div></div></figure>
</main>
<script>
)");
  page.append(player_script).append("</script>\n</body>\n</html>\n");
  return page;
}

/// Writes the page to `file`, which is complete or not there: it is written beside its place first.
/// @throws std::runtime_error if it can't be written; what was there stays.
inline void write_player_page(const std::filesystem::path& file, std::string_view recording_json) {
  std::filesystem::path unfinished = file;
  unfinished += ".unfinished";
  std::error_code error;
  {
    std::ofstream out(unfinished, std::ios::binary);
    out << player_page(recording_json);
    out.close();
    if (!out) error = std::make_error_code(std::errc::io_error);
  }
  if (!error) std::filesystem::rename(unfinished, file, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  throw std::runtime_error("cannot write the page " + file.string() +
                           "; its folder must exist and be writable");
}

}  // namespace tumble::support
