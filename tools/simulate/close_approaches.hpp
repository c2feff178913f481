/// @file
/// Which bodies come so close to a point that attracts that the steps are too long for it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>
#include <string>
#include <tumble/gravity.hpp>
#include <tumble/scene/scene.hpp>
#include <vector>

namespace tumble::simulate {

/// About a point the steps must be so short that w h, with w = √(GM/r³), stays below this.
///
/// Chapter 11's limit of the step is about an equilibrium, and here is none: the gradient of the
/// field is −w² across r, and along r it is +2 w², which drives. What keeps the energy is that a
/// passage consists of many steps. A body that falls past the point from far away has the speed √(2
/// GM/r) where it is closest, so r turns by √2 w h in a step there, by a third of a radian at 1/4.
/// Kicks before drifts keep H − (h/2) v·∇V and not the energy H, up to second order in h. So as the
/// body comes and goes, H swings by at most (h/2)(GM/r²) √(2 GM/r), which is w h/√2 of GM/r, and
/// swings back. What doesn't come back was measured, as part of the kinetic energy at the closest
/// place: at 1/4 it is below a millionth for who falls from far away, and up to 1.5 % for who comes
/// seven times as fast; at 1 between 0.4 % and a fifth, at 2 between 9 % and two thirds. There
/// Verlet's scheme loses from half of what Euler's does to twice as much, and Suzuki's, with its
/// five kicks in a step, a seventh of it or more.
constexpr double most_turn_of_passage = 0.25;

/// What happens at one point.
struct CloseApproach {
  std::string body, effect;
  double time, closest, time_step;  ///< s; m; the longest step that is short enough for it, s
};

/// Watches all bodies that a point attracts. The scene must not change meanwhile.
template <class Real>
class CloseApproaches {
 public:
  template <class Backend>
  explicit CloseApproaches(const World<Real, Backend>& world) {
    for (const EffectInstance<Real>& instance : world.effects())
      if (const PointGravity<Real>* found = gravity_of(*instance.effect)) {
        Point point{instance.effect->name(), static_cast<double>(found->strength),
                    found->centre.template cast<double>()};
        for (const BodyIndex i : instance.members.indices) point.bodies.push_back(i);
        points_.push_back(std::move(point));
      }
  }

  /// Looks at what the next step does. @return a sentence if a body is too close for the first time
  /// in this run.
  template <class Backend>
  std::string look(const World<Real, Backend>& world) {
    const bool was_silent = bodies_.empty();
    const double h = time_step_of<double>(world.step_length());
    for (const Point& point : points_)
      for (const BodyIndex i : point.bodies) {
        const BodyHandle handle = world.handle_at(i);
        const Particle<Real> centre = world.body(handle).centre;
        const Vec3d r = centre.position.template cast<double>() - point.centre,
                    v = centre.velocity.template cast<double>();
        const double nearest = nearest_in_step(r, h * v);
        if (!(h * h * point.strength >
              most_turn_of_passage * most_turn_of_passage * nearest * nearest * nearest))
          continue;
        if (!bodies_.insert(i).second) continue;
        const double closest = closest_on_orbit(r, v, point.strength);
        const CloseApproach found{
            world.name_of(handle), point.name, static_cast<double>(world.ticks()) * h, closest,
            most_turn_of_passage * std::sqrt(closest / point.strength) * closest};
        if (!worst_ || found.time_step < worst_->time_step) worst_ = found;
      }
    if (!was_silent || !worst_) return {};
    return "at " + shown(worst_->time) + " s " + sentence(*worst_, h);
  }

  /// Of a run in which several bodies came too close: how many, and what the worst of them needs.
  template <class Backend>
  std::string summary(const World<Real, Backend>& world) const {
    if (bodies_.size() < 2) return {};
    return std::to_string(bodies_.size()) + " bodies came too close to a point that attracts; at " +
           shown(worst_->time) + " s " +
           sentence(*worst_, time_step_of<double>(world.step_length()));
  }

 private:
  struct Point {
    std::string name;
    double strength;  // GM, m³/s²
    Vec3d centre;
    std::vector<BodyIndex> bodies = {};
  };

  /// By itself, or as the scene's file names it.
  static const PointGravity<Real>* gravity_of(const AnyEffect<Real>& effect) {
    using Own = PointGravity<Real>;
    if (const auto* own = dynamic_cast<const EffectOf<Real, Own>*>(&effect)) return &own->effect();
    const auto* named = dynamic_cast<const EffectOf<Real, Named<Own>>*>(&effect);
    return named ? &named->effect() : nullptr;
  }

  static std::string shown(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
  }

  static std::string sentence(const CloseApproach& at, double h) {
    // Less by what the energy swings by, and by two digits' rounding.
    char step[32];
    std::snprintf(step, sizeof step, "%.2g", 0.85 * at.time_step);
    return "'" + at.body + "' is too close to the centre of '" + at.effect + "' for steps of " +
           shown(h) + " s: it passes at " + shown(at.closest) +
           " m, and its energy may change for good. " +
           (at.time_step > shortest_step
                ? "That passage takes steps of " + std::string(step) + " s or less"
                : "No step is short enough for that; let it pass farther away");
  }

  /// How near a straight step comes to the point.
  static double nearest_in_step(const Vec3d& r, const Vec3d& way) {
    const double length = way.squaredNorm();
    const double part = length > 0 ? std::clamp(-r.dot(way) / length, 0.0, 1.0) : 0;
    return (r + part * way).norm();
  }

  /// Where the speed is across r, L = r v and E = v²/2 − GM/r together give r. A body that moves
  /// away for good has that place behind it.
  static double closest_on_orbit(const Vec3d& r, const Vec3d& v, double strength) {
    const double energy = v.squaredNorm() / 2 - strength / r.norm();
    if (r.dot(v) >= 0 && energy >= 0) return r.norm();
    const double L2 = r.cross(v).squaredNorm();
    return L2 / (strength + std::sqrt(std::max(0.0, strength * strength + 2 * energy * L2)));
  }

  static constexpr double shortest_step = 1e-6;  // s, of a scene

  std::vector<Point> points_;
  std::set<BodyIndex> bodies_;  // that have been too close
  std::optional<CloseApproach> worst_;
};

}  // namespace tumble::simulate
