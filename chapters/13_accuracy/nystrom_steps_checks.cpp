#include <support/checks.hpp>
#include <tumble/nystrom_pairs.hpp>
#include <tumble/nystrom_steps.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Pair = DormandPrinceNystrom86;

/// A push along one line that depends on the time alone, and what follows from it for a kilogram
/// that stands still at the origin when the time is 0: x'' = t^power.
struct PointPushInTime {
  int power;
  void operator()(Particled& particle, double time) const {
    const double push = std::pow(time, power);
    particle.force = {push, 2 * push, -2 * push};
  }
};

Particled at(const PointPushInTime& push, double time) {
  const double v = std::pow(time, push.power + 1) / (push.power + 1),
               x = v * time / (push.power + 2);
  return make_particle<double>(1, {x, 2 * x, -2 * x}, {v, 2 * v, -2 * v});
}

void check_is(const Particled& found, const Particled& truth) {
  CHECK(distance(found.position, truth.position) <= 1e3 * unit_roundoff<double>);
  CHECK(distance(found.velocity, truth.velocity) <= 1e3 * unit_roundoff<double>);
}

}  // namespace

TEST_CASE(
    "Under a push that is a polynomial of time Nyström's pair steps exactly, whenever it begins") {
  const PointPushInTime push{6};  // positions of the eighth power of the time
  for (const double begin : {0.0, 1.0, -0.5}) {
    NystromSteps<Pair, PointPushInTime, double> steps(at(push, begin), push, begin, {1e-3, 1e-3});
    double time = begin;
    for (const double h : {0.5, 0.25, 0.375}) {
      steps.attempt(2 * h);  // not accepted: leaves no trace
      steps.attempt(h);
      steps.accept();
      time += h;
      check_is(steps.body(), at(push, time));
    }
  }
}

TEST_CASE(
    "Nyström's first step is that of an oscillation, where rates and their change are known") {
  // x'' = -x: the rates (v, -x) change at the rates (-x, -v), which have the same size.
  const auto spring = [](Particled& particle, double) { particle.force = -particle.position; };
  const auto start = make_particle<double>(1, {1, 4, 8}, {3, 4, 12});
  const double rate = std::sqrt(81.0 + 169.0) / 1e-3;
  using Steps = NystromSteps<Pair, decltype(spring), double>;
  Steps steps(start, spring, 0.0, {1e-3, 1e-3});
  // The change is a difference of rates a ten-thousandth of a second apart.
  CHECK(std::abs(steps.first_step(1) / (2 * std::pow(rate, -1.0 / Steps::power)) - 1) <=
        1e5 * unit_roundoff<double>);

  // x'' = t from 3 s on: the rates (v, 3), 4.5 and 3, change at the rates 3 and 1, on three axes.
  const PointPushInTime push{1};
  NystromSteps<Pair, PointPushInTime, double> pushed(at(push, 3), push, 3.0, {1e-3, 1e-3});
  const double expected = first_step_of(3 * std::hypot(4.5, 3) / 1e-3,
                                        3 * std::hypot(3.0, 1.0) / 1e-3, Steps::power, 10.0);
  CHECK(std::abs(pushed.first_step(10) / expected - 1) <= 1e-3);

  // Where the tolerance is nothing, what is always allowed is measured by the size: 9 m and 13 m/s.
  Steps strict(start, spring, 0.0, {1e-40, 1e-40});
  const double always = 4 * std::numeric_limits<double>::epsilon();
  const double strict_rate = std::hypot(13 / (always * 9), 9 / (always * 13)),
               strict_change = std::hypot(9 / (always * 9), 13 / (always * 13));
  CHECK(
      std::abs(strict.first_step(1) / first_step_of(strict_rate, strict_change, Steps::power, 1.0) -
               1) <= 1e-9);
}

TEST_CASE(
    "A Nyström integration leaves the push of the moment that it reaches, and refuses what is "
    "none") {
  const PointPushInTime push{2};
  auto body = at(push, 1);
  const StepCounts counts = integrate_by_nystrom<Pair>(body, push, 1.0, 2, {1e-6, 1e-6});
  CHECK(counts.steps > 0);
  check_is(body, at(push, 3));
  CHECK(body.force.x() == 9);
  CHECK(complaint_of([&] {
          integrate_by_nystrom<Pair>(body, push, 0.0, -1, {1e-6, 1e-6});
        }) == "time is -1 s; it must be 0 or more");
  CHECK(complaint_of([&] {
          integrate_by_nystrom<Pair>(body, push, 0.0, 1, {1e-6, -1e-6});
        }).find("tolerance of the velocity is -1e-06 m/s a second") == 0);
}

TEST_CASE("A Nyström step's error counts in what its tolerance allows for its time") {
  // An error falls as h^7, and a tolerance a hundred times smaller is missed a hundred times more.
  const auto spring = [](Particled& particle, double) { particle.force = -particle.position; };
  const auto start = make_particle<double>(1, {1, 0, 0}, {0, 1, 0});
  NystromSteps<Pair, decltype(spring), double> loose(start, spring, 0.0, {1e-2, 1e-2}),
      tight(start, spring, 0.0, {1e-4, 1e-4});
  const double error = std::sqrt(loose.attempt(1.0));
  CHECK(std::abs(std::sqrt(tight.attempt(1.0)) / error / 100 - 1) <= 1e-6);
  const double half = std::sqrt(loose.attempt(0.5));
  CHECK(error / half >= 40);  // 2^6 for each second, less what the next order takes
  CHECK(error / half <= 90);
}

TEST_CASE(
    "Where the tolerance is nothing an error counts as a part of the place or the velocity "
    "at the start") {
  // Far beyond the order of the pair: the errors of place and velocity are of h^11 and h^10.
  const PointPushInTime push{9};
  const auto exponent = [&](double place, double velocity) {
    const auto error = [&](double h) {
      NystromSteps<Pair, PointPushInTime, double> steps(
          make_particle<double>(1, {place, 0, 0}, {velocity, 0, 0}), push, 0.0, {1e-40, 1e-40});
      return std::sqrt(steps.attempt(h));
    };
    return std::log2(error(1) / error(0.5));
  };
  CHECK(std::abs(exponent(1, 1e30) - 11) <= 1e-9);  // the velocity's error is nothing beside 1e30
  CHECK(std::abs(exponent(1e30, 1) - 10) <= 1e-9);
}
