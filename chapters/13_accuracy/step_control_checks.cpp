#include <functional>
#include <support/checks.hpp>
#include <tumble/embedded_pairs.hpp>
#include <tumble/step_control.hpp>
#include <utility>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A step whose error is what `error_of` says of its length, 1 being allowed.
struct Scripted {
  static constexpr int power = 5;
  std::function<double(double)> error_of;
  std::vector<double> attempts = {}, accepted = {};

  double attempt(double h) {
    attempts.push_back(h);
    if (attempts.size() > 10000) throw std::logic_error("it goes on for ever");
    const double error = error_of(h);
    return error * error;
  }
  void accept() { accepted.push_back(attempts.back()); }
};

template <class Action>
std::string failure_of(const Action& action) {
  try {
    action();
  } catch (const StepError& error) {
    return error.what();
  }
  return "nothing thrown";
}

/// A rough logarithm and a rough power err by 0.045 each, and the logarithm is halved or divided.
const double rough = std::exp2(2 * 0.045);

void check_roughly(double found, double expected) {
  CAPTURE(found);
  CAPTURE(expected);
  CHECK(found <= expected * rough);
  CHECK(found >= expected / rough);
}

/// What a step of length h does to a fast part of the motion, y' = −y: it multiplies it by the
/// first, and estimates its error as the second of its parts.
template <class Pair>
std::pair<double, double> of_fast_part(double h) {
  constexpr auto& rule = Pair::Rule::rule;
  constexpr std::size_t stages = rule.nodes.size();
  std::array<double, stages + 1> rates = {};
  double end = 1;
  for (std::size_t i = 0; i < stages; ++i) {
    double there = 1;
    for (std::size_t j = 0; j < i; ++j)
      there += h * static_cast<double>(rule.coefficients[i][j]) * rates[j];
    rates[i] = -there;
    end += h * static_cast<double>(rule.weights[i]) * rates[i];
  }
  rates[stages] = -end;
  std::array<double, Pair::errors.size()> errors = {};
  for (std::size_t n = 0; n < errors.size(); ++n)
    for (std::size_t j = 0; j <= stages; ++j)
      errors[n] += h * static_cast<double>(Pair::errors[n][j]) * rates[j];
  double error = std::abs(errors[0]);
  if constexpr (errors.size() == 2)
    error *= std::abs(errors[0]) / std::hypot(errors[0], errors[1] / 10);
  return {std::abs(end), error};
}

/// By which powers of the step, near the longest that is stable, the fast part grows and the error
/// for each second does: ρ and ε.
template <class Pair>
std::pair<double, double> powers_at_the_limit() {
  double stable = 1, unstable = 20;
  while (of_fast_part<Pair>(unstable).first < 1) unstable *= 2;
  for (int n = 0; n < 60; ++n) {
    const double middle = (stable + unstable) / 2;
    (of_fast_part<Pair>(middle).first < 1 ? stable : unstable) = middle;
  }
  const double apart = 1e-5;
  const auto [growth, error] = of_fast_part<Pair>(stable * std::exp(apart));
  const auto [less, smaller] = of_fast_part<Pair>(stable * std::exp(-apart));
  return {std::log(growth / less) / (2 * apart), std::log(error / smaller) / (2 * apart) - 1};
}

/// By which factor deviations from the limit of stability grow in a step, in the long run, where
/// the controller weighs the last error by a and the one before by b.
double growth_at_the_limit(double power, std::pair<double, double> powers, double a, double b) {
  const auto [rho, epsilon] = powers;
  // What a step makes of the logarithms of the error, of the one before and of the step.
  Mat3d steps;
  steps << 1 - epsilon * a / power, epsilon * b / power, rho,  //
      1, 0, 0,                                                 //
      -a / power, b / power, 1;
  // Squared again and again: 2^20 steps leave of where they began less than a millionth or so.
  double count = 1, logarithm = 0;
  for (; count < 1e6; count *= 2) {
    const double size = steps.norm();
    logarithm = 2 * (logarithm + std::log(size));
    steps = (steps / size) * (steps / size);
  }
  return std::exp((logarithm + std::log(steps.norm())) / count);
}

/// The same on a smooth stretch: the larger root of z² = (1 − a) z + b.
double growth_where_smooth(double a, double b) {
  return std::abs(1 - a) / 2 + std::sqrt((1 - a) * (1 - a) / 4 + b);
}

/// How many steps of 200 fail, and how long the last is, where a step of length 1 has the error
/// that is allowed and each next one errs by so much more.
std::pair<int, double> on_a_smooth_stretch(int power, double more) {
  StepControl control(power);
  double h = 0.5, error = 1;
  int failed = 0;
  for (int n = 0; n < 200; ++n) {
    const double ratio = error * std::pow(h, power);
    if (ratio > 1)
      ++failed;
    else
      error *= more;
    h *= static_cast<double>(control.factor(static_cast<float>(ratio * ratio)));
  }
  return {failed, h};
}

}  // namespace

