/// @file
/// What the command lines of the programs that take a scene have in common.
#pragma once

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <support/shipped_scenes.hpp>
#include <support/usage_error.hpp>
#include <tumble/scene/scene_error.hpp>
#include <vector>

namespace tumble::support {

/// The file of a scene: the path of one, or the name of one that comes with the course.
/// @throws UsageError
inline std::filesystem::path find_scene(const std::string& word) {
  std::error_code unknown;
  if (std::filesystem::is_regular_file(word, unknown)) return word;
  std::vector<std::string> names;
  for (const std::filesystem::path& path : shipped_scenes()) {
    names.push_back(path.stem().string());
    if (names.back() == word) return path;
  }
  std::string sentence = "no scene and no file is called " + word +
                         did_you_mean(word, {names.begin(), names.end()}) + "\nThe scenes are:";
  for (const std::string& name : names) sentence += " " + name;
  throw UsageError(sentence);
}

/// Of a word that no option took: what is wrong with it, where these are the options.
/// @throws UsageError always.
[[noreturn]] inline void reject_word(const std::string& word,
                                     std::initializer_list<std::vector<std::string>> options) {
  if (!word.starts_with('-')) throw UsageError("one word too many: " + word);
  std::vector<std::string> known;
  for (const std::vector<std::string>& list : options)
    for (const std::string& name : list) known.push_back("--" + name);
  const std::string option = word.substr(0, word.find('='));
  throw UsageError("there is no option " + option +
                   did_you_mean(option, {known.begin(), known.end()}));
}

}  // namespace tumble::support
