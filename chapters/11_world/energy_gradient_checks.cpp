#include <support/checks.hpp>
#include <support/push_on.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

// The force of an effect that stores energy is the downhill slope of that energy, F = −∂U/∂x, and
// its torque the slope against a turn, τ = −∂U/∂φ. The energy is asked for in long double at points
// beside the body, the force in the precision that is checked. None of the two knows of the other.

namespace {

using Witness = long double;

template <class Real>
RigidBody<Witness> in_witness(const RigidBody<Real>& body) {
  RigidBody<Witness> wide;
  wide.centre.position = body.centre.position.template cast<Witness>();
  wide.centre.inverse_mass = body.centre.inverse_mass;
  wide.top.orientation = {body.top.orientation.real,
                          body.top.orientation.imaginary.template cast<Witness>()};
  return wide;
}

/// The body a little further along world axis `axis` (m), or turned a little about it (rad).
RigidBody<Witness> displaced(RigidBody<Witness> body, bool turned, int axis, Witness by) {
  Vec3<Witness> step = Vec3<Witness>::Zero();
  step[axis] = by;
  if (turned)
    body.top.orientation = quaternion_of_rotation_vector(step) * body.top.orientation;
  else
    body.centre.position += step;
  return body;
}

/// The slope of `energy` at 0, with the error of the difference quotient h⁴ U⁽⁵⁾/30.
template <class Energy>
Witness slope(const Energy& energy, Witness h) {
  return (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
}

/// Checks one force and torque against the slopes of `energy`, which takes a displaced body.
/// `roundings_of_force` (N) and `roundings_of_torque` (N m) bound what the effect rounds.
template <class Real, class Energy>
void check_slopes(const Energy& energy, const RigidBody<Real>& body, const Vec3<Real>& force,
                  const Vec3<Real>& torque, Witness roundings_of_force,
                  Witness roundings_of_torque) {
  for (const bool turned : {false, true})
    for (int axis = 0; axis < 3; ++axis) {
      CAPTURE(turned);
      CAPTURE(axis);
      const auto along = [&](Witness by) {
        return energy(displaced(in_witness(body), turned, axis, by));
      };
      const Witness coarse = slope(along, 0x1p-10L), fine = slope(along, 0x1p-11L);
      // Half the step leaves a sixteenth of the error: the difference bounds what the finer has.
      // The energy is known to u |U|, and the quotient divides that by its step.
      const Witness error =
          std::abs(coarse - fine) + 0x1p12L * unit_roundoff<Witness> * (1 + std::abs(along(0)));
      REQUIRE(error < 1e-8L);  // a slope, and no kink
      CHECK(std::abs((turned ? torque : force)[axis] + fine) <=
            error + (turned ? roundings_of_torque : roundings_of_force));
    }
}

template <class Real, class Effect>
void check_effect(const Effect& effect, const RigidBody<Real>& body, Witness force_scale,
                  Witness arm) {
  const EffectOf<Real, Effect> ours(effect);
  REQUIRE(ours.traits().stores_energy);
  const auto witness = effect.template broadcast<Witness>();
  const auto energy = [&](const RigidBody<Witness>& at) {
    return witness.potential_energy({at.centre, at.top});
  };
  const Push<Real> push = push_on<Real>(ours, {body.centre, body.top}, 0);
  const Witness roundings = 64 * static_cast<Witness>(unit_roundoff<Real>) * force_scale;
  check_slopes(energy, body, push.force, push.torque, roundings, 2 * arm * roundings);
}

/// A body of 1 to 3 kg somewhere within 3 m, facing anywhere.
template <class Real>
RigidBody<Real> drawn_body(RandomGenerator& dice) {
  RigidBody<Real> body;
  body.centre = make_particle<Real>(2 + dice.real<Real>(), 3 * dice.vector<Real>());
  body.top.orientation = quaternion_of_rotation_vector<Real>(3 * dice.vector<Real>());
  return body;
}

/// A spring, with its damper: nothing moves here, so that gives no force.
template <class Real>
Spring<Real> drawn_spring(RandomGenerator& dice) {
  return {.stiffness = 2 + dice.real<Real>(),
          .damping = 1,
          .rest_length = 2 + dice.real<Real>(),
          .only_pulls = dice.one_in(2)};
}

/// What a spring's force rounds is so many times this, N: its extent is a difference of places, and
/// its direction is uncertain by what the extent has lost.
template <class Real>
Witness scale_of(const Spring<Real>& spring, Witness places, Witness length) {
  return spring.stiffness * places * (1 + spring.rest_length / length);
}

/// Whether the slope is that of a smooth function: not where a tether goes slack, and not where
/// the direction of a spring turns within the stencil.
template <class Real>
bool is_smooth(const Spring<Real>& spring, Real length) {
  return length > Real(0.5) && std::abs(length - spring.rest_length) > Real(0.02);
}

}  // namespace

TEST_CASE_TEMPLATE("The force of each gravity is the slope of its energy, and it gives no torque",
                   Real, EVERY_PRECISION) {
  RandomGenerator dice(41);
  for (int trial = 0; trial < 50; ++trial) {
    const RigidBody<Real> body = drawn_body<Real>(dice);
    const Vec3<Real> g = 10 * dice.vector<Real>(), centre = 2 * dice.vector<Real>();
    const Witness weight = 3 * g.norm();
    check_effect(Gravity<Real>{g}, body, weight, 0);
    check_effect(GravityAsAcceleration<Real>{g}, body, weight, 0);
    const Witness r = (body.centre.position - centre).norm();
    const Real strength = 2 + dice.real<Real>();
    if (r > 1)
      check_effect(PointGravity<Real>{strength, centre}, body,
                   3 * strength / (r * r) * (body.centre.position.norm() + centre.norm()) / r, 0);
  }
}

TEST_CASE_TEMPLATE("Force and torque of a spring to a point are the slopes of its energy", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(42);
  int slack = 0, taut = 0;
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    const RigidBody<Real> body = drawn_body<Real>(dice);
    const SpringToPoint<Real> effect{.spring = drawn_spring<Real>(dice),
                                     .anchor = 2 * dice.vector<Real>(),
                                     .attachment = dice.vector<Real>()};
    const Vec3<Real> arm = arm_of<Real>({body.centre, body.top}, effect.attachment);
    const Real length = (body.centre.position + arm - effect.anchor).norm();
    if (!is_smooth(effect.spring, length)) continue;
    const Real places = body.centre.position.norm() + effect.anchor.norm() + arm.norm();
    check_effect(effect, body, scale_of(effect.spring, places, length), arm.norm());
    ++(effect.spring.only_pulls && length < effect.spring.rest_length ? slack : taut);
  }
  CHECK(slack > 5);
  CHECK(taut > 50);
}