TEST_CASE(
    "Where errors are smooth steps settle at 0.58 of the longest, and none is rejected while the "
    "errors of equal steps grow by less than 1/0.85 to the k-th power") {
  const double settled = std::pow(0.85, 1 / 0.3);
  CHECK(std::abs(settled - 0.58) < 0.005);
  for (const int power : {DormandPrince54::power - 1, DormandPrince853::power - 1}) {
    CAPTURE(power);
    const auto [failed, h] = on_a_smooth_stretch(power, 1);
    CHECK(failed == 0);
    // A rough power errs by 0.045, of which the loop makes 0.045/0.3, and a rough digit by half.
    CHECK(std::abs(std::log2(h / settled)) <= 0.045 / 0.3 + 0.0225 / power);
    const double most = std::pow(0.85, -power);
    const double rough_step = std::exp2(0.045 * power + 0.3 * 0.0225);
    CHECK(on_a_smooth_stretch(power, most / rough_step).first == 0);
    CHECK(on_a_smooth_stretch(power, most * rough_step).first > 0);
  }
  CHECK(std::abs(std::pow(0.85, -4) - 1.92) < 0.005);
}

TEST_CASE(
    "At the limit of stability a step's deviation grows if one error is seen, and dies out if two "
    "are") {
  const auto powers = powers_at_the_limit<DormandPrince54>();
  CHECK(std::abs(powers.first - 6.07) < 0.005);
  CHECK(std::abs(powers.second - 4.85) < 0.005);
  CHECK(std::abs(growth_at_the_limit(4, powers, 1, 0) - 1.14) < 0.005);
  CHECK(std::abs(growth_at_the_limit(4, powers, 0.7, 0.4) - 0.71) < 0.005);
  CHECK(std::abs(growth_where_smooth(0.7, 0.4) - 0.8) <= 16 * unit_roundoff<double>);
  CHECK(growth_at_the_limit(7, powers_at_the_limit<DormandPrince853>(), 0.7, 0.4) < 1);
  double best = 1;
  for (double a = 0.02; a < 1.5; a += 0.02)
    for (double b = 0; b < a; b += 0.02)
      best =
          std::min(best, std::max(growth_where_smooth(a, b), growth_at_the_limit(4, powers, a, b)));
  CHECK(std::abs(best - 0.73) < 0.01);
}

TEST_CASE("After a step that failed the next is as long as the order says, less a seventh") {
  for (const int power : {1, 2, 5, 8})
    for (const double error : {1.01, 2.0, 5.0, 100.0}) {
      StepControl control(power);
      const double wanted = 0.85 * std::pow(error, -1.0 / power);
      if (wanted > 0.1 * rough)
        check_roughly(control.factor(static_cast<float>(error * error)), wanted);
    }
  // A step that barely failed counts as failed: the next is not longer, however small its error.
  StepControl failed(5);
  failed.factor(1.5F);
  CHECK(failed.factor(1e-16F) == 1);
  CHECK(StepControl(1).factor(1e20F) == 0.1F);
  for (const float none :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(),
        std::numeric_limits<float>::max()})
    CHECK(StepControl(8).factor(none) == 0.1F);
}

TEST_CASE("After a step that was accepted the error before it counts too") {
  for (const int power : {2, 5, 8}) {
    StepControl control(power);
    double before = 1;  // as if the step before the first had just been allowed
    for (const double error : {0.5, 0.25, 0.9, 0.125, 0.125, 1.0}) {
      const double wanted = 0.85 * std::pow(error, -0.7 / power) * std::pow(before, 0.4 / power);
      check_roughly(control.factor(static_cast<float>(error * error)), wanted);
      before = error;
    }
  }
}

TEST_CASE("Only the error of an accepted step counts as the one before") {
  for (const int power : {2, 5, 8}) {
    StepControl control(power);
    control.factor(0.25F * 0.25F);
    control.factor(1e6F);  // rejected
    check_roughly(control.factor(0.81F),
                  0.85 * std::pow(0.9, -0.7 / power) * std::pow(0.25, 0.4 / power));
  }
}

TEST_CASE(
    "A step grows to six times its length at most, shrinks to a fifth, and rests where one "
    "failed") {
  CHECK(StepControl(1).factor(1e-10F) == 6);
  StepControl shrinking(1);
  shrinking.factor(1e-12F);
  CHECK(shrinking.factor(1) == 0.2F);

  StepControl control(4);
  CHECK(control.factor(16) < 0.9F);
  CHECK(control.factor(1e-16F) == 1);
  CHECK(control.factor(1e-18F) > 1);  // the step before has not failed
  control.factor(std::numeric_limits<float>::infinity());
  CHECK(control.factor(1e-16F) == 1);

  // An error of zero is taken for a billionth, so the next is judged by a finite one.
  StepControl exact(8), nearly(8);
  CHECK(exact.factor(0) == nearly.factor(1e-18F));
  CHECK(exact.factor(0.25F) == nearly.factor(0.25F));
}

