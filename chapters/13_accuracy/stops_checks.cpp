#include <support/checks.hpp>
#include <support/problems.hpp>
#include <tumble/nystrom_steps.hpp>
#include <tumble/reduced_steps.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A push or a torque along x that acts from 5.3 s on for so long, and is there at its beginning
/// and no longer at its end.
struct Blow {
  double seconds, strength = 1 / seconds;  // 1 N s or N m s altogether
  Stops<double> stops() const { return {.events = {5.3, 5.3 + seconds}}; }
  double at(double time) const { return time >= 5.3 && time < 5.3 + seconds ? strength : 0; }
  void operator()(Particled& particle, double time) const { particle.force = {at(time), 0, 0}; }
  void operator()(Topd& top, double time) const { top.torque = {at(time), 0, 0}; }
  Vec3d torque_on_axis(const Vec3d&, double time) const { return {at(time), 0, 0}; }
  /// How far a kilogram or one kg m² at rest is pushed or turned by 10 s.
  double reached() const { return 4.7 - seconds / 2; }
};

double turned(const Topd& top) {
  return angle_between(top.orientation, Quaternion<double>{});
}

}  // namespace

TEST_CASE(
    "A blow between two events is not missed, however short it is and whatever the tolerance") {
  const Topd resting{.inverse_moments = {1, 1, 0.5}};
  const auto at_rest = make_particle<double>(1, {0, 0, 0}, {0, 0, 0});
  for (const double seconds : {0.01, 0.1})
    for (const double tolerance : {1e-4, 1e-9}) {
      const Blow blow{seconds};
      // A rotation vector of 4.7 rad is a turn by 2 pi - 4.7. The push is a constant, for which
      // each pair is exact, and a few roundings a second are allowed besides.
      const double angle = 2 * std::numbers::pi - blow.reached(), allowed = 10 * tolerance;
      const auto check = [&](const auto& carried) {
        Topd blind = resting, seeing = resting;
        CHECK(carried(blind, Stops<double>{}).steps == 1);
        CHECK(turned(blind) == 0);  // the blow was between two stages
        const StepCounts counts = carried(seeing, blow.stops());
        CHECK(std::abs(turned(seeing) - angle) <= allowed);
        CHECK(counts.rejected < counts.steps);
      };
      check([&](Topd& top, const Stops<double>& stops) {
        return integrate<DormandPrince54>(top, blow, 0.0, 10, tolerance, stops);
      });
      check([&](Topd& top, const Stops<double>& stops) {
        return integrate<DormandPrince853>(top, blow, 0.0, 10, tolerance, stops);
      });
      check([&](Topd& top, const Stops<double>& stops) {
        return integrate_axis<DormandPrince54>(top, blow, 0.0, 10, tolerance, stops);
      });
      for (const bool by_nystrom : {false, true}) {
        Particled pushed = at_rest;
        if (by_nystrom)
          integrate_by_nystrom<DormandPrinceNystrom86>(pushed, blow, 0.0, 10,
                                                       {tolerance, tolerance}, blow.stops());
        else
          integrate<DormandPrince54>(pushed, blow, 0.0, 10, {tolerance, tolerance}, blow.stops());
        CHECK(std::abs(pushed.position.x() - blow.reached()) <= allowed);
        CHECK(std::abs(pushed.velocity.x() - 1) <= allowed);
        CHECK(pushed.force.x() == 0);
      }
    }
}

