#include <exercise/judge.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
struct Moving {
  Vec3<Real> place, velocity, spin;
};

template <class Real>
struct Pushed {
  Vec3<Real> force, torque, other_torque;
};

template <class Real>
Pushed<Real> pushed(Real coefficient, const Moving<Real>& a, const Moving<Real>& b) {
  const auto found = ask<std::vector<Vec3<Real>>>("pushed", coefficient, a.place, a.velocity,
                                                  a.spin, b.place, b.velocity, b.spin);
  require(found.size() == 3, "pushed no longer gives a force and two torques; leave it as it was");
  return {found[0], found[1], found[2]};
}

/// Numbers of a few units, some forty operations and a turn there and back.
template <class Real>
constexpr double tolerance = 256 * unit_roundoff<Real>;

template <class Real>
std::pair<Moving<Real>, Moving<Real>> two() {
  return {{{1, 0, 2}, {Real(0.5), -1, 0}, {2, 0, -1}}, {{-1, 1, 1}, {0, 1, 1}, {0, -1, Real(0.5)}}};
}

/// How fast the points half-way move against each other.
template <class Real>
Vec3<Real> sliding(const Moving<Real>& a, const Moving<Real>& b) {
  const Vec3<Real> arm = (b.place - a.place) / 2;
  return a.velocity + a.spin.cross(arm) - b.velocity + b.spin.cross(arm);
}

}  // namespace

EXERCISE_CHECK("A body that slides past another is braked by c times its speed") {
  using Vector = Vec3<Real>;
  const Vector zero = Vector::Zero();
  const Moving<Real> slides{zero, {3, 0, 0}, zero}, rests{{0, 0, 2}, zero, zero};
  const auto push = pushed<Real>(Real(0.5), slides, rests);
  Found("the force on a body that slides with 3 m/s past another, with c = 0.5 N s/m,", "N",
        push.force)
      .mistake(Vector(Real(1.5), 0, 0),
               "it drives the body on. Friction points against the sliding")
      .mistake(zero,
               "nothing is braked. Grease brakes sideways too, not only along the line from "
               "centre to centre")
      .mistake(Vector(-3, 0, 0), "where is the coefficient?")
      .must_be(Vector(Real(-1.5), 0, 0), tolerance<Real>);
}

EXERCISE_CHECK("Two bodies that move and turn as one feel nothing") {
  const auto [one, another] = two<Real>();
  require(pushed<Real>(1, one, another).force.norm() > Real(0.1),
          "two bodies that move and turn each in its own way feel nothing either");
  const Vec3<Real> velocity(1, -2, 0), spin(Real(0.5), 1, -1);
  Moving<Real> a{{1, 0, 2}, {}, spin}, b{{-1, 1, 1}, {}, spin};
  for (Moving<Real>* each : {&a, &b}) each->velocity = velocity + spin.cross(each->place);
  const auto push = pushed<Real>(1, a, b);
  const Vec3<Real> of_centres = b.velocity - a.velocity;
  const Vec3<Real> zero = Vec3<Real>::Zero();
  // The first body's axes, as `pushed` has them.
  const auto orientation = quaternion_of_rotation_vector<Real>(Vec3<Real>(1, 0, Real(0.5)));
  const Vec3<Real> arm = (b.place - a.place) / 2;
  const Vec3<Real> in_body_axes = (spin - rotate_back<Real>(orientation, spin)).cross(arm);
  Found("two bodies turn together as one piece of wood. The force in the joint", "N", push.force)
      .mistake(
          of_centres,
          "it brakes the turning of the whole, for the centres of mass move against each other. "
          "What rubs are the points of both at the joint: v + ω × r")
      .mistake(
          Vec3<Real>(2 * of_centres),
          "the spins have the wrong sign: a point at r moves with v + ω × r, where r leads from "
          "its own centre of mass")
      .mistake(in_body_axes,
               "the spin of the first is taken in its body axes, and all else in the world's")
      .must_be(zero, tolerance<Real>);
  Found("two bodies turn together as one piece of wood. The torque on the first", "N m",
        push.torque)
      .must_be(zero, tolerance<Real>);
  Found("two bodies turn together as one piece of wood. The torque on the second", "N m",
        push.other_torque)
      .must_be(zero, tolerance<Real>);
}

EXERCISE_CHECK("A pair gains no angular momentum from its joint") {
  const auto [a, b] = two<Real>();
  const auto push = pushed<Real>(1, a, b);
  require(push.force.norm() > Real(0.1),
          "two bodies that slide feel no force, " + shown(push.force));
  const Vec3<Real> couple = (a.place - b.place).cross(push.force);
  const Vec3<Real> gain = push.torque + push.other_torque + couple;
  Found(
      "the forces and torques of the joint together change the pair's angular momentum at a rate "
      "that",
      "N m", gain)
      .mistake(
          couple,
          "a pair begins to spin by itself. Each force acts at the joint and not at the centre of "
          "mass, so each has a torque, arm × force; or else yours cancel, where they must not")
      .mistake(
          Vec3<Real>(couple / 2),
          "a pair begins to spin by itself: one of the torques is missing, or has the wrong sign "
          "twice. The second's arm is opposite, and so is its force: its torque is the same as the "
          "first's")
      .mistake(Vec3<Real>(2 * couple),
               "the torques add to it, where they must take it away: is arm × force turned round?")
      .must_be(Vec3<Real>::Zero(), tolerance<Real>);
}

EXERCISE_CHECK("The joint takes away c times the square of the sliding speed, and never gives") {
  const auto both = two<Real>();  // no names of its parts: a lambda could not see them
  const Moving<Real>&a = both.first, &b = both.second;
  const Real c = Real(0.75);
  const auto push = pushed<Real>(c, a, b);
  const auto power = [&](const Pushed<Real>& p) {
    return p.force.dot(a.velocity - b.velocity) + p.torque.dot(a.spin) + p.other_torque.dot(b.spin);
  };
  const Vec3<Real> all = sliding(a, b), along = (b.place - a.place).normalized();
  const Real truth = -c * all.squaredNorm();
  Found(
      "the power of the joint, with c = 0.75 N s/m and a sliding of " + shown(all.norm()) + " m/s,",
      "W", power(push))
      .mistake(-truth, "it gives as much as it should take: a sign")
      .mistake(truth / c, "the coefficient is missing")
      .mistake(truth * c, "the coefficient counts twice")
      .mistake(
          Real(-c * (all - along.dot(all) * along).squaredNorm()),
          "only what goes across the line between the centres is braked. So they come together "
          "and part as if nothing were between them: grease brakes that too")
      .mistake(truth / 2, "half of what it should take: are the velocities those half-way?")
      .must_be(truth, 16 * tolerance<Real>);
  require(push.torque.norm() > 0,
          "the torque on the first is zero, though the force acts beside its centre of mass");
}
