// A comet's round by a pair that chooses its steps, live: where each step ends, how long it lasts,
// and which were rejected.
#include <numbers>
#include <support/live.hpp>
#include <support/problems.hpp>
#include <tumble/embedded_steps.hpp>
#include <tumble/sine_cosine.hpp>

using namespace tumble;

namespace {

using Pull = support::Star<double>;
using Pair = EmbeddedSteps<DormandPrince54, Particled, Pull, double>;

/// The pair, which notes what it tried in vain.
struct WatchedPair : Pair {
  using Pair::Pair;
  double attempt(double h) {
    const double square = Pair::attempt(h);
    if (!(square <= 1)) rejected.push_back({gone, h});
    return square;
  }
  std::vector<std::array<double, 2>> rejected;  ///< when, and for how long, s
  double gone = 0;                              ///< s
};

}  // namespace

void tumble::support::run_live(Live& live) {
  const double e = live.knob("eccentricity", "", 0.8, 0, 0.96);
  const double tolerance = live.knob("tolerance", "m/s", 1e-4, 1e-9, 1e-2);
  // Semi-major axis 1 m around 1 m³/s², from the farthest point on: a round of 2π s.
  constexpr double round = 2 * std::numbers::pi;
  const Vec3d far_end(-1 - e, 0, 0);
  const Particled comet = make_particle(1.0, far_end, {0, -std::sqrt((1 - e) / (1 + e)), 0});

  std::vector<double>&x = live.column("x", "m"), &y = live.column("y", "m"),
  &time = live.column("time", "s"), &step = live.column("step", "s"),
  &distance = live.column("distance", "m"), &tried_at = live.column("tried at", "s"),
  &tried = live.column("tried", "s");
  const Pull star{1};
  WatchedPair steps(comet, star, 0.0, {tolerance, tolerance});
  const auto note = [&](double now) {
    const Vec3d place = steps.body().position;
    time.push_back(now);
    x.push_back(place.x());
    y.push_back(place.y());
    distance.push_back(place.norm());
  };
  note(0);
  // About the longest that the tolerance allows, whose error a second falls as the fourth power.
  integrate_adaptively(steps, round, std::sqrt(std::sqrt(tolerance)), [&](double gone, double h) {
    if (gone > 0) note(gone);
    step.push_back(h);
    steps.gone = gone + h;
  });
  note(round);
  for (const auto& [when, length] : steps.rejected) {
    tried_at.push_back(when);
    tried.push_back(length);
  }
  live.column("missed", "m").push_back((steps.body().position - far_end).norm());

  std::vector<double>&ellipse_x = live.column("ellipse x", "m"),
  &ellipse_y = live.column("ellipse y", "m");
  for (int n = 0; n <= 120; ++n) {
    const auto [sine, cosine] = sine_cosine(round * n / 120);
    ellipse_x.push_back(-e - cosine);
    ellipse_y.push_back(-std::sqrt(1 - e * e) * sine);
  }
}