TEST_CASE(
    "The first step errs by two to the power of its order, if rates change as they begin to") {
  // rate (h r)^power with r = changes/rate
  for (const int power : {2, 4, 7}) {
    const double rate = 16, changes = 24, h = first_step_of(rate, changes, power, 1e9);
    CHECK(std::abs(rate * std::pow(h * changes / rate, power) / std::exp2(power) - 1) <=
          64 * power * unit_roundoff<double>);
  }
  CHECK(first_step_of(16.0, 24, 4, 0.01) == 0.01);
  CHECK(first_step_of(16.0, 0, 4, 3) == 3);  // where nothing changes, all at once
  CHECK(first_step_of(0.0, 0, 4, 3) == 3);
}

TEST_CASE(
    "An integration accepts what is allowed, counts both kinds of steps, and leaves no tiny last "
    "one") {
  // Where it may: the error is that of a fifth order which 0.25 s just meets.
  const auto fifth_order = [](double h) { return std::pow(h / 0.25, 5); };
  for (double seconds = 0.3; seconds < 3; seconds += 0.0371) {
    CAPTURE(seconds);
    Scripted stepper{fifth_order};
    double told = 0;
    std::size_t count = 0;
    const StepCounts counts =
        integrate_adaptively(stepper, seconds, 0.1, [&](double gone, double h) {
          CHECK(gone == told);
          CHECK(h == stepper.attempts.back());
          CHECK(stepper.accepted.size() == count);  // before it counts
          told += h;
          ++count;
        });
    CHECK(std::abs(told - seconds) <= 100 * unit_roundoff<double> * seconds);
    CHECK(counts.steps == static_cast<long>(stepper.accepted.size()));
    CHECK(counts.steps + counts.rejected == static_cast<long>(stepper.attempts.size()));
    for (const double h : stepper.accepted) CHECK(h <= 0.25);
    if (stepper.accepted.size() > 1) {
      const double last = stepper.accepted.back(), before = *(stepper.accepted.end() - 2);
      CHECK(last >= 0.49 * before);
    }
  }

  Scripted just_allowed{[](double) { return 1.0; }};
  const StepCounts one = integrate_adaptively(just_allowed, 2.0, 2, [](double, double) {});
  CHECK(one.steps == 1);
  CHECK(one.rejected == 0);
  CHECK(just_allowed.attempts == std::vector<double>{2});

  Scripted once_beyond{[](double h) { return h > 1.99 ? 1.1 : 0.01; }};
  const StepCounts two = integrate_adaptively(once_beyond, 2.0, 2, [](double, double) {});
  CHECK(two.rejected == 1);
  CHECK(two.steps == 2);
}

TEST_CASE("An integration that two steps can make is made in two, however its length rounds") {
  // Where the first step and what is left of the integration, each rounded, add up to less, a third
  // step of one rounding would be made.
  long falls_short = 0;
  for (int n = 0; n < 2000; ++n) {
    const double seconds = 1 + n / 2000.0, first = 0.3 * seconds;
    CAPTURE(seconds);
    falls_short += first + (seconds - first) < seconds;
    Scripted easy{[](double) { return 0.0; }};
    CHECK(integrate_adaptively(easy, seconds, first, [](double, double) {}).steps == 2);
  }
  CHECK(falls_short > 0);
}

TEST_CASE("Where no step meets the tolerance, the integration fails with the time that it got to") {
  Scripted wall{[](double) { return 2.0; }};
  CHECK(failure_of([&] {
          integrate_adaptively(wall, 1.0, 0.5, [](double, double) {});
        }).find(" s, 0 s after the start; no step meets the tolerance there") != std::string::npos);
  double reached = 0;
  Scripted later{[&](double h) { return reached + h > 0.75 ? 2.0 : 0.5; }};
  const std::string complaint = failure_of([&] {
    integrate_adaptively(later, 1.0, 0.25, [&](double gone, double h) { reached = gone + h; });
  });
  CHECK(complaint.find("no step meets the tolerance there") != std::string::npos);
  CHECK(reached > 0.74);
  CHECK(reached <= 0.75);
}

TEST_CASE("An integration's time and tolerance are refused by name") {
  const double infinite = std::numeric_limits<double>::infinity(), none = std::nan("");
  CHECK_NOTHROW(require_tolerance(1.0, 1e-3));
  CHECK_NOTHROW(require_tolerance(0.0, 1e-3));
  for (const double seconds : {-1.0, infinite, none})
    CHECK(complaint_of([&] { require_tolerance(seconds, 1e-3); }).find("time is ") == 0);
  for (const double tolerance : {0.0, -1.0, infinite, none})
    CHECK(complaint_of([&] { require_tolerance(1.0, tolerance); }).find("tolerance is ") == 0);
  CHECK_NOTHROW(require_tolerance(1.0, ParticleTolerance<double>{1e-3, 1e-6}));
  for (const double tolerance : {0.0, -1.0, infinite, none}) {
    const ParticleTolerance<double> place{tolerance, 1}, speed{1, tolerance};
    CHECK(complaint_of([&] {
            require_tolerance(1.0, place);
          }).find("tolerance of the position is ") == 0);
    CHECK(complaint_of([&] {
            require_tolerance(1.0, speed);
          }).find("tolerance of the velocity is ") == 0);
  }
}
