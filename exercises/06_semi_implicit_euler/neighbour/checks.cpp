#include <exercise/judge.hpp>

using namespace tumble::exercise;

namespace {

/// A particle on a line, where it is now.
template <class Real>
struct Moment {
  Real energy, force, slope, velocity, mass;
};

template <class Real>
Real neighbours_energy(const Moment<Real>& now, double time_step) {
  return ask<Real>("neighbours_energy", now.energy, now.force, now.slope, now.velocity, now.mass,
                   Real(time_step));
}

/// Two moments in which no two numbers agree, and all are powers of two or small whole numbers.
template <class Real>
std::array<Moment<Real>, 2> moments() {
  return {Moment<Real>{8, -4, Real(-1.5), 2, Real(0.5)}, Moment<Real>{10, 6, Real(0.5), -3, 4}};
}

/// A step rounds some ten times, numbers below 64.
template <class Real>
constexpr double rounding = 10 * 64 * unit_roundoff<Real>;

}  // namespace

EXERCISE_CHECK("The first term beyond the energy is half a step of the power") {
  for (const auto& now : moments<Real>()) {
    const Real power = now.force * now.velocity, h = Real(0.25);
    Found("without a step the energy", "J", neighbours_energy(now, 0))
        .must_be(now.energy, rounding<Real>);
    // Steps of h and of -h have the same term in h² and opposite ones in h.
    const Real odd = (neighbours_energy(now, h) - neighbours_energy(now, -h)) / 2;
    Found("the part of the result that changes its sign with h, for h = 1/4 s,", "J", odd)
        .mistake(0, "the term in h is missing")
        .mistake(h * power, "a whole step of the power. Only half of it belongs to the energy")
        .mistake(-h / 2 * power, "the sign is the other one")
        .must_be(h / 2 * power, rounding<Real>);
  }
}

EXERCISE_CHECK("The second has the rate that takes the trapezoid's error away") {
  for (const auto& now : moments<Real>()) {
    const Real h = 1, bend = now.slope * now.velocity * now.velocity,
               square = now.force * now.force / now.mass;
    const Real even =
        (neighbours_energy(now, h) + neighbours_energy(now, -h)) / 2 - neighbours_energy(now, 0);
    Found("the term in h², for a step of 1 s,", "J", even)
        .mistake(0, "it is missing")
        .mistake((bend - square) / 12, "what a step adds has to be subtracted: the sign")
        .mistake(-bend / 12, "F' v² alone has one term too many in its rate")
        .mistake(-(bend + square) / 12, "the rate of F²/m must take 2 F F' v/m away")
        .mistake(-(bend - square * now.mass) / 12, "the mass is missing in F²/m")
        .mistake(-(bend - square) / 6, "the trapezoid's error has a 12")
        .mistake(-(bend - square) / 24, "the trapezoid's error has a 12")
        .must_be(-(bend - square) / 12, rounding<Real>);
  }
}

EXERCISE_CHECK("Along a pendulum's steps it wavers by h³: half the step, an eighth") {
  // 1 kg, 1 rad/s, released at rest at 2 rad: F = -sin x. The steps are the judge's, in double.
  const auto wavering = [](double h) {
    double place = 2, velocity = 0, largest_off = 0, start = 0;
    for (int n = 0; n * h < 8; ++n) {  // a swing takes 8.3 s
      const Moment<Real> now{Real(velocity * velocity / 2 - std::cos(place)),
                             Real(-std::sin(place)), Real(-std::cos(place)), Real(velocity),
                             Real(1)};
      const double found = double(neighbours_energy(now, h));
      if (n == 0) start = found;
      const double off = std::abs(found - start);
      if (!(off <= largest_off)) largest_off = off;  // a NaN gets through too
      velocity -= h * std::sin(place);
      place += h * velocity;
    }
    return largest_off;
  };
  const double coarse = wavering(0.25), fine = wavering(0.125);
  // The next order changes the ratio by about h; in float some roundings of 1 J are a hundredth of
  // the finer one.
  Found("from steps of 1/4 s to steps of 1/8 s, the number of times that the wavering halves", "",
        std::log2(coarse / fine))
      .mistake(1, "half the step, half the wavering. The term in h is not yet right")
      .mistake(2, "half the step, a quarter of the wavering. The term in h² is not yet right")
      .not_a_number("it doesn't waver at all, as only a constant can")
      .must_be(3, 0.1);
}
