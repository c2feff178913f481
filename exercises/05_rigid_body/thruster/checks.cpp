#include <exercise/judge.hpp>
#include <tumble/rigid_body.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// 4 kg with three different moments.
template <class Real>
RigidBody<Real> craft(const Vec3<Same<Real>>& position = Vec3<Real>::Zero(),
                      const Vec3<Same<Real>>& turn = Vec3<Real>::Zero()) {
  RigidBody<Real> body;
  body.centre = make_particle<Real>(4, position);
  body.top.orientation = quaternion_of_rotation_vector<Real>(turn);
  body.top.inverse_moments = Vec3<Real>(1, Real(0.5), Real(0.25));
  return body;
}

template <class Real>
RigidBody<Real> fired(const RigidBody<Real>& body, const Vec3<Same<Real>>& place,
                      const Vec3<Same<Real>>& thrust) {
  return ask<RigidBody<Real>>("fire", body, place, thrust);
}

template <class Real>
constexpr Real quarter_turn = std::numbers::pi_v<Real> / 2;

/// Two rotations with 40 roundings each and a cross product, of numbers below `size`.
template <class Real>
double roundings(double size) {
  return 3 * 40 * size * unit_roundoff<Real>;
}

}  // namespace

EXERCISE_CHECK("On a craft that is not turned a jet pushes with its thrust and twists with r × F") {
  using Vector = Vec3<Real>;
  const Real thrust = Real(parameter("thrust"));
  const auto body = fired(craft<Real>(), Vector(3, 0, 0), Vector(0, thrust, 0));
  Found("the force of a jet of " + shown(thrust) + " N along y", "N", body.centre.force)
      .mistake(Vector::Zero(), "no force came to the body. add_force_at adds it")
      .must_be(Vector(0, thrust, 0), 0);
  Found("the torque of a jet at the nose, 3 m along x,", "N m", body.top.torque)
      .mistake(Vector(0, 0, -3 * thrust), "it twists the wrong way: r × F, with r first")
      .mistake(Vector::Zero(), "it does not twist. The jet pushes at the nose, not at the centre")
      .must_be(Vector(0, 0, 3 * thrust), 0);
}

EXERCISE_CHECK("Turn the craft, and push and twist turn with it") {
  using Vector = Vec3<Real>;
  const Real thrust = Real(parameter("thrust"));
  const double tolerance = roundings<Real>(3 * 16);
  const auto turned = fired(craft<Real>(Vector::Zero(), Vector(0, 0, quarter_turn<Real>)),
                            Vector(3, 0, 0), Vector(0, thrust, 0));
  Found("the force on a craft turned by 90° about z", "N", turned.centre.force)
      .mistake(Vector(0, thrust, 0),
               "the jet still pushes along the world's y. It is bolted on, so its push turns with "
               "the craft")
      .mistake(Vector(thrust, 0, 0),
               "it was turned the other way: rotate takes body axes to world axes, rotate_back the "
               "other way")
      .must_be(Vector(-thrust, 0, 0), tolerance);
  const double size = 3 * double(thrust);
  Found("the torque on a craft turned by 90° about z", "N m", turned.top.torque)
      .mistake(Vector::Zero(),
               "the force was turned and the place was not: the push seems to go straight through "
               "the centre")
      .must_be(Vector(0, 0, Real(size)), tolerance);

  const Vector turn(Real(0.5), -1, Real(0.25)), place(1, -2, Real(0.5)), push(2, 1, thrust);
  const auto q = quaternion_of_rotation_vector(turn);
  const auto slanted = fired(craft<Real>(Vector::Zero(), turn), place, push);
  Found("the torque on a craft turned about a slanted axis", "N m", slanted.top.torque)
      .mistake(place.cross(push),
               "that is the torque in body axes. The accumulator holds world axes")
      .mistake(place.cross(rotate(q, push)), "the place of the jet was not turned")
      .mistake(rotate(q, place).cross(push), "the push of the jet was not turned")
      .must_be(rotate(q, Vector(place.cross(push))), tolerance);
}

EXERCISE_CHECK("Where in the world the craft is changes neither push nor twist") {
  using Vector = Vec3<Real>;
  const Real thrust = Real(parameter("thrust"));
  const Vector turn(Real(0.5), -1, Real(0.25)), place(1, -2, Real(0.5)), push(2, 1, thrust);
  const Vector position(100, -50, 25);
  const auto q = quaternion_of_rotation_vector(turn);
  const Vector force = rotate(q, push), truth = rotate(q, Vector(place.cross(push)));
  const auto before = craft<Real>(position, turn), body = fired(before, place, push);
  // The position is added and taken away again, which rounds at its own size.
  const double tolerance = roundings<Real>(128 * 32);
  Found("the torque of a craft 100 m from the origin", "N m", body.top.torque)
      .mistake(Vector(rotate(q, place) - position).cross(force),
               "the place of the jet was turned, but not carried to where the craft is. The world "
               "counts from its own origin")
      .mistake(Vector(place - position).cross(force),
               "the place of the jet was handed on as it is, in body axes and from the centre")
      .mistake(place.cross(force), "the place was carried, but not turned")
      .mistake(Vector(rotate(q, Vector(position + place)) - position).cross(force),
               "the position was added before the turn, so it was turned as well")
      .must_be(truth, tolerance);
  Found("the force on a craft 100 m from the origin", "N", body.centre.force)
      .must_be(force, roundings<Real>(32));
  require(body.centre.position == position && body.centre.velocity.isZero(0) &&
              body.top.orientation.real == before.top.orientation.real &&
              body.top.orientation.imaginary == before.top.orientation.imaginary &&
              body.top.angular_momentum_body.isZero(0),
          "the craft has moved, turned or changed its velocity or spin. Force and torque only "
          "gather; the step comes later");
}

EXERCISE_CHECK("Two jets add: side by side against each other they only twist") {
  using Vector = Vec3<Real>;
  const Real thrust = Real(parameter("thrust"));
  auto body = craft<Real>(Vector(1, 2, 3));
  body = fired(body, Vector(2, 0, 0), Vector(0, thrust, 0));
  body = fired(body, Vector(-2, 0, 0), Vector(0, -thrust, 0));
  Found("the force of two jets against each other", "N", body.centre.force)
      .mistake(Vector(0, -thrust, 0), "only the second is there. Each adds to what acts already")
      .must_be(Vector::Zero(), 0);
  Found("the torque of two jets against each other, 4 m apart,", "N m", body.top.torque)
      .mistake(Vector(0, 0, 2 * thrust), "only one is there. Each adds to what acts already")
      .must_be(Vector(0, 0, 4 * thrust), roundings<Real>(64));
  require(body.centre.position == Vector(1, 2, 3) && body.centre.velocity.isZero(0),
          "the craft has moved. A force only gathers; the step comes later");
}
