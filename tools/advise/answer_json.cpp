#include <nlohmann/json.hpp>

#include "answer.hpp"

namespace tumble::advise {
namespace {

using Json = nlohmann::ordered_json;

/// A number, or null where there is none.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const Errors& errors, const Tolerance& tolerance) {
  return {{"angle", std::isfinite(tolerance.angle) ? number(errors.angle) : Json(nullptr)},
          {"place", std::isfinite(tolerance.place) ? number(errors.place) : Json(nullptr)}};
}

Json json_of(const std::optional<Found>& found, const Answer& answer) {
  if (!found) return nullptr;
  const Frames& frames = answer.asked.frames;
  const Candidate& candidate = *found->candidate;
  const bool own = candidate.chooses_steps(), even = candidate.takes_steps && !own;
  const long rate = frames.rate * found->fineness;
  const double fit = std::floor(1e9 / found->nanoseconds);
  return {
      {"method", candidate.method},
      {"scheme", candidate.scheme.empty() ? Json(nullptr) : Json(candidate.scheme)},
      {"precision", candidate.precision},
      {"steps_per_second", even ? Json(rate) : Json(nullptr)},
      {"time_step", even ? Json(1 / static_cast<double>(rate)) : Json(nullptr)},
      {"tolerance_per_second",
       own && !candidate.is_given_angle ? Json(candidate.given(found->fineness)) : Json(nullptr)},
      {"angle_per_step",
       candidate.is_given_angle ? Json(candidate.given(found->fineness)) : Json(nullptr)},
      {"steps", own    ? Json(found->errors.steps)
                : even ? Json(frames.count * found->fineness)
                       : Json(nullptr)},
      {"rejected_steps", own ? Json(found->errors.rejected) : Json(nullptr)},
      {"expected_error", json_of(found->errors, answer.asked.tolerance)},
      {"margin", number(1 / found->errors.of(answer.asked.tolerance))},
      {"nanoseconds_per_simulated_second", found->nanoseconds},
      {"bodies_per_sixtieth", fit * static_cast<double>(answer.bodies)}};
}

}  // namespace

std::string json_of(const Answer& answer) {
  const Options& asked = answer.asked;
  Json question = {
      {"seconds", asked.frames.seconds()},
      {"states_per_second", asked.frames.rate},
      {"wanted_error",
       {{"angle", number(asked.tolerance.angle)}, {"place", number(asked.tolerance.place)}}}};
  if (asked.top) {
    question["moments"] = asked.top->moments;
    question["spin"] = asked.top->spin;
  } else {
    question["scene"] = asked.scene.filename().string();
    question["bodies"] = answer.bodies;
  }
  Json json = {
      {"question", question},
      {"confirmed", answer.verdict.winner.has_value()},
      {"refusal", answer.refusal.empty() ? Json(nullptr) : Json(answer.refusal)},
      {"reference", answer.reference},
      {"reference_uncertainty", json_of(answer.uncertainty, asked.tolerance)},
      {"cheapest", json_of(answer.verdict.winner, answer)},
      {"ten_times_better", json_of(answer.better, answer)},
      {"ten_times_cheaper", json_of(answer.worse, answer)},
      {"least_cost", json_of(answer.least, answer)},
      {"nearest", answer.verdict.winner ? Json(nullptr) : json_of(answer.verdict.nearest, answer)},
      {"others", Json::array()}};
  for (const Found& other : answer.verdict.others)
    json["others"].push_back(json_of(std::optional(other), answer));
  return json.dump(2) + "\n";
}

}  // namespace tumble::advise