TEST_CASE("No step is longer than the longest, and one that jumps asks for an event") {
  // A push that swells and ebbs between 5.3 s and 5.4 s, 1 N s altogether.
  const auto swell = [](Particled& particle, double time) {
    const double phase = std::clamp((time - 5.3) / 0.1, 0.0, 1.0);
    particle.force = {10 * (1 - std::cos(2 * std::numbers::pi * phase)), 0, 0};
  };
  const auto start = make_particle<double>(1, {0, 0, 0}, {0, 0, 0});
  Particled blind = start, seeing = start;
  CHECK(integrate<DormandPrince54>(blind, swell, 0.0, 10, {1e-6, 1e-6}).steps == 1);
  CHECK(blind.velocity.x() == 0);
  const StepCounts counts =
      integrate<DormandPrince54>(seeing, swell, 0.0, 10, {1e-6, 1e-6}, {.longest = 0.05});
  CHECK(counts.steps >= 200);
  CHECK(std::abs(seeing.velocity.x() - 1) <= 10 * 1e-6);
  CHECK(std::abs(seeing.position.x() - 4.65) <= 10 * 10 * 1e-6);  // what v lost, for ten seconds

  Particled jumping = start;
  CHECK_THROWS_WITH_AS(
      integrate<DormandPrince54>(jumping, Blow{0.1}, 0.0, 10, {1e-6, 1e-6}, {.longest = 0.05}),
      doctest::Contains("no step meets the tolerance there; if a force jumps, name an event"),
      StepError);
}

TEST_CASE("An integration stops at events inside it alone, and refuses those that are none") {
  std::vector<double> begins, lengths, lasts;
  const auto nothing = [](Topd&, double) {};
  const auto legs = [&](const Stops<double>& stops) {
    begins.clear(), lengths.clear(), lasts.clear();
    Topd top;
    return in_legs(top, nothing, 2.0, 8, stops,
                   [&](Topd&, const auto& leg, double begin, double length) {
                     CHECK(leg.inside(0) == begin);
                     CHECK(leg.inside(begin + length / 2) == begin + length / 2);
                     begins.push_back(begin), lengths.push_back(length);
                     lasts.push_back(leg.inside(20));
                     return StepCounts{.steps = 1, .rejected = 2};
                   });
  };
  using List = std::vector<double>;
  const auto before = [](double event) { return std::nextafter(event, 0.0); };
  const StepCounts one = legs({});
  CHECK(begins == List{2});
  CHECK(lengths == List{8});
  CHECK(lasts == List{10});
  CHECK(one.steps == 1);
  const StepCounts three = legs({.events = {1, 2, 3, 7, 11}});
  CHECK(begins == List{2, 3, 7});
  CHECK(lengths == List{1, 4, 3});
  CHECK(lasts == List{before(3), before(7), 10});
  CHECK(three.steps == 3);
  CHECK(three.rejected == 6);
  legs({.events = {3, 10}});  // what begins at the end is not part of it
  CHECK(lasts == List{before(3), before(10)});
  CHECK(complaint_of([&] {
          legs({.events = {3, 3}});
        }) == "event is 3 s; it must be later than the one before");
  CHECK(complaint_of([&] { legs({.events = {INFINITY}}); }) == "event is inf s; it must be finite");
  CHECK(complaint_of([&] { legs({.longest = 0}); }) ==
        "longest step is 0 s; it must be greater than 0");
  CHECK(complaint_of([&] { legs({.longest = NAN}); }) ==
        "longest step is nan s; it must be greater than 0");
}

TEST_CASE("An integration without events is as long as was said, however late it begins") {
  const auto push = [](Particled& particle, double) { particle.force = {1, 0, 0}; };
  auto late = make_particle<double>(1, {0, 0, 0}, {1, 0, 0});
  integrate<DormandPrince54>(late, push, 1e9, 0.01, {1e-6, 1e-6});
  // The clock counts in 1.2e-7 s there; one step of some ten roundings.
  CHECK(std::abs(late.position.x() - (0.01 + 0.01 * 0.01 / 2)) <= 10 * unit_roundoff<double>);
}

TEST_CASE("An integration that fails after an event leaves its body where it was") {
  const auto start = make_particle<double>(1, {0, 0, 0}, {1e-9, 0, 0});
  Particled body = start;
  CHECK_THROWS_AS(integrate<DormandPrince54>(body, Blow{0.1}, 0.0, 10, {1e-6, 1e-6},
                                             {.events = {3}, .longest = 0.03}),
                  StepError);
  CHECK(same_bits(body.position, start.position));
}
