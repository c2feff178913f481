// Steps that choose themselves, and five ways to spoil them.
#include <support/exact_motion.hpp>
#include <support/problems.hpp>
#include <support/record.hpp>
#include <tumble/embedded_steps.hpp>
#include <tumble/reduced_steps.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A pair that asks what seven numbers err by, all alike, instead of an angle and a part of |L|.
//! [seven]
struct SevenNumbers {
  static constexpr int power = 4;
  double attempt(double h) {
    step = h;
    evaluate_stages<DormandPrinceFifth>(start, h, rates, [&](const auto& numbers, double, auto) {
      return rates_of(numbers, inverse);
    });
    end = combine<RowOfStep<DormandPrinceFifth>>(start, h, rates);
    rates[6] = rates_of(end, inverse);
    double square = 0;
    for (const double off : weighed<RowOf<DormandPrince54::errors, 0>>(rates)) square += off * off;
    return square / (tolerance * tolerance);
  }
  //! [seven]
  void accept() {
    start = end;
    rates[0] = rates[6];
  }
  Vec3d inverse;
  double tolerance, step = 0;
  StateVector<double, 7> start, end = {};
  std::array<StateVector<double, 7>, 7> rates = {rates_of(start, inverse)};
};

/// How many steps a top takes whose moments are `scale` times those of problem A, by the right and
/// by the wrong measure.
std::array<long, 2> steps_of_scaled(double scale) {
  Topd top = free_problems<double>()[0].start;
  top.inverse_moments /= scale;
  top.angular_momentum_body *= scale;
  SevenNumbers steps{top.inverse_moments, 1e-6, 0, state_of(top)};
  const StepCounts wrong = integrate_adaptively(steps, 1.0, 1e-3, [](double, double) {});
  return {integrate_free_top<DormandPrince54>(top, 1, 1e-6).steps, wrong.steps};
}

/// Steps of a pair with a tolerance in rad a step, where it should be rad a second.
//! [per_step]
template <class Steps>
struct PerStep {
  static constexpr int power = Steps::power + 1;  // the error of a step falls by one order more
  double attempt(double h) { return steps.attempt(h) * h * h; }  // (error/(τ h))² h²
  void accept() { steps.accept(); }
  Steps steps;
};
//! [per_step]

/// What a free top errs by in a second, rad, if it spins `faster` times as fast as in problem A,
/// and a millionth is allowed in each step or in each second.
template <bool per_step>
double error_of_spin(double faster) {
  const auto problem = free_problems<double>()[0];
  using Motion = FreeTurn<double>;
  using Steps = ReducedSteps<DormandPrince54, Motion, double>;
  Topd top = problem.start;
  top.angular_momentum_body *= faster;
  Steps steps(Motion(top), 0, 1e-6);
  const auto truth = exactly_after(exactly(problem.evaluate_forces), exactly(top), 1.0L);
  const auto pass = [](double, double) {};
  if constexpr (per_step) {
    PerStep<Steps> all{steps};
    integrate_adaptively(all, 1.0, 1e-4, pass);
    top = all.steps.body();
  } else {
    integrate_adaptively(steps, 1.0, 1e-4, pass);
    top = steps.body();
  }
  return static_cast<double>(angle_between(truth.orientation, exactly(top).orientation));
}

/// The errors of faster and faster tops, by both tolerances.
void write_spins(Notebook& notebook) {
  Table table = notebook.table("spoilt_steps_spins", {"times as fast", "a second", "a step"});
  std::array<double, 2> slow{}, fast{};  // by a tolerance for each second, and for each step
  for (const double faster : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    fast = {error_of_spin<false>(faster), error_of_spin<true>(faster)};
    if (faster == 1) slow = fast;
    table.row(faster, fast[0], fast[1]);
  }
  std::printf(
      "A top, and one that spins a thousand times as fast, off after a second:\n%.0e and %.0e rad "
      "with a tolerance for each second, %.0e and %.0e rad with one for each step.\n",
      slow[0], fast[0], slow[1], fast[1]);
  notebook.value("second_slow", number("%.0e", slow[0]));
  notebook.value("second_fast", number("%.0e", fast[0]));
  notebook.value("step_slow", number("%.0e", slow[1]));
  notebook.value("step_fast", number("%.0e", fast[1]));
  expect(fast[0] < 1e-6, "a tolerance for each second bounds what is added in a second");
  expect(fast[1] > 1e-5 && fast[1] > 100 * slow[1],
         "with a tolerance for each step a faster top errs by more, since it takes more of them");
}

/// A step that was tried: how long it was (s), and whether it counted.
struct Attempt {
  double length;
  bool is_accepted;
};

/// What is tried on a particle that a strong damper stops at once: what is left moves slowly, but a
/// step may be no longer than the damper allows. The controller sees two errors, or one.
std::vector<Attempt> with_damper(bool remembers) {
  const auto damper = [](Particled& particle, double time) {
    particle.force = -1000 * (particle.velocity - Vec3d(std::cos(time), 0, 0));
  };
  using Steps = EmbeddedSteps<DormandPrince54, Particled, decltype(damper), double>;
  Steps steps(make_particle(1.0, {0, 0, 0}, {1, 0, 0}), damper, 0, {1e-2, 1e-2});
  StepControl control(Steps::power);
  std::vector<Attempt> attempts;
  for (double gone = 0, h = 1e-3; gone < 2;) {
    const auto square = static_cast<float>(steps.attempt(h));
    attempts.push_back({h, square <= 1});
    if (square <= 1) {
      steps.accept();
      gone += h;
    }
    const double forgetful = std::clamp(0.85 * std::pow(square, -0.5 / Steps::power), 0.1, 6.0);
    h *= remembers ? static_cast<double>(control.factor(square)) : forgetful;
  }
  return attempts;
}