TEST_CASE_TEMPLATE("Force and torques of a spring between bodies are the slopes of its energy",
                   Real, EVERY_PRECISION) {
  RandomGenerator dice(43);
  int tried = 0;
  for (int trial = 0; trial < 100; ++trial) {
    CAPTURE(trial);
    const RigidBody<Real> first = drawn_body<Real>(dice), second = drawn_body<Real>(dice);
    const SpringBetween<Real> effect{.spring = drawn_spring<Real>(dice),
                                     .attachment_first = dice.vector<Real>(),
                                     .attachment_second = dice.vector<Real>()};
    const BodyState<Real> state{first.centre, first.top}, other{second.centre, second.top};
    const Vec3<Real> arm = arm_of<Real>(state, effect.attachment_first);
    const Vec3<Real> other_arm = arm_of<Real>(other, effect.attachment_second);
    const Real length = (first.centre.position + arm - second.centre.position - other_arm).norm();
    if (!is_smooth(effect.spring, length)) continue;
    ++tried;
    const EffectOf<Real, SpringBetween<Real>> ours(effect);
    REQUIRE(ours.traits().stores_energy);
    const PairPush<Real> push = push_on<Real>(ours, state, other, 0);
    const SpringBetween<Witness> witness{
        .spring = {effect.spring.stiffness, effect.spring.damping, effect.spring.rest_length,
                   effect.spring.only_pulls},
        .attachment_first = effect.attachment_first.template cast<Witness>(),
        .attachment_second = effect.attachment_second.template cast<Witness>()};
    const RigidBody<Witness> wide_first = in_witness(first), wide_second = in_witness(second);
    const Witness places = first.centre.position.norm() + second.centre.position.norm() +
                           arm.norm() + other_arm.norm();
    const Witness roundings =
        64 * static_cast<Witness>(unit_roundoff<Real>) * scale_of(effect.spring, places, length);
    check_slopes(
        [&](const RigidBody<Witness>& at) {
          return witness.potential_energy({at.centre, at.top},
                                          {wide_second.centre, wide_second.top});
        },
        first, push.force_on_first, push.torque_on_first, roundings, 2 * arm.norm() * roundings);
    check_slopes(
        [&](const RigidBody<Witness>& at) {
          return witness.potential_energy({wide_first.centre, wide_first.top}, {at.centre, at.top});
        },
        second, Vec3<Real>(-push.force_on_first), push.torque_on_second, roundings,
        2 * other_arm.norm() * roundings);
  }
  CHECK(tried > 50);
}
