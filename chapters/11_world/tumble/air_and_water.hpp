/// @file
/// What surrounds a body: damping, drag, the Magnus force and buoyancy as effects.
#pragma once

#include <numbers>
#include <tumble/damping.hpp>
#include <tumble/drag.hpp>
#include <tumble/effect.hpp>

namespace tumble {

/// Exponential damping of the velocity, v ← v e^(−k h), see chapter 9.
template <class Real>
struct LinearDamping {
  static constexpr std::string_view name = "linear damping";
  static constexpr Quantities reads = quantity::velocity;
  static constexpr Phase phase = Phase::damping;
  Real rate = 0;      ///< k, 1/s, 0 or more
  Real fraction = 1;  ///< e^(−k h), which prepare() computes

  void check() const { checked_damping_rate(rate, "linear damping"); }
  //! [damping]
  void prepare(Real time_step) { fraction = fraction_kept(rate, time_step); }
  std::string_view skip_reason(const BodyFlags& flags) const {
    return rate == 0      ? "its rate is zero"
           : !flags.moves ? "at rest, and nothing can move them"
                          : "";
  }
  Vec3<Real> velocity(Particle<Real> centre, const StepTime<Real>&) const {
    damp(centre, fraction);
    return centre.velocity;
  }
  //! [damping]
  /// No fraction e^(−k h) is more than 1, however long the step.
  NoResponse response(const BodyState<Real>&) const { return {}; }
  template <class Wide>
  LinearDamping<Wide> broadcast() const {
    return {rate, fraction};
  }
};

/// Exponential damping of the spin, L ← L e^(−k h).
template <class Real>
struct AngularDamping {
  static constexpr std::string_view name = "angular damping";
  static constexpr Quantities reads = quantity::spin;
  static constexpr Phase phase = Phase::damping;
  Real rate = 0;      ///< k, 1/s, 0 or more
  Real fraction = 1;  ///< e^(−k h), which prepare() computes

  void check() const { checked_damping_rate(rate, "angular damping"); }
  void prepare(Real time_step) { fraction = fraction_kept(rate, time_step); }
  std::string_view skip_reason(const BodyFlags& flags) const {
    return rate == 0      ? "its rate is zero"
           : !flags.turns ? "no spin and nothing that can give torque"
                          : "";
  }
  Vec3<Real> angular_momentum_body(Top<Real> top, const StepTime<Real>&) const {
    damp(top, fraction);
    return top.angular_momentum_body;
  }
  /// No fraction e^(−k h) is more than 1, however long the step.
  NoResponse response(const BodyState<Real>&) const { return {}; }
  template <class Wide>
  AngularDamping<Wide> broadcast() const {
    return {rate, fraction};
  }
};

/// Drag that grows with the square of the speed through the air, see quadratic_drag().
template <class Real>
struct QuadraticDrag {
  static constexpr std::string_view name = "quadratic drag";
  static constexpr Quantities reads = quantity::velocity;
  Real coefficient = 0;                  ///< ½ ρ C A, kg/m, 0 or more: see drag_coefficient()
  Vec3<Real> wind = Vec3<Real>::Zero();  ///< m/s, world axes

