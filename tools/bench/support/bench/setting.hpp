/// @file
/// The scenes that everybody steps: our world, the plain loops, Bullet and ODE.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tumble/real.hpp>

namespace tumble::support::bench {

/// Bodies far from one another that fly freely, each scene with one effect more or another. In the
/// first two they are points; in the others boxes that tumble.
enum class Scene {
  points_coasting,
  points_under_gravity,
  tumbling,
  tumbling_with_torque,
  tumbling_with_damping,
  everything
};

inline constexpr std::array<std::string_view, 6> scene_names = {
    "points coasting",      "points under gravity",  "tumbling",
    "tumbling with torque", "tumbling with damping", "everything"};

constexpr std::string_view name_of(Scene scene) {
  return scene_names[static_cast<std::size_t>(scene)];
}

constexpr bool has_gravity(Scene scene) {
  return scene == Scene::points_under_gravity || scene == Scene::everything;
}
constexpr bool has_tops(Scene scene) {
  return scene != Scene::points_coasting && scene != Scene::points_under_gravity;
}
constexpr bool has_torque(Scene scene) {
  return scene == Scene::tumbling_with_torque || scene == Scene::everything;
}
constexpr bool has_damping(Scene scene) {
  return scene == Scene::tumbling_with_damping || scene == Scene::everything;
}

/// Three numbers that every library can read; world axes unless said otherwise.
using Triple = std::array<double, 3>;

/// The same as a vector of ours.
template <class Real>
Vec3<Real> vector_of(const Triple& v) {
  return Vec3d(v[0], v[1], v[2]).cast<Real>();
}

template <class Vector>
Triple triple_of(const Vector& v) {
  return {double(v[0]), double(v[1]), double(v[2])};
}

inline constexpr double gravity = -9.81;                 ///< m/s², along z
inline constexpr Triple torque = {0.125, 0.25, -0.125};  ///< N m, on each body
inline constexpr double damping_rate = 0.25;             ///< 1/s, of velocity and spin

/// A box of 1 kg with edges of 2, 1 and 3 m along its principal axes, which come in the order that
/// the splitting of chapter 8 wants: the two with the closest inverse moments first.
inline constexpr double mass = 1;
inline constexpr Triple edges = {2, 1, 3};
inline constexpr Triple moments = {10. / 12, 13. / 12, 5. / 12};  ///< kg m²

/// How body number n begins. All face the same way; no neighbour spins alike.
struct Start {
  Triple position, velocity;  ///< m, m/s
  Triple angular_velocity;    ///< rad/s
};

constexpr Start start_of(std::size_t n) {
  const double more = 1 + static_cast<double>(n % 7) / 8;
  const std::size_t row = n / 1024;
  return {.position = {static_cast<double>(n % 1024) * 16, static_cast<double>(row) * 16, 0},
          .velocity = {more, -2, 0.5},
          .angular_velocity = {more, 2 * more, -1.5}};
}

/// Where a body has come to, world axes.
struct Motion {
  Triple position, velocity;  ///< m, m/s
  Triple angular_velocity;    ///< rad/s
};

/// What is asked of those who step a scene.
struct Setting {
  Scene scene = Scene::everything;
  std::size_t count = 1;
  int rate = 60;  ///< steps in a second
  int threads = 1;
  bool gyroscopic = true;  ///< false: Euler's L × ω is left out, where a library lets one choose
  double time_step() const { return 1. / rate; }
};

}  // namespace tumble::support::bench
