/// @file
/// The problems that every method is tried on: a body, what acts on it, and for how long.
#pragma once

#include <string>
#include <support/exactly.hpp>
#include <support/tumbling_problems.hpp>
#include <tumble/ladder.hpp>
#include <vector>

namespace tumble::support {

/// What stays constant, for the observer: the energy (J) and the part of a momentum that nothing
/// changes. A problem that keeps neither answers with zeros.
struct Kept {
  long double energy = 0;
  Vec3<long double> momentum = Vec3<long double>::Zero();
};

/// Nothing acts on the top.
template <class Real>
struct NoTorque {
  void operator()(Top<Real>&, Real) const {}
  static Kept kept(const Top<long double>& top) {
    return {kinetic_energy(top), angular_momentum_world(top)};
  }
};

/// The weight of a top whose tip is held, about the tip. The moments are those about the tip too.
template <class Real>
struct Weight {
  Real weight_times_arm;  ///< M g l, N m
  void operator()(Top<Real>& top, Real) const {
    top.torque = torque_on_axis(rotate<Real>(top.orientation, Vec3<Real>::UnitZ()), 0);
  }
  /// The same in body axes, with the third row of the rotation matrix for the upright.
  Vec3<Real> torque_body(const Quaternion<Real>& q, Real) const {
    const Vec3<Real>& u = q.imaginary;
    const Real twice = 2 * weight_times_arm;
    return {twice * (u.y() * u.z() + q.real * u.x()), twice * (q.real * u.y() - u.x() * u.z()), 0};
  }
  /// The same of an axis, in world axes.
  Vec3<Real> torque_on_axis(const Vec3<Real>& axis, Real) const {
    return weight_times_arm * Vec3<Real>(-axis.y(), axis.x(), 0);
  }
  Kept kept(const Top<long double>& top) const {
    const Vec3<long double> axis = rotate<long double>(top.orientation, Vec3<long double>::UnitZ());
    const Vec3<long double> L = angular_momentum_world(top);
    return {kinetic_energy(top) + static_cast<long double>(weight_times_arm) * axis.z(),
            {0, 0, L.z()}};
  }
};

/// The weight of a top whose centre of mass may lie off its axes, about the tip that is held.
template <class Real>
struct OffAxisWeight {
  Vec3<Real> weight_times_arm;  ///< M g times the place of the centre from the tip, body axes, N m
  void operator()(Top<Real>& top, Real) const {
    const Vec3<Real> arm = rotate<Real>(top.orientation, weight_times_arm);
    top.torque = {-arm.y(), arm.x(), 0};
  }
  Kept kept(const Top<long double>& top) const {
    const Vec3<long double> arm =
        rotate<long double>(top.orientation, weight_times_arm.template cast<long double>().eval());
    return {kinetic_energy(top) + arm.z(), {0, 0, angular_momentum_world(top).z()}};
  }
};

/// A torque that changes with time alone, in world axes.
template <class Real>
struct Drive {
  void operator()(Top<Real>& top, Real time) const {
    top.torque = {Real(0.6) * std::cos(2 * time), Real(0.4) * std::sin(3 * time), Real(0.3)};
  }
  static Kept kept(const Top<long double>&) { return {}; }
};

/// A spring to the origin.
template <class Real>
struct SpringForce {
  Real stiffness;  ///< N/m
  void operator()(Particle<Real>& particle, Real) const {
    particle.force = -stiffness * particle.position;
  }
  Kept kept(const Particle<long double>& particle) const {
    return {kinetic_energy(particle) +
                static_cast<long double>(stiffness) * particle.position.squaredNorm() / 2,
            mass_of(particle) * particle.position.cross(particle.velocity)};
  }
};

/// The pull of a star that stands at the origin.
template <class Real>
struct Star {
  Real strength;  ///< G times its mass, m³/s²; the planet has 1 kg
  void operator()(Particle<Real>& particle, Real) const {
    const Real square = particle.position.squaredNorm();
    particle.force = (-strength / (square * std::sqrt(square))) * particle.position;
  }
  /// The potential energy, with the other sign, J.
  Real pull_energy(const Particle<Real>& particle) const {
    return strength / std::sqrt(particle.position.squaredNorm());
  }
  Kept kept(const Particle<long double>& particle) const {
    return {
        kinetic_energy(particle) - static_cast<long double>(strength) / particle.position.norm(),
        particle.position.cross(particle.velocity)};
  }
};

/// A weight in thick air, with the drag −b v in the drift: without force a thing coasts to a stop,
/// exactly, by e^(−c t), where c is b divided by the mass.
template <class Real>
struct GravityInAir {
  Real weight, drag, drag_rate;  ///< N; b, kg/s; c, 1/s
  void operator()(Particle<Real>& particle, Real) const { particle.force = {0, 0, -weight}; }
  void drift(Particle<Real>& particle, Real time) const {
    const Real lost = -std::expm1(-drag_rate * time);
    particle.position += lost / drag_rate * particle.velocity;
    particle.velocity -= lost * particle.velocity;
  }
  /// The drag as a force too, for whoever has no drift.
  void in_full(Particle<Real>& particle, Real) const {
    particle.force = Vec3<Real>(0, 0, -weight) - drag * particle.velocity;
  }
  static Kept kept(const Particle<long double>&) { return {}; }
};

/// The same law in long double, with the numbers as they were rounded.
template <class Real>
NoTorque<long double> exactly(const NoTorque<Real>&) {
  return {};
}
template <class Real>
Weight<long double> exactly(const Weight<Real>& weight) {
  return {weight.weight_times_arm};
}
template <class Real>
Drive<long double> exactly(const Drive<Real>&) {
  return {};
}
template <class Real>
SpringForce<long double> exactly(const SpringForce<Real>& spring) {
  return {spring.stiffness};
}
template <class Real>
Star<long double> exactly(const Star<Real>& star) {
  return {star.strength};
}
template <class Real>
GravityInAir<long double> exactly(const GravityInAir<Real>& air) {
  return {.weight = air.weight, .drag = air.drag, .drag_rate = air.drag_rate};
}

template <class Real>
Particle<long double> exactly(const Particle<Real>& particle) {
  return {.position = particle.position.template cast<long double>(),
          .velocity = particle.velocity.template cast<long double>(),
          .inverse_mass = particle.inverse_mass};
}

/// One problem: where it starts, what acts, and after what time its state is asked for.
template <class Body, class Forces>
struct Problem {
  std::string name;
  Body start;
  Forces evaluate_forces;
  double seconds;
};

template <class Real>
using FreeProblem = Problem<Top<Real>, NoTorque<Real>>;

/// The problems A to D of chapter 8, and its T-handle.
template <class Real>
std::vector<FreeProblem<Real>> free_problems() {
  std::vector<FreeProblem<Real>> problems;
  for (const TumblingProblem& problem : tumbling_problems)
    problems.push_back({std::string(1, problem.letter) + " " + std::string(problem.name),
                        top_of<Real>(problem),
                        {},
                        double(problem.seconds_to_angle)});
  const Topd handle = thrown_t_handle().body.top;
  problems.push_back({"T-handle",
                      {.angular_momentum_body = handle.angular_momentum_body.cast<Real>(),
                       .inverse_moments = handle.inverse_moments.cast<Real>()},
                      {},
                      10});
  return problems;
}

/// A heavy symmetric top, its axis 0.6 rad off the vertical and let go, at `spin` rad/s about it.
template <class Real>
Problem<Top<Real>, Weight<Real>> heavy_top(const char* name, double spin) {
  Top<Real> top{.orientation = quaternion_about<Real>(Vec3<Real>::UnitX(), Real(0.6)),
                .inverse_moments = {2, 2, 5}};
  top.angular_momentum_body.z() = Real(0.2 * spin);
  return {name, top, {.weight_times_arm = 1}, 10};
}

/// A kilogram whose three moments about the tip differ and whose centre lies off its axes, `off` m
/// from the plane of axes 1 and 3. With 0 it has that plane for a mirror. Let go at `tilt` rad.
template <class Real>
Problem<Top<Real>, OffAxisWeight<Real>> asymmetric_heavy_top(double off, double tilt) {
  const Top<Real> top{.orientation = quaternion_about<Real>(Vec3<Real>::UnitX(), Real(tilt)),
                      .angular_momentum_body = {0, 3, 0},
                      .inverse_moments = {1 / Real(1.5), 1 / Real(1.9), 1 / Real(0.8)}};
  const Vec3<Real> arm(Real(0.3), Real(off), Real(0.5));
  return {"asymmetric heavy top", top, {Real(9.81) * arm}, 10};
}

/// Problem A's top, with a torque that swings.
template <class Real>
Problem<Top<Real>, Drive<Real>> driven_top() {
  return {"driven top", top_of<Real>(tumbling_problems[0]), {}, 10};
}

/// 1 kg on a spring, let go 1 m away with 0.5 m per radian of its swing across.
template <class Real>
Problem<Particle<Real>, SpringForce<Real>> spring(const char* name, double angular_frequency,
                                                  double seconds) {
  return {name,
          make_particle(Real(1), {1, 0, 0}, {0, Real(0.5 * angular_frequency), 0}),
          {.stiffness = Real(angular_frequency * angular_frequency)},
          seconds};
}

/// An orbit of semi-major axis 1 m and eccentricity 0.8 around 1 m³/s², from the nearest point on:
/// about a round and a half.
template <class Real>
Problem<Particle<Real>, Star<Real>> eccentric_orbit() {
  return {"eccentric orbit", make_particle(Real(1), {Real(0.2), 0, 0}, {0, 3, 0}), {1}, 10};
}

/// A throw through thick air.
template <class Real>
Problem<Particle<Real>, GravityInAir<Real>> projectile() {
  return {"projectile in air",
          make_particle(Real(1), {0, 0, 0}, {20, 0, 20}),
          {.weight = Real(9.81), .drag = Real(0.5), .drag_rate = Real(0.5)},
          3};
}

}  // namespace tumble::support
