/// @file
/// The tops that every rule has to turn: four problems from easy to hard, and a thrown T-handle.
#pragma once

#include <array>
#include <string_view>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

namespace tumble::support {

/// A free top and how long to watch it, at 60 steps a second.
struct TumblingProblem {
  char letter;
  std::string_view name;
  std::array<double, 3> moments;           ///< kg m²
  std::array<double, 3> angular_velocity;  ///< at the start, rad/s, body axes
  int seconds;                             ///< for energy and angular momentum
  int seconds_to_angle;                    ///< for the angle from the exact orientation
};

inline constexpr std::array<TumblingProblem, 4> tumbling_problems = {{
    {'A', "ordinary", {1, 2, 3}, {1, 2, 0.5}, 600, 10},
    {'B', "stable axis", {1, 2, 3}, {0.2, 0.1, 3}, 600, 10},
    {'C', "thin rod", {1.7231e-4, 6.58e-6, 1.7243e-4}, {2, 60, 1}, 60, 1},
    {'D', "needle", {1, 1e-6, 1.0000005}, {1, 200, 0.5}, 60, 1},
}};

/// A top with these moments and this spin, its axes in the order given.
template <class Real>
Top<Real> top_in_order(const TumblingProblem& problem, const std::array<int, 3>& order) {
  Top<Real> top;
  Vec3<Real> spin;
  for (int axis = 0; axis < 3; ++axis) {
    const auto from = static_cast<std::size_t>(order[static_cast<std::size_t>(axis)]);
    top.inverse_moments[axis] = 1 / static_cast<Real>(problem.moments[from]);
    spin[axis] = static_cast<Real>(problem.angular_velocity[from]);
  }
  set_angular_velocity_body(top, spin);
  return top;
}

/// The problem's top at the start, the two closest inverse moments first, as make_rigid_body()
/// orders them.
template <class Real>
Top<Real> top_of(const TumblingProblem& problem) {
  const auto& I = problem.moments;
  std::array<int, 3> ascending = {0, 1, 2};
  for (const auto& order : {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{2, 0, 1},
                            std::array{0, 2, 1}, std::array{2, 1, 0}, std::array{1, 0, 2}}) {
    const auto at = [&](int n) { return I[static_cast<std::size_t>(order[std::size_t(n)])]; };
    if (at(0) <= at(1) && at(1) <= at(2)) ascending = order;
  }
  const auto at = [&](std::size_t n) { return I[static_cast<std::size_t>(ascending[n])]; };
  const auto closest = closest_pair_first(Vec3d(1 / at(0), 1 / at(1), 1 / at(2)));
  std::array<int, 3> order;
  for (std::size_t n = 0; n < 3; ++n) order[n] = ascending[static_cast<std::size_t>(closest[n])];
  return top_in_order<Real>(problem, order);
}

/// A cylinder somewhere in a model.
struct PlacedCylinder {
  Cylinder<double> cylinder;
  Mat3d axes;    ///< from the cylinder's axes to the model's
  Vec3d centre;  ///< m, model axes
};

/// The shape of a T: a bar along x and a shaft down from its middle, in model axes.
inline std::array<PlacedCylinder, 2> t_handle_shape() {
  const Cylinder<double> bar{.radius = 0.008, .height = 0.12},
      shaft{.radius = 0.01, .height = 0.06};
  Mat3d z_to_x, z_to_y;
  z_to_x << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  z_to_y << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return {{{bar, z_to_x, Vec3d::Zero()}, {shaft, z_to_y, {0, -bar.radius - shaft.height / 2, 0}}}};
}

/// The handle, made of aluminium.
inline MassProperties<double> t_handle() {
  const auto made = [](const PlacedCylinder& part) {
    const double density = 2700;
    return moved<double>(mass_properties_of_density(part.cylinder, density), part.axes,
                         part.centre);
  };
  const auto [bar, shaft] = t_handle_shape();
  return combined<double>({made(bar), made(shaft)});
}

/// The handle, thrown with a spin of 10 rad/s about its shaft that is off by a hundredth.
inline ModelledBody<double> thrown_t_handle() {
  return make_rigid_body("T-handle", t_handle(), {}, {0, 0, 0}, {0.1, 10, 0});
}

}  // namespace tumble::support
