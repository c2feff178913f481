/// @file
/// Tops that nobody would think of, many at once, and the books of what happens to them.
#pragma once

#include <support/random_world.hpp>
#include <tumble/packed_bodies.hpp>
#include <tumble/tumbling.hpp>

namespace tumble::support {

/// One number, evenly spread over the powers of ten between two.
inline double spread_over_decades(RandomGenerator& dice, double from, double to) {
  return std::pow(10, from + (to - from) * (dice.real<double>() + 1) / 2);
}

/// A top with moments anywhere in 30 decades around 1 kg m², in a ratio of up to a million. Its |L|
/// is a random part of a size that, divided by the smallest moment, lies anywhere in the 12 decades
/// below `fastest` (rad/s). In `seconds` the torque gives another random part of that size.
template <class Real>
Top<Real> random_top(RandomGenerator& dice, double fastest, double seconds) {
  // Any three spreads of matter along the axes make moments that can be.
  Vec3d spread;
  for (double& one : spread) one = spread_over_decades(dice, -6, 0);
  const Vec3d moments = spread_over_decades(dice, -12, 12) *
                        Vec3d(spread[1] + spread[2], spread[2] + spread[0], spread[0] + spread[1]);
  std::array<int, 3> ascending = {0, 1, 2};
  std::sort(ascending.begin(), ascending.end(),
            [&](int i, int j) { return moments[i] < moments[j]; });
  const Vec3d sorted(moments[ascending[0]], moments[ascending[1]], moments[ascending[2]]);
  const auto [a, b, c] = closest_pair_first<double>(sorted.cwiseInverse());
  const double size =
      sorted[0] * spread_over_decades(dice, std::log10(fastest) - 12, std::log10(fastest));
  Top<Real> top;
  top.orientation = quaternion_of_rotation_vector<Real>(3 * dice.vector<Real>());
  top.orientation = normalized(top.orientation);
  top.inverse_moments = Vec3d(1 / sorted[a], 1 / sorted[b], 1 / sorted[c]).cast<Real>();
  top.angular_momentum_body = (size / std::sqrt(3) * dice.vector<double>()).cast<Real>();
  top.torque = (size / std::sqrt(3) / seconds * dice.vector<double>()).cast<Real>();
  return top;
}

/// The largest component, whose square need not be a number.
template <class Number>
Number largest_of(const Vec3<Number>& v) {
  using std::abs;
  const Number xy = select(abs(v.x()) > abs(v.y()), abs(v.x()), abs(v.y()));
  return select(abs(v.z()) > xy, abs(v.z()), xy);
}

/// What the books of a run can't explain, relative to the most that there was: of the angular
/// momentum in the world, and of the energy.
template <class Number>
struct Unexplained {
  Number momentum, energy;
};

/// Steps a top, or a pack of them, under its steady torque τ, and keeps the books: each kick is
/// worth h τ in angular momentum and h τ · ½(ω + ω') in energy. What the turn makes of the energy
/// is entered as whatever it was: so the energy's book tests the kicks and the finiteness of all
/// numbers, and says nothing of the turning. L's book does, for nothing is entered there for turns.
//! [booked]
template <class Number, class Turn>
Unexplained<Number> booked(Top<Number>& top, const Turn& turn, Number time_step, int steps) {
  using std::abs;
  const Vec3<Number> start = angular_momentum_world(top);
  const Number energy_at_start = kinetic_energy(top);
  Number by_kicks = 0, by_turns = 0, most = energy_at_start;
  for (int n = 0; n < steps; ++n) {
    const Vec3<Number> spin = angular_velocity_body(top);
    kick(top, time_step);
    const Vec3<Number> twice_mean = spin + angular_velocity_body(top);
    by_kicks += time_step / 2 * rotate_back(top.orientation, top.torque).dot(twice_mean);
    const Number kicked = kinetic_energy(top);
    turn(top, time_step);
    by_turns += kinetic_energy(top) - kicked;
    most = select(kicked > most, kicked, most);
    most = select(kinetic_energy(top) > most, kinetic_energy(top), most);
  }
  const Vec3<Number> given = Number(steps) * time_step * top.torque;
  const Vec3<Number> momentum = angular_momentum_world(top) - start - given;
  const Number energy = kinetic_energy(top) - energy_at_start - by_kicks - by_turns;
  return {.momentum = largest_of(momentum) / (largest_of(start) + largest_of(given)),
          .energy = abs(energy) / most};
}
//! [booked]

}  // namespace tumble::support
