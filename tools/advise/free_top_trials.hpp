/// @file
/// The free tops on which methods are tried, and where the exact solution has them.
#pragma once

#include <algorithm>
#include <numbers>
#include <random>
#include <support/exact_motion.hpp>
#include <tumble/exact/free_top.hpp>
#include <tumble/make_rigid_body.hpp>

#include "free_top.hpp"

namespace tumble::advise {

/// The question, and three like it: turned at random, and the spin off by up to a hundredth.
inline constexpr int trials = 4;

/// More frames than this are not compared; they are then spread evenly over the time.
inline constexpr long most_frames_seen = 4096;

inline long frames_between_samples(const Frames& frames) {
  return (frames.count + most_frames_seen - 1) / most_frames_seen;
}

/// The top with these moments and this spin, its axes in the order in which chapter 5 puts them.
/// Where that order is odd, all three axes point the other way, so that they stay right-handed.
template <class Real>
Top<Real> top_of(const std::array<double, 3>& moments, const Vec3d& spin) {
  std::array<int, 3> axes = {0, 1, 2};
  const auto moment = [&](int axis) { return moments[static_cast<std::size_t>(axis)]; };
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return moment(a) < moment(b); });
  const auto closest =
      closest_pair_first(Vec3d(1 / moment(axes[0]), 1 / moment(axes[1]), 1 / moment(axes[2])));
  const double sign = (axes[0] + 1) % 3 == axes[1] ? 1 : -1;
  Top<Real> top;
  Vec3<Real> spin_in_order;
  for (int axis = 0; axis < 3; ++axis) {
    const int from = axes[static_cast<std::size_t>(closest[static_cast<std::size_t>(axis)])];
    top.inverse_moments[axis] = 1 / static_cast<Real>(moment(from));
    spin_in_order[axis] = static_cast<Real>(sign * spin[from]);
  }
  set_angular_velocity_body(top, spin_in_order);
  return top;
}

/// The top that is asked for, or one like it.
template <class Real>
Top<Real> start_of(const FreeTopQuestion& question, int trial) {
  const Vec3d spin(question.spin[0], question.spin[1], question.spin[2]);
  if (trial == 0) return top_of<Real>(question.moments, spin);
  std::mt19937_64 generator(static_cast<unsigned>(trial));
  std::normal_distribution<double> normal;
  const auto random_vector = [&] {
    const double x = normal(generator), y = normal(generator), z = normal(generator);
    return Vec3d(x, y, z);
  };
  const double real = normal(generator);
  const Quaterniond orientation = normalized(Quaterniond{real, random_vector()});
  const Vec3d other = spin + 0.01 * spin.norm() * random_vector().normalized();
  Top<Real> top = top_of<Real>(question.moments, other);
  top.orientation = normalized(Quaternion<Real>{static_cast<Real>(orientation.real),
                                                orientation.imaginary.template cast<Real>()});
  return top;
}

/// How far the exact solution may have the top wrong at such a time, rad.
inline double uncertainty_of_truth(const Top<long double>& start, double seconds) {
  if (start.angular_momentum_body.isZero(0)) return 0;
  const long double fastest =
      std::sqrt(2 * kinetic_energy(start) * start.inverse_moments.maxCoeff());
  // As counted beside the checks of FreeTop: 290 roundings once, and 65 for each radian, add up so.
  const long double rounding =
      (5 * std::sqrt(290 / 3.0L) + 5 * std::sqrt(65 / 3.0L) * fastest * seconds) *
      std::numeric_limits<long double>::epsilon() / 2;
  const exact::FreeTop<long double> truth(start);
  return std::min(std::numbers::pi,  // the largest angle that there is
                  static_cast<double>(rounding + 2 * fastest * truth.time_uncertainty(seconds)));
}

/// A start and where the exact solution has it in each frame that is compared.
template <class Real>
struct Trial {
  Top<Real> start;
  std::vector<Top<long double>> truth = {};
  double uncertainty = 0;  ///< of the last of these, rad
};

template <class Real>
std::vector<Trial<Real>> trials_of(const FreeTopQuestion& question, const Frames& frames) {
  std::vector<Trial<Real>> list;
  for (int trial = 0; trial < trials; ++trial) {
    Trial<Real> made{start_of<Real>(question, trial)};
    const Top<long double> start = support::exactly(made.start);
    made.uncertainty = uncertainty_of_truth(start, frames.seconds());
    const exact::FreeTop<long double> exact(start);
    for (long frame = 0; frame <= frames.count; frame += frames_between_samples(frames))
      made.truth.push_back(
          exact.at(static_cast<long double>(frame) / static_cast<long double>(frames.rate)));
    list.push_back(std::move(made));
  }
  return list;
}

/// Appends the candidates in one precision, see free_top_candidates(); none if it can't store the
/// top. It is compiled in a file for each.
template <class Real>
void append_free_top(std::vector<Candidate>& candidates, const FreeTopQuestion& question,
                     const Frames& frames, const StepKinds& kinds, double longest_run);

}  // namespace tumble::advise
