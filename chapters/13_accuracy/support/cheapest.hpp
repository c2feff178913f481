/// @file
/// Which method is the cheapest for a wanted error.
#pragma once

#include <map>
#include <optional>
#include <support/contest.hpp>

namespace tumble::support {

/// The cheapest run of each method that meets `wanted`, in double, the cheapest first.
///
/// An error can be small by luck, where it changes its sign. So a run counts only if the next finer
/// one of the same method, where there is one, meets the tolerance too.
inline std::vector<Measurement> cheapest(const std::vector<Measurement>& all,
                                         const std::string& problem, double wanted) {
  std::map<std::string, Measurement> best;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const Measurement& run = all[n];
    if (run.problem != problem || run.precision != "double" || run.error > wanted) continue;
    const bool has_finer = n + 1 < all.size() && all[n + 1].method == run.method &&
                           all[n + 1].problem == problem && all[n + 1].precision == "double";
    if (has_finer && all[n + 1].error > wanted) continue;
    const auto [place, is_new] = best.try_emplace(run.method, run);
    if (!is_new && run.nanoseconds < place->second.nanoseconds) place->second = run;
  }
  std::vector<Measurement> list;
  for (const auto& [name, run] : best) list.push_back(run);
  std::sort(list.begin(), list.end(), [](const Measurement& a, const Measurement& b) {
    return a.nanoseconds < b.nanoseconds;
  });
  return list;
}

/// The first of a list that pleases.
template <class Predicate>
std::optional<Measurement> first_of(const std::vector<Measurement>& list,
                                    const Predicate& pleases) {
  const auto found = std::find_if(list.begin(), list.end(), pleases);
  return found == list.end() ? std::nullopt : std::optional(*found);
}

inline bool is_rung(const Measurement& run) {
  return run.kind == "rung";
}
/// A method on the unknowns that Odeint gets: all numbers of the state, in the time of the clock.
/// The others first reduce the equations or transform their time.
inline bool is_alike(const Measurement& run) {
  const auto begins = [&](std::string_view words) { return run.method.starts_with(words); };
  return is_rung(run) && !begins("L apart") && !begins("axis apart") && !begins("transformed time");
}
inline bool is_ours(const Measurement& run) {
  return is_rung(run) || run.kind == "exact";
}
/// A run of that library.
inline auto is_of(const std::string& library) {
  return [library](const Measurement& run) { return run.kind == library; };
}

}  // namespace tumble::support
