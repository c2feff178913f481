#include <random>
#include <support/added_up_time.hpp>
#include <support/checks.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/step_clock.hpp>
#include <utility>

using namespace tumble;
using namespace tumble::support;

namespace {

const std::int64_t millisecond = 1'000'000, second = 1'000'000'000;

/// Both sides of the books, modulo 2⁶⁴, in which nothing overflows.
bool balanced(const StepClock& clock) {
  const auto exact = [](std::int64_t number) { return static_cast<std::uint64_t>(number); };
  return exact(clock.time_in - clock.dropped_time) * exact(clock.step.denominator) ==
             exact(clock.steps + clock.dropped_steps) * exact(clock.step.numerator) +
                 exact(clock.remainder) &&
         clock.remainder >= 0 && clock.remainder < clock.step.numerator;
}

std::vector<StepLength> step_lengths() {
  return {steps_per_second(60),
          steps_per_second(1),
          steps_per_second(59),
          steps_per_second(1000),
          steps_per_second(144),
          steps_per_second(1'000'000),
          step_of_nanoseconds(12'300'000),
          step_of_nanoseconds(1001)};
}

}  // namespace

TEST_CASE("As many steps as were asked for last a second, in lowest terms") {
  for (std::int64_t rate = 1; rate <= 1'000'000; ++rate) {
    const StepLength step = steps_per_second(rate);
    REQUIRE(step.numerator * rate == 1'000'000'000 * step.denominator);
    std::int64_t divisor = step.numerator, rest = step.denominator;  // by Euclid, with divisions
    while (rest != 0) divisor = std::exchange(rest, divisor % rest);
    REQUIRE(divisor == 1);
  }
}

TEST_CASE("Time in is what was simulated, dropped and left over, exactly, in integers") {
  std::mt19937_64 generator(10);
  for (const StepLength& step : step_lengths()) {
    CAPTURE(step.numerator);
    StepClock clock = make_step_clock(step);
    std::int64_t time_in = 0, handed_out = 0;
    for (int n = 0; n < 20'000; ++n) {
      // From nothing to some seconds, short frames more often.
      const auto frame = static_cast<std::int64_t>(generator() % (1ull << (generator() % 33)));
      const StepClock before = clock;
      const std::int64_t due = steps_due(clock, frame);
      time_in += frame;
      handed_out += due;
      REQUIRE(due >= 0);
      REQUIRE(due <= clock.most_steps);
      REQUIRE(clock.dropped_time - before.dropped_time ==
              std::max<std::int64_t>(0, frame - clock.longest_frame));
      REQUIRE(balanced(clock));
    }
    CHECK(clock.time_in == time_in);
    CHECK(clock.steps == handed_out);
    CHECK(clock.dropped_time > 0);
  }
}

TEST_CASE("Without drops the steps do not depend on how the time is cut into frames") {
  std::mt19937_64 generator(11);
  const std::int64_t whole = 10 * second;
  for (const StepLength& step : step_lengths()) {
    CAPTURE(step.numerator);
    StepClock clock = make_step_clock(step, second, 1'000'000);
    for (std::int64_t rest = whole; rest > 0;) {
      const std::int64_t frame =
          std::min(rest, static_cast<std::int64_t>(1 + generator() % 50'000'000));
      steps_due(clock, frame);
      rest -= frame;
    }
    CHECK(clock.steps == whole * step.denominator / step.numerator);
    CHECK(clock.remainder == whole * step.denominator % step.numerator);
    CHECK(clock.dropped_steps == 0);
    CHECK(clock.dropped_time == 0);
  }
}

TEST_CASE("A frame of five seconds takes the cap's steps, and the rest is counted") {
  StepClock clock = make_step_clock(steps_per_second(60));
  CHECK(steps_due(clock, 5 * second) == 8);
  CHECK(clock.time_in == 5 * second);
  CHECK(clock.dropped_time == 4750 * millisecond);  // beyond 0.25 s
  CHECK(clock.dropped_steps == 7);                  // of the 15 in 0.25 s
  CHECK(clock.remainder == 0);
  CHECK(balanced(clock));
  CHECK(std::abs(dropped_time<double>(clock) - (4.75 + 7.0 / 60)) < 1e-14);
  CHECK(std::abs(simulated_time<double>(clock) - 8.0 / 60) < 1e-16);

  // And the frame after it is like any other.
  CHECK(steps_due(clock, 17 * millisecond) == 1);
  CHECK(clock.dropped_steps == 7);

  StepClock by_time = make_step_clock(steps_per_second(60), 100 * millisecond, 1'000'000);
  CHECK(steps_due(by_time, 5 * second) == 6);
  CHECK(by_time.dropped_time == 4900 * millisecond);
  StepClock by_steps = make_step_clock(steps_per_second(60), 3600 * second, 4);
  CHECK(steps_due(by_steps, 5 * second) == 4);
  CHECK(by_steps.dropped_steps == 296);
  CHECK(by_steps.dropped_time == 0);
}

TEST_CASE("An hour of 144 frames a second has exactly 216000 steps of a sixtieth") {
  StepClock clock = make_step_clock(steps_per_second(60));
  for (int n = 0; n < 3600 * 144; ++n)
    // Frames of whole nanoseconds that end when the exact ones would, to the nanosecond.
    steps_due(clock, (n + 1) * second / 144 - n * second / 144);
  CHECK(clock.time_in == 3600 * second);
  CHECK(clock.steps == 216'000);
  CHECK(clock.remainder == 0);
}

TEST_CASE("A clock that nobody has set steps 60 times a second, for frames of 0.25 s and 8 steps") {
  const StepClock clock, made = make_step_clock(steps_per_second(60));
  for (const StepClock& by_default : {clock, made}) {
    CHECK(by_default.step.numerator == 50'000'000);
    CHECK(by_default.step.denominator == 3);
    CHECK(by_default.longest_frame == 250 * millisecond);
    CHECK(by_default.most_steps == 8);
  }
}

TEST_CASE(
    "A step given in parts of a nanosecond may last an hour to the last part, and no longer") {
  const std::int64_t hour = 3600 * second;
  for (const std::int64_t denominator : {std::int64_t(1), std::int64_t(3), std::int64_t(1000)}) {
    const auto complaint = [&](std::int64_t numerator) {
      return complaint_of([&] { require_step_length({numerator, denominator}, 1); });
    };
    CHECK(complaint(hour * denominator) == "nothing thrown");
    CHECK(complaint(hour * denominator + 1).find("numerator of the step is ") == 0);
    // What the shortest may be is for the caller to say: a world may stand still.
    for (const std::int64_t shortest : {std::int64_t(0), std::int64_t(5)}) {
      const auto from = [&](std::int64_t numerator) {
        return complaint_of([&] { require_step_length({numerator, denominator}, shortest); });
      };
      CHECK(from(shortest) == "nothing thrown");
      CHECK(from(shortest - 1)
                .find("numerator of the step is " + std::to_string(shortest - 1) +
                      " ns; it must lie between " + std::to_string(shortest)) == 0);
    }
  }
}

TEST_CASE("A step's length is exact in lowest terms, and its time step is rounded once") {
  CHECK(steps_per_second(60).numerator == 50'000'000);
  CHECK(steps_per_second(60).denominator == 3);
  CHECK(steps_per_second(1000).numerator == 1'000'000);
  CHECK(steps_per_second(1000).denominator == 1);
  CHECK(time_step_of<double>(steps_per_second(60)) == 1.0 / 60);
  CHECK(time_step_of<float>(steps_per_second(60)) == 1.0f / 60);
  CHECK(time_step_of<double>(step_of_nanoseconds(12'300'000)) == 0.0123);
  // 1 and the rate are exact, and one division is rounded once.
  int otherwise = 0, rounded_twice = 0;
  for (int rate = 1; rate <= 1'000'000; ++rate) {
    const StepLength step = steps_per_second(rate);
    otherwise += step.numerator * rate != step.denominator * 1'000'000'000;
    otherwise += time_step_of<double>(step) != 1 / double(rate);
    rounded_twice += static_cast<double>(1 / static_cast<long double>(rate)) != 1 / double(rate);
    otherwise += time_step_of<float>(step) != 1 / static_cast<float>(rate);
  }
  CHECK(otherwise == 0);
  if (std::numeric_limits<long double>::digits == 64) CHECK(rounded_twice == 365);
  StepClock clock = make_step_clock(steps_per_second(60));
  CHECK(steps_due(clock, 20 * millisecond) == 1);
  // 20 ms are a step of 16.67 ms and a fifth of the next.
  CHECK(std::abs(fraction_of_step<double>(clock) - 0.2) < 1e-15);
  // A quarter of a step is one, however long the step.
  for (const StepLength& quartered :
       {steps_per_second(50), steps_per_second(1000), step_of_nanoseconds(12'300'000)}) {
    StepClock other = make_step_clock(quartered);
    steps_due(other, quartered.numerator / quartered.denominator / 4);
    CHECK(fraction_of_step<double>(other) == 0.25);
  }
}

TEST_CASE("A float clock that adds up 1/60 stops at 524288 s, after 24986955 additions") {
  const AddedUpTime<float> sum = added_up(1.0f / 60, std::int64_t(1) << 40);
  CHECK(sum.stopped);
  CHECK(sum.time == 524288.0f);
  CHECK(sum.additions == 24'986'955);
  // Why there: the spacing becomes 1/16, and 1/60 is less than half of that.
  CHECK(524288.0f + 1.0f / 60 == 524288.0f);
  const float before = std::nextafter(524288.0f, 0.0f);
  CHECK(before + 1.0f / 60 > before);
  // The shortcut makes the additions that it replaces.
  float one_by_one = 0;
  for (int n = 0; n < 1'000'000; ++n) one_by_one += 1.0f / 60;
  CHECK(added_up(1.0f / 60, 1'000'000).time == one_by_one);
}

TEST_CASE("A double clock that adds up 1/60 is 0.69 ms behind after 10⁸ steps, n h is not") {
  const AddedUpTime<double> sum = added_up(1.0 / 60, 100'000'000);
  const long double exact = 100'000'000.0L / 60;
  CHECK(sum.additions == 100'000'000);
  CHECK(std::abs(sum.time - exact + 6.9e-4L) < 0.05e-4L);
  double one_by_one = 0;
  for (int n = 0; n < 1'000'000; ++n) one_by_one += 1.0 / 60;
  CHECK(added_up(1.0 / 60, 1'000'000).time == one_by_one);

  StepClock clock = make_step_clock(steps_per_second(60));
  clock.steps = 100'000'000;
  // One rounding of h and one of the product.
  CHECK(std::abs(simulated_time<double>(clock) - exact) <= 2 * unit_roundoff<double> * exact);
  // Beyond 2²⁴ a float can't tell all integers apart: one rounding more.
  CHECK(std::abs(simulated_time<float>(clock) - exact) <= 3 * unit_roundoff<float> * exact);
  // Of these two the product's is one, at any moment: below 2⁵³ the number of steps is exact.
  const long double h = time_step_of<double>(clock.step);
  long double farthest = 0;
  for (clock.steps = 1; clock.steps < std::int64_t(1) << 50; clock.steps += clock.steps / 97 + 1) {
    const long double product = static_cast<long double>(clock.steps) * h;
    farthest = std::max(farthest, std::abs(simulated_time<double>(clock) / product - 1));
  }
  CHECK(farthest <= unit_roundoff<double> * (1 + 4 * unit_roundoff<double>));
}

TEST_CASE("When frames slow down the physics slows down too and never explodes") {
  // A spring with w h = 1.5: stable at a sixtieth, not at a thirtieth.
  const double w = 90;
  const auto pull = [w](Particled& weight) {
    clear_force(weight);
    add_force(weight, -w * w * weight.position);
  };
  StepClock clock = make_step_clock(steps_per_second(60));
  const double time_step = time_step_of<double>(clock.step);
  Particled fixed = make_particle(1.0, Vec3d(1, 0, 0)), variable = fixed;
  double largest = 0;
  bool exploded = false;
  for (int n = 0; n < 600; ++n) {
    // Frames get slower, from 100 a second to one in five seconds, and faster again.
    const std::int64_t frame = 10 * millisecond + 4990 * millisecond * std::min(n, 600 - n) / 300;
    const std::int64_t due = steps_due(clock, frame);
    REQUIRE(due <= 8);
    for (std::int64_t k = 0; k < due; ++k) {
      pull(fixed);
      step(fixed, time_step);
      largest = std::max(largest, std::abs(fixed.position.x()));
    }
    REQUIRE(simulated_time<double>(clock) <= double(clock.time_in) / 1e9);
    if (exploded) continue;
    pull(variable);
    step(variable, double(frame) / 1e9);
    exploded = std::abs(variable.position.x()) > 1e6;
  }
  CHECK(largest <= 1 / std::sqrt(1 - 1.5 * 1.5 / 4) + 1e-9);  // as chapter 6 promises
  CHECK(exploded);                           // the same spring, stepped by the frames themselves
  CHECK(dropped_time<double>(clock) > 100);  // seconds: it has slowed down, and says by how much
  CHECK(balanced(clock));
}

TEST_CASE("The books of a clock hold its shortest steps in its longest frames, to the end") {
  // Steps of 1 ns: there can't be more of them than nanoseconds.
  const std::int64_t hour = 3'600'000'000'000, end = std::numeric_limits<std::int64_t>::max();
  StepClock clock =
      make_step_clock({.numerator = 1'000'000, .denominator = 1'000'000}, hour, 1'000'000);
  for (int n = 0; n < 100; ++n) steps_due(clock, hour);
  CHECK(clock.steps == 100 * 1'000'000);
  CHECK(clock.dropped_steps == 100 * (hour - 1'000'000));
  CHECK(balanced(clock));
  clock.time_in = end - hour;  // an hour before the end
  clock.dropped_steps = clock.time_in - clock.steps;
  CHECK(steps_due(clock, hour) == 1'000'000);
  CHECK(clock.steps + clock.dropped_steps == end);
  CHECK(balanced(clock));
  CHECK(complaint_of([&] { make_step_clock({.numerator = 999'999, .denominator = 1'000'000}); }) ==
        "numerator of the step is 999999 ns; it must lie between 1000000 and "
        "3600000000000000000 ns");
}

TEST_CASE("Two steps that are each stable can explode when they alternate") {
  // In units of 1/w, steps a and b in turn multiply the state by a matrix of determinant 1 and
  // trace 2 − (a + b)² + a² b². It is stable while that lies between −2 and 2.
  const auto largest_after = [](double a, double b) {
    Particled weight = make_particle(1.0, Vec3d(1, 0, 0));
    double largest = 0;
    for (int n = 0; n < 400; ++n) {
      clear_force(weight);
      add_force(weight, -weight.position);
      step(weight, n % 2 == 0 ? a : b);
      largest = std::max(largest, std::abs(weight.position.x()));
    }
    return largest;
  };
  const auto trace = [](double a, double b) { return 2 - (a + b) * (a + b) + a * a * b * b; };
  CHECK(largest_after(1.8, 1.8) < 3);
  CHECK(largest_after(0.9, 0.9) < 3);
  CHECK(trace(1.8, 0.9) < -2);
  CHECK(largest_after(1.8, 0.9) > 1e10);
  CHECK(trace(1.4, 0.7) > -2);
  CHECK(largest_after(1.4, 0.7) < 10);
}

TEST_CASE("A frame, step or cap that cannot be is refused by name, and the clock is unchanged") {
  StepClock clock = make_step_clock(steps_per_second(60));
  steps_due(clock, 20 * millisecond);
  const StepClock before = clock;
  const auto unchanged = [&] {
    return clock.time_in == before.time_in && clock.steps == before.steps &&
           clock.remainder == before.remainder && clock.dropped_steps == before.dropped_steps &&
           clock.dropped_time == before.dropped_time;
  };
  CHECK(complaint_of([&] { steps_due(clock, -5); }) ==
        "frame time is -5 ns; time runs forward: it must be 0 or more");
  CHECK(unchanged());
  const std::int64_t huge = std::numeric_limits<std::int64_t>::max();
  CHECK(
      complaint_of([&] { steps_due(clock, huge); }) ==
      "frame time is 9223372036854775807 ns; with it the clock would have run for over 292 years");
  CHECK(unchanged());
  CHECK(steps_due(clock, 0) == 0);
  CHECK(unchanged());
  CHECK(steps_due(clock, huge - clock.time_in) == 8);  // as long as it fits, it is capped
  CHECK(balanced(clock));

  CHECK(complaint_of([] { nanoseconds_of(-0.5); }) ==
        "frame time is -0.5 s; time runs forward: it must be 0 or more");
  CHECK(complaint_of([] { nanoseconds_of(std::numeric_limits<double>::quiet_NaN()); }) ==
        "frame time is nan s; it must be finite");
  CHECK(complaint_of([] { nanoseconds_of(std::numeric_limits<double>::infinity()); }) ==
        "frame time is inf s; it must be finite");
  CHECK(complaint_of([] { nanoseconds_of(1e10); }) ==
        "frame time is 1e+10 s; it must lie between 0 and 9.2e+09 s");
  CHECK(nanoseconds_of(0.25) == 250 * millisecond);
  CHECK(nanoseconds_of(1.0 / 60) == 16'666'667);

  CHECK(complaint_of([] { steps_per_second(0); }) ==
        "steps per second is 0; it must lie between 1 and 1000000");
  CHECK(complaint_of([] { steps_per_second(-60); }) ==
        "steps per second is -60; it must lie between 1 and 1000000");
  CHECK(complaint_of([] { step_of_nanoseconds(0); }) ==
        "step is 0 ns; it must lie between 1000 and 3600000000000 ns");
  CHECK(complaint_of([] { make_step_clock({.numerator = 0, .denominator = 1}); }) ==
        "numerator of the step is 0 ns; it must lie between 1 and 3600000000000 ns");
  CHECK(complaint_of([] { make_step_clock({.numerator = 1, .denominator = 0}); }) ==
        "denominator of the step is 0; it must lie between 1 and 1000000");
  CHECK(complaint_of([] { make_step_clock({}, 0); }) ==
        "longest frame is 0 ns; it must lie between 1 and 3600000000000 ns");
  CHECK(complaint_of([] { make_step_clock({}, 1, 0); }) ==
        "most steps in a frame is 0; it must lie between 1 and 1000000");
}