/// The attempts of both controllers, of which the figure shows a stretch; how many of the one's
/// and of the other's were rejected.
void write_hunting(Notebook& notebook) {
  const std::vector<Attempt> two = with_damper(true), one = with_damper(false);
  Table table = notebook.table("spoilt_steps_hunting",
                               {"attempt", "one error (s)", "is it accepted", "two errors (s)"});
  for (std::size_t n = 100; n < 150; ++n)
    table.row(static_cast<double>(n), one[n].length, one[n].is_accepted ? 1.0 : 0.0, two[n].length);
  const auto rejected = [](const std::vector<Attempt>& all) {
    return std::count_if(all.begin(), all.end(), [](const Attempt& a) { return !a.is_accepted; });
  };
  const auto calm = rejected(two), hunting = rejected(one);
  const auto calm_steps = std::ssize(two) - calm, hunting_steps = std::ssize(one) - hunting;
  std::printf(
      "A strong damper: %td steps and %td rejected by the controller that remembers,\n%td and "
      "%td by one that does not.\n",
      calm_steps, calm, hunting_steps, hunting);
  notebook.value("hunting_rejected", std::to_string(hunting));
  notebook.value("hunting_steps", std::to_string(hunting_steps));
  expect(hunting > 3 * calm && hunting > 20, "a controller without a memory hunts");
}

/// A resting top that is struck after 5.3 s, for a twentieth of a second.
//! [blow]
struct Blow {
  void operator()(Topd& top, double time) const {
    top.torque = {0, 0, time >= 5.3 && time < 5.35 ? 20.0 : 0.0};
  }
};
constexpr double moment = 3, turned = 20 * 0.05 / moment * (10 - 5.325);  // rad, after 10 s
//! [blow]

/// What the top is off by in the end, rad, and in how many steps.
std::pair<double, long> off_after_blow(double tolerance, const Stops<double>& stops) {
  Topd top{.inverse_moments = {1, 0.5, 1 / moment}};
  const long steps = integrate<DormandPrince54>(top, Blow(), 0.0, 10, tolerance, stops).steps;
  return {angle_between(top.orientation, quaternion_about<double>(Vec3d::UnitZ(), turned)), steps};
}

void write_blow(Notebook& notebook) {
  std::pair<double, long> without, with;
  for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
    without = off_after_blow(tolerance, {});
    with = off_after_blow(tolerance, {.events = {5.3, 5.35}});
    expect(without.second == 1 && without.first > 1.5, "a blow between two stages is missed");
    expect(with.first < 10 * tolerance, "with its events it is not");
  }
  std::printf(
      "A top that is struck: off by %.1f rad in %ld step, with events by %.0e rad in %ld.\n",
      without.first, without.second, with.first, with.second);
  notebook.value("blow_blind", number("%.1f", without.first));
  notebook.value("blow_seeing", number("%.0e", with.first));
  notebook.value("blow_steps", std::to_string(with.second));
  try {
    off_after_blow(1e-6, {.longest = 0.01});
    expect(false, "a jump inside a step asks for an event");
  } catch (const StepError& error) {
    notebook.value("blow_refused", error.what());
  }
}

/// Beyond the end: the loop stops after the step that has passed it.
void write_beyond(Notebook& notebook) {
  const auto orbit = eccentric_orbit<double>();
  using Steps = EmbeddedSteps<DormandPrince54, Particled, Star<double>, double>;
  Steps beyond(orbit.start, orbit.evaluate_forces, 0, {1e-6, 1e-6});
  double gone = 0, h = 1e-3;
  StepControl control(Steps::power);
  while (gone < orbit.seconds) {
    const auto square = static_cast<float>(beyond.attempt(h));
    if (square <= 1) {
      beyond.accept();
      gone += h;
    }
    h *= static_cast<double>(control.factor(square));
  }
  const Particled there = exactly_after(orbit.evaluate_forces, orbit.start, orbit.seconds);
  const double off = (beyond.body().position - there.position).norm();
  std::printf("A run that stops after the step that passes the end: %.3f s too late, %.1e m off.\n",
              gone - orbit.seconds, off);
  notebook.value("beyond_late", number("%.3f", gone - orbit.seconds));
  notebook.value("beyond_off", number("%.0e", off));
  expect(off > 1e-3, "a step that lands beyond the end");
}

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  const auto small = steps_of_scaled(1), large = steps_of_scaled(1e6);
  std::printf(
      "A top and one with a million times its inertia, steps in a second: %ld and %ld by an "
      "angle,\n%ld and %ld by seven numbers alike.\n",
      small[0], large[0], small[1], large[1]);
  notebook.value("angle_small", std::to_string(small[0]));
  notebook.value("seven_small", std::to_string(small[1]));
  notebook.value("seven_large", std::to_string(large[1]));
  expect(small[0] == large[0] && large[1] > 5 * small[1],
         "an angle knows no units, and seven numbers do");

  write_spins(notebook);
  write_hunting(notebook);
  write_blow(notebook);
  write_beyond(notebook);
}
