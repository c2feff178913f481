#include <exercise/judge.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition number_of_ticks("shown_after", 2, 1, 1000);

template <class Real>
struct Clock {
  Real time, owed;
};
template <class Real>
void get(Words& words, Clock<Real>& clock) {
  using tumble::exercise::get;
  get(words, clock.time);
  get(words, clock.owed);
}

template <class Real>
Clock<Real> ticked(const Clock<Real>& clock, Real time_step) {
  return ask<Clock<Real>>("tick", clock.time, clock.owed, time_step);
}

template <class Real>
Real spacing_at(Real time) {
  return std::nextafter(time, std::numeric_limits<Real>::infinity()) - time;
}

/// Where 1/60 is less than half of the spacing.
template <class Real>
Real late() {
  return std::ldexp(Real(1), std::numeric_limits<Real>::digits - 5);
}

template <class Real>
constexpr Real sixtieth = Real(1) / 60;

/// What shown_after gives. It must be what the student's ticks give, one by one.
template <class Real>
Real shown_after(Real start, Real time_step, int ticks) {
  Clock<Real> clock{start, 0};
  for (int n = 0; n < 600; ++n) clock = ticked(clock, time_step);
  const Real at_once = ask<Real>("shown_after", start, time_step, 600);
  require(at_once == clock.time,
          sentence("after 600 ticks shown_after gives ", at_once, " s, and your tick, one by one, ",
                   clock.time, " s. Leave shown_after as it was"));
  return ticks == 600 ? at_once : ask<Real>("shown_after", start, time_step, ticks);
}

template <class Real>
std::string ticks_from(Real start, int ticks) {
  return sentence("after ", counted(ticks, "tick"), " from ", start, " s on");
}

template <class Real>
Real plain_sum(Real time_step, int ticks) {
  Real time = 0;
  for (int n = 0; n < ticks; ++n) time += time_step;
  return time;
}

}  // namespace

EXERCISE_CHECK("What a tick adds is in the time and in what is owed, to the last bit") {
  for (const Real time : {Real(0), Real(1), Real(1000), late<Real>()})
    for (const Real owed_part : {Real(0), Real(0.25), Real(-0.25)}) {
      const Real owed = time > 0 ? owed_part * spacing_at(time) : 0, h = sixtieth<Real>;
      const auto next = ticked<Real>({time, owed}, h);
      // The change of the time is exact: it is a difference of neighbours.
      const double taken = double(next.time - time), due = double(h) + double(owed);
      const double missing = due - taken - double(next.owed);
      const double tolerance = 4 * unit_roundoff<Real> * std::abs(due);
      const std::string clock =
          sentence("a clock that shows ", time, " s and owes ", owed, " s gets ", h,
                   " s. Then it shows ", taken, " s more and owes ", next.owed);
      // Of h, which is many spacings of the earlier times, no clock may owe it all.
      require(
          time == late<Real>() || taken > double(h) / 2,
          clock +
              " s. A tick must move the clock: what is owed is only what the sum has rounded away");
      if (std::abs(missing) <= tolerance) continue;
      require(std::abs(due - taken + double(next.owed)) > tolerance,
              clock +
                  " s: right, but for the sign. Let `owed` be what must still be added: the true "
                  "time is time + owed");
      require(owed == 0 || std::abs(missing - double(owed)) > tolerance,
              clock + " s: what it owed before is forgotten. It is due now, with the step");
      require(next.owed != 0,
              clock +
                  " s: the sum has swallowed the rest. What is due less what the time has really "
                  "gained is owed");
      fail(clock + " s. Together that is off by " + shown(missing) + " s");
    }
}

EXERCISE_CHECK("The clock never owes more than half of the spacing of its time") {
  for (const Real start : {Real(1), Real(1000), late<Real>()}) {
    Clock<Real> clock{start, 0};
    bool owes = false;
    for (int n = 0; n < 100; ++n) {
      clock = ticked<Real>(clock, sixtieth<Real>);
      // Far beyond, half of the spacing lets any debt pass.
      const double latest =
          double(start) + (n + 2) * double(sixtieth<Real>) + 2 * double(spacing_at(start));
      require(clock.time >= start && double(clock.time) <= latest,
              sentence(ticks_from(start, n + 1), " the clock shows ", clock.time, " s"));
      const Real half = spacing_at(clock.time) / 2;
      // After a tick that leads across a power of two, or back, a spacing is twice the other.
      require(std::abs(clock.owed) <= half * (1 + 8 * unit_roundoff<Real>),
              sentence(ticks_from(start, n + 1), " it owes ", clock.owed,
                       " s, which is more than half of the spacing, ", half,
                       " s. A debt that can be paid must be: is it added to the step before the "
                       "sum?"));
      owes = owes || clock.owed != 0;
    }
    require(owes, ticks_from(start, 100) +
                      " it has never owed anything, though most of these sums are rounded");
  }
}

EXERCISE_CHECK("A million ticks of a sixtieth are n h to a few roundings") {
  const int ticks = 1'000'000;
  const Real h = sixtieth<Real>;
  const double truth = double(h) * ticks;
  // The time itself is rounded once; what is due is below h and half a spacing, about h here, and
  // is rounded in each tick: together no more than three roundings of n h.
  Found("after a million ticks the time", "s", double(shown_after(Real(0), h, ticks)))
      .mistake(double(plain_sum(h, ticks)),
               "that is what a plain sum gives, to the last digit: nothing that was owed has been "
               "paid. The brackets in due - (time - before) matter")
      .must_be(truth, 4 * unit_roundoff<Real> * truth);
}

EXERCISE_CHECK("It goes on where a plain sum stands still") {
  const Real start = late<Real>(), h = sixtieth<Real>;
  require(start + h == start, "here a plain sum moves");
  const int ticks = 600;
  const double gained = double(shown_after(start, h, ticks) - start);
  require(gained != 0, "at " + shown(start) +
                           " s, 600 ticks of a sixtieth have not moved the clock: "
                           "each one is rounded away, and what is owed is never paid");
  // Half a spacing may be owed.
  Found("the time that 600 ticks of a sixtieth have added at " + shown(start) + " s", "s", gained)
      .must_be(ticks * double(h), double(spacing_at(start)) / 2 * 1.001);
}