  void check() const {
    require_not_negative("drag coefficient", coefficient, "kg/m");
    require_finite("wind", wind, "m/s");
  }
  std::string_view skip_reason(const BodyFlags& flags) const {
    return coefficient == 0                             ? "its coefficient is zero"
           : !flags.moves && wind == Vec3<Real>::Zero() ? "at rest in still air"
                                                        : "";
  }
  Vec3<Real> force(const Particle<Real>& centre, Real) const {
    return quadratic_drag(coefficient, centre.velocity, wind);
  }
  /// Of F = −c |u| u, where u is the velocity through the air, a small change δ of u makes −c (|u|
  /// δ + u (u·δ)/|u|): along u that is 2 c |u| times δ, and across it half as much.
  Response<Real> response(const BodyState<Real>& body) const {
    return {.damping = 2 * coefficient * (body.centre.velocity - wind).norm()};
  }
  template <class Wide>
  QuadraticDrag<Wide> broadcast() const {
    return {coefficient, wind.template cast<Wide>()};
  }
};

/// The Magnus force on a spinning ball, F = S ω × v: on the side where the skin runs with the air
/// it carries the air round the back, the air leaves bent towards the other side, and the ball is
/// pushed towards the first.
///
/// A slice of radius a carries the circulation 2π a² ω and feels ρ v times that for each metre
/// (Kutta and Joukowski); summed over the slices of a ball of radius r that makes S = 8/3 π ρ r³ in
/// air without friction. In honey it is π ρ r³ (Rubinow and Keller, 1961), and a real wake must be
/// measured.
template <class Real>
struct Magnus {
  static constexpr std::string_view name = "Magnus force";
  static constexpr Quantities reads = quantity::velocity | quantity::orientation | quantity::spin;
  Real strength = 0;                     ///< S, kg
  Vec3<Real> wind = Vec3<Real>::Zero();  ///< m/s, world axes

  void check() const {
    require_finite("strength of the Magnus force", strength, "kg");
    require_finite("wind", wind, "m/s");
  }
  //! [magnus]
  std::string_view skip_reason(const BodyFlags& flags) const {
    return strength == 0  ? "its strength is zero"
           : !flags.turns ? "no spin and nothing that can give torque"
                          : "";
  }
  Vec3<Real> force(const BodyState<Real>& body, Real) const {
    const Vec3<Real> through_air = body.centre.velocity - wind;
    return strength * angular_velocity_world(body.top).cross(through_air);
  }
  //! [magnus]
  template <class Wide>
  Magnus<Wide> broadcast() const {
    return {strength, wind.template cast<Wide>()};
  }
};

/// Buoyancy of a ball in a liquid that fills the half-space below a level surface: Archimedes'
/// force −ρ V g, where V is what of the ball lies below. A cap of depth d of a ball of radius r
/// holds V = π d² (r − d/3).
template <class Real>
struct Buoyancy {
  static constexpr std::string_view name = "buoyancy";
  static constexpr Quantities reads = quantity::position;
  Real density = 1000;        ///< ρ of the liquid, kg/m³, 0 or more
  Real radius = 0;            ///< r of the balls, m, 0 or more
  Real surface = 0;           ///< the height z of the surface, m
  Real gravity = Real(9.81);  ///< m/s², downwards along −z, 0 or more

  void check() const {
    require_not_negative("density of the liquid", density, "kg/m^3");
    require_not_negative("radius of a floating ball", radius, "m");
    require_finite("height of the surface", surface, "m");
    require_not_negative("gravity", gravity, "m/s^2");
  }
  std::string_view skip_reason(const BodyFlags&) const {
    return density == 0 || radius == 0 || gravity == 0 ? "it lifts nothing" : "";
  }
  //! [buoyancy]
  Vec3<Real> force(const Particle<Real>& centre, Real) const {
    const Real below = surface - centre.position.z() + radius;
    const Real depth = select(below < 0, Real(0), select(below > 2 * radius, 2 * radius, below));
    const Real volume = std::numbers::pi_v<Real> * depth * depth * (radius - depth / 3);
    return {0, 0, density * volume * gravity};
  }
  //! [buoyancy]
  /// As the ball leaves the water the area that the surface cuts from it vanishes, with a kink.
  int smoothness() const { return 1; }
  /// ρ g times the area that the surface cuts from the ball, at most that of a great circle.
  Response<Real> response(const BodyState<Real>&) const {
    return {.stiffness = density * gravity * std::numbers::pi_v<Real> * radius * radius};
  }
  template <class Wide>
  Buoyancy<Wide> broadcast() const {
    return {density, radius, surface, gravity};
  }
};

}  // namespace tumble
