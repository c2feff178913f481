#include "advisor.hpp"

#include <cmath>

namespace tumble::advise {
namespace {

/// What is searched for is half of what is wanted: the error of another body like this one, or a
/// step a little longer, is not quite the same.
constexpr double reserve = 2;

/// A method within this factor of the cheapest is worth a line.
constexpr double worth_naming = 4;

}  // namespace

double Advisor::nanoseconds(const Candidate& candidate, long fineness, int repetitions) const {
  return candidate.nanoseconds(fineness, repetitions) / frames_.seconds();
}

/// Doubles the fineness until the error is small enough, then searches in between. Gives up on a
/// method that costs more than `dearest` (ns a second), or whose error has stopped falling although
/// it has made more steps: at a smaller tolerance a method may still make the same ones.
std::optional<Found> Advisor::search(const Candidate& candidate, const Tolerance& tolerance,
                                     double dearest, std::optional<Found>& nearest) const {
  const double limit = std::min(dearest, longest_run_ * 1e9 / frames_.seconds());
  double smallest = std::numeric_limits<double>::infinity();
  int without_gain = 0;
  long high = 1, most_steps = 0;
  Errors errors;
  for (;; high *= 2) {
    const double cost = nanoseconds(candidate, high, 1);
    errors = std::isfinite(cost) ? candidate.errors(high, 0) : failed_run;
    const double ratio = errors.of(tolerance);
    if (ratio < (nearest ? nearest->errors.of(tolerance) : std::numeric_limits<double>::infinity()))
      nearest = Found{&candidate, high, errors, cost};
    if (ratio <= 1 / reserve) break;
    const bool is_finer = !candidate.chooses_steps() || errors.steps > most_steps;
    if (ratio < 0.7 * smallest || ratio > 1e15)
      without_gain = 0;
    else if (is_finer)
      ++without_gain;
    most_steps = std::max(most_steps, errors.steps);
    smallest = std::min(smallest, ratio);
    if (!candidate.takes_steps || without_gain > 3 || cost > limit || high >= candidate.finest)
      return std::nullopt;
  }
  long low = high / 2;  // known not to do
  while (high - low > 1 && high - low > low / 20) {
    const long middle = low + (high - low) / 2;
    (candidate.errors(middle, 0).of(tolerance) <= 1 / reserve ? high : low) = middle;
  }
  return Found{&candidate, high, errors, nanoseconds(candidate, high, 3)};
}

/// Runs it again: the question itself, and others like it. If one is not good enough, with shorter
/// steps.
bool Advisor::confirm(Found& found, const Tolerance& tolerance) const {
  for (int attempt = 0; attempt < 6; ++attempt) {
    Errors errors;
    for (int trial = 0; trial < found.candidate->trials; ++trial)
      errors = worse(errors, found.candidate->errors(found.fineness, trial));
    if (errors.of(tolerance) <= 1) {
      found.errors = errors;
      found.nanoseconds = nanoseconds(*found.candidate, found.fineness, 5);
      return true;
    }
    if (!found.candidate->takes_steps) return false;
    found.fineness += 1 + found.fineness / 5;
  }
  return false;
}

Verdict Advisor::cheapest(const Tolerance& tolerance) const {
  // A high order is soon small, and what is dearer than the best need not be tried to the end.
  std::vector<const Candidate*> tried;
  for (const Candidate& candidate : candidates_) tried.push_back(&candidate);
  std::stable_sort(tried.begin(), tried.end(),
                   [](const Candidate* a, const Candidate* b) { return a->order > b->order; });
  Verdict verdict;
  std::vector<Found> enough;
  double cheapest = std::numeric_limits<double>::infinity();
  std::size_t n = 0;
  for (const Candidate* candidate : tried) {
    tell_(*candidate, ++n, tried.size());
    auto found = search(*candidate, tolerance, worth_naming * cheapest, verdict.nearest);
    if (!found || !confirm(*found, tolerance)) continue;
    enough.push_back(*found);
    cheapest = std::min(cheapest, found->nanoseconds);
  }
  if (enough.empty()) return verdict;
  for (Found& found : enough)  // once more, side by side: the machine may have been busy
    found.nanoseconds =
        std::min(found.nanoseconds, nanoseconds(*found.candidate, found.fineness, 5));
  std::sort(enough.begin(), enough.end(),
            [](const Found& a, const Found& b) { return a.nanoseconds < b.nanoseconds; });
  verdict.winner = enough.front();
  for (const Found& other : enough)
    if (other.candidate != verdict.winner->candidate &&
        other.nanoseconds < worth_naming * verdict.winner->nanoseconds)
      verdict.others.push_back(other);
  return verdict;
}

std::optional<Found> Advisor::best_for(double most_nanoseconds, const Tolerance& tolerance) const {
  std::optional<Found> best;
  for (const Candidate& candidate : candidates_) {
    const double one_step = nanoseconds(candidate, 1, 3);
    if (one_step > most_nanoseconds) continue;
    Found found{&candidate, 1, {}, one_step};
    if (candidate.takes_steps)
      found.fineness = std::min(candidate.finest, static_cast<long>(most_nanoseconds / one_step));
    if (candidate.chooses_steps()) {  // which are not in proportion to the fineness
      const auto cost = [&] {
        return found.nanoseconds = nanoseconds(candidate, found.fineness, 3);
      };
      while (cost() > most_nanoseconds && found.fineness > 1)
        found.fineness -= 1 + found.fineness / 5;
      if (found.nanoseconds > most_nanoseconds) continue;
    } else {
      found.nanoseconds *= static_cast<double>(found.fineness);
    }
    found.errors = candidate.errors(found.fineness, 0);
    if (!(found.errors.of(tolerance) < std::numeric_limits<double>::infinity())) continue;
    if (!best || found.errors.of(tolerance) < best->errors.of(tolerance)) best = found;
  }
  return best;
}

std::optional<Found> Advisor::least(const Tolerance& tolerance) const {
  std::optional<Found> least;
  for (const Candidate& candidate : candidates_) {
    const Errors errors = candidate.errors(1, 0);
    if (!(errors.of(tolerance) < std::numeric_limits<double>::infinity())) continue;
    const double cost = nanoseconds(candidate, 1, 3);
    if (!least || cost < least->nanoseconds) least = Found{&candidate, 1, errors, cost};
  }
  return least;
}

}  // namespace tumble::advise
