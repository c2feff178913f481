/// @file
/// The terms in which effects and steps are described: phases, flags, pushes, responses and step
/// times.
#pragma once

#include <tumble/bodies.hpp>

namespace tumble {

/// The parts of a step, in which effects act; step_order.hpp has their order.
enum class Phase {
  force,    ///< forces and torques are summed; nothing moves
  kick,     ///< the sums change the momenta
  impulse,  ///< blows meet the new velocities
  damping,  ///< speeds fade
  turn,     ///< rotors inside bodies share their angular momentum, at either end of each drift
  drift     ///< positions and orientations follow
};

/// What is known of a body between two changes of the scene. A predicate asks this and nothing
/// else, so its answer holds until somebody changes the scene.
//! [flags]
struct BodyFlags {
  bool is_static = false;      ///< no force can move it
  bool is_point = false;       ///< it has no top
  bool can_turn = false;       ///< it has a top that is not locked about all axes
  bool is_gyroscopic = false;  ///< its moments differ, and no axis is locked
  bool is_pushed = false;      ///< an effect, or a push, gives it a force
  bool is_torqued = false;     ///< an effect, or a push, gives it a torque
  bool moves = false;          ///< it has had a velocity, or something can give it one
  bool turns = false;          ///< it has had a spin, or something can give it one
  friend bool operator==(const BodyFlags&, const BodyFlags&) = default;
};
//! [flags]

/// What one effect does to one body in the force phase, both in world axes.
template <class Real>
struct Push {
  Vec3<Real> force = Vec3<Real>::Zero();   ///< N, at the centre of mass
  Vec3<Real> torque = Vec3<Real>::Zero();  ///< N m, about the centre of mass
};

/// What one effect does to two bodies that it joins: the force on the first, its opposite on the
/// second, and a torque on each about its own centre of mass. World axes.
template <class Real>
struct PairPush {
  Vec3<Real> force_on_first = Vec3<Real>::Zero();    ///< N
  Vec3<Real> torque_on_first = Vec3<Real>::Zero();   ///< N m
  Vec3<Real> torque_on_second = Vec3<Real>::Zero();  ///< N m
};

/// What a blow does to two bodies: the impulse on the first, its opposite on the second, and an
/// angular impulse on each about its own centre of mass. World axes.
template <class Real>
struct PairImpulse {
  Vec3<Real> impulse_on_first = Vec3<Real>::Zero();           ///< N s
  Vec3<Real> angular_impulse_on_first = Vec3<Real>::Zero();   ///< N m s
  Vec3<Real> angular_impulse_on_second = Vec3<Real>::Zero();  ///< N m s
};

/// How an effect answers small changes of where a body is, which way it faces and how fast it moves
/// and turns: what limits the time step. An effect that has response() for a body, or for two, is
/// taken into account. The matrices are symmetric, in world axes, and drive nothing: no eigenvalue
/// is negative. Of two bodies they answer how the first has turned and turns relative to the
/// second. What acts at the centre, such as a magnet of k N/m, returns {.stiffness = k}; see
/// \ref step_limits.
//! [response]
template <class Real>
struct Response {
  Real stiffness = 0;  ///< the most that the force changes for a metre, in any direction, N/m
  Real damping = 0;    ///< and for a metre a second, N s/m
  Vec3<Real> arm_first = Vec3<Real>::Zero();   ///< from the (first) body's centre, m, world axes
  Vec3<Real> arm_second = Vec3<Real>::Zero();  ///< from the second's
  Vec3<Real> force = Vec3<Real>::Zero();       ///< on the first at that arm, N, world axes
  Mat3<Real> turning_stiffness = Mat3<Real>::Zero();  ///< K of the torque −K θ − C ω, N m/rad
  Mat3<Real> turning_damping = Mat3<Real>::Zero();    ///< C of it, N m s/rad
};

/// What response() returns if the effect can't feed on itself, however long the step.
struct NoResponse {};
//! [response]

/// Two bodies that an effect joins.
struct BodyPair {
  BodyIndex first, second;
};

/// When something acts in a step, and for how long. In the phases force and kick: when its kick
/// happens, and how long that is; in the phase turn: when the rotor acts, and how long the drift
/// is; else when the step begins, and how long that is. By Scheme::suzuki some of these lengths are
/// negative.
template <class Real>
struct StepTime {
  Real time = 0;       ///< s
  Real time_step = 0;  ///< s; negative: backwards
};

}  // namespace tumble
