/// @file
/// The answer, in words and in JSON.
#pragma once

#include "advisor.hpp"
#include "options.hpp"

namespace tumble::advise {

/// All that was found out. What was found points to the candidates: an answer can be moved, not
/// copied.
struct Answer {
  Options asked;
  std::vector<Candidate> candidates = {};
  std::string reference = {};  ///< what the winner was held against
  Errors uncertainty = {};     ///< of the reference
  Rounded rounded = {};        ///< of a free top: what the exact solution loses by being stored
  std::size_t bodies = 1;      ///< in the scene
  Verdict verdict = {};
  std::string refusal = {};  ///< why nothing is promised; empty if something is

  std::optional<Found> better = {};  ///< for a tenth of the error, confirmed
  std::optional<Found> worse = {};   ///< at a tenth of the cost
  std::optional<Found> least = {};   ///< what costs least at all
};

/// Measures, chooses, confirms. @throws SceneError.
Answer answer_to(const Options& options);

/// For people.
std::string text_of(const Answer& answer);

/// For programs, as answer.schema.json says.
std::string json_of(const Answer& answer);

}  // namespace tumble::advise
