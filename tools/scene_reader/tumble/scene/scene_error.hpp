/// @file
/// What is wrong with a scene file, and where.
#pragma once

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tumble/scene/plain_text.hpp>
#include <vector>

namespace tumble {

/// A scene that can't be loaded. The text reads "FILE: POINTER is VALUE UNIT; RULE", and is plain.
class SceneError : public std::runtime_error {
 public:
  SceneError(std::string in_file, std::string at_pointer, std::string what_is_wrong)
      : std::runtime_error(
            plain(in_file + ": " + at_pointer + (at_pointer.empty() ? "" : " ") + what_is_wrong)),
        file(std::move(in_file)),
        pointer(std::move(at_pointer)),
        sentence(std::move(what_is_wrong)) {}
  std::string file;      ///< as it was opened
  std::string pointer;   ///< a JSON Pointer (RFC 6901); empty for the file as a whole
  std::string sentence;  ///< what follows the pointer
};

/// How many letters to change, add or take away to make one word of the other.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/// "; did you mean CANDIDATE?" with the candidate that takes the fewest letters to change, if they
/// are few.
inline std::string did_you_mean(std::string_view word,
                                const std::vector<std::string_view>& candidates) {
  if (word.size() > 100) return {};  // no name is that long
  std::string_view best;
  std::size_t fewest = word.size() + 1;
  for (const std::string_view candidate : candidates)
    if (const std::size_t distance = edit_distance(word, candidate); distance < fewest) {
      best = candidate;
      fewest = distance;
    }
  if (fewest > 2 && 3 * fewest > best.size()) return {};
  return best.empty() ? std::string() : "; did you mean " + std::string(best) + "?";
}

}  // namespace tumble
