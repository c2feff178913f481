#include <array>
#include <exercise/judge.hpp>
#include <tumble/mass_properties.hpp>
#include <tumble/torque.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// A body without any symmetry: a handful of particles.
template <class Real>
MassProperties<Real> odd_body() {
  using Vector = Vec3<Real>;
  auto body = mass_properties(std::vector<Particle<Real>>{
      make_particle(Real(1), Vector(1, 0, 0)), make_particle(Real(2), Vector(0, 1, 1)),
      make_particle(Real(3), Vector(-1, 2, 0)), make_particle(Real(2), Vector(0, -1, 2))});
  return body;
}

template <class Real>
Vec3<Real> after_blow(const MassProperties<Real>& body, const Vec3<Same<Real>>& blow,
                      const Vec3<Same<Real>>& at, const Vec3<Same<Real>>& point) {
  return ask<Vec3<Real>>("velocity_after_blow", body, blow, at, point);
}

/// The inverse of a tensor with moments near 10 multiplies roundings by less than 10; all
/// velocities stay below 4 m/s.
template <class Real>
constexpr double some_roundings = 10 * 4 * 32 * unit_roundoff<Real>;

}  // namespace

EXERCISE_CHECK("A blow at the centre of mass moves every point alike") {
  const auto body = odd_body<Real>();
  const Vec3<Real> blow(4, -8, 2), centre(0, 0, 0);
  for (const Vec3<Real>& point : {Vec3<Real>(0, 0, 0), Vec3<Real>(1, 0, 0), Vec3<Real>(0, 2, -1)})
    Found("the velocity of a point of 8 kg struck at its centre of mass with (4, -8, 2) N s", "m/s",
          after_blow(body, blow, centre, point))
        .mistake(blow, "that is the blow itself; divide it by the mass")
        .must_be(Vec3<Real>(blow / 8), some_roundings<Real>);
}

EXERCISE_CHECK("What a blow w at a does to b along u, a blow u at b does to a along w") {
  // Maxwell's reciprocity, which holds because the tensor is symmetric: u·v_b of a blow w at a is
  // w·v_a of a blow u at b.
  const auto body = odd_body<Real>();
  const Vec3<Real> a(1, -1, Real(0.5)), b(-1, Real(0.25), 2);
  const Vec3<Real> u(1, 2, -1), w(-2, 1, 1);
  const Real there = u.dot(after_blow(body, w, a, b)), back = w.dot(after_blow(body, u, b, a));
  const Real straight = u.dot(after_blow(body, w, Vec3<Real>::Zero(), b));
  require(std::abs(double(there) - double(straight)) > 100 * some_roundings<Real>,
          "a blow beside the centre of mass moves every point as one at the centre does. Where is "
          "the turn?");
  Found("the velocity at b along u after a blow w at a", "m/s", there)
      .must_be(back, 4 * some_roundings<Real>);
}

EXERCISE_CHECK(
    "The blow's work is the energy of the body: half of the blow times the velocity where it "
    "hits") {
  const auto body = odd_body<Real>();
  const Vec3<Real> blow(1, 2, -1), at(1, -1, Real(0.5));
  const Vec3<Real> struck = after_blow(body, blow, at, at);
  const Vec3<Real> spin = body.inertia.inverse() * at.cross(blow);
  const Real moving = blow.squaredNorm() / body.mass / 2,
             turning = spin.dot(body.inertia * spin) / 2;
  Found("half of the blow times the velocity of the point that it hits", "J", blow.dot(struck) / 2)
      .mistake(moving, "that is the energy of moving. The body also turns")
      .mistake(moving - turning,
               "the turn takes energy away. The velocity of the turn is ω × r, with r last")
      .must_be(moving + turning, 4 * some_roundings<Real>);
}

EXERCISE_CHECK("A blow at the sweet spot leaves the grip at rest") {
  for (const auto& [m, l, held_at] : {std::array{1.0, 1.2, 0.5}, std::array{0.85, 1.1, 0.4}}) {
    const Real mass = Real(m), length = Real(l), grip = Real(held_at),
               moment = mass * length * length / 12;
    const Real found = ask<Real>("sweet_spot", mass, moment, grip);
    MassProperties<Real> bat{.mass = mass};
    bat.inertia.diagonal() << Real(0.001), moment, moment;  // along x
    const Vec3<Real> blow(0, 2, 0);
    const auto velocity_of_grip = [&](Real at) {
      return blow.y() / mass - at * blow.y() / moment * grip;
    };
    Found("the velocity of the grip when a bat of " + shown(mass) +
              " kg is hit at the place found, " + shown(found) + " m,",
          "m/s", velocity_of_grip(found))
        .mistake(velocity_of_grip(grip),
                 "the place mirrors the grip. Set the velocity of the grip to zero, and solve for "
                 "the distance")
        .mistake(velocity_of_grip(moment * mass / grip),
                 "the mass is in the numerator; it belongs in the denominator")
        .mistake(velocity_of_grip(moment / grip), "the mass of the bat is missing")
        .mistake(velocity_of_grip(length / 6),
                 "a sixth of the length is right for a bat held at its very end")
        .mistake(velocity_of_grip(-moment / (mass * grip)),
                 "the place is on the grip's own side: the sign is the other one")
        .must_be(0, 64 * unit_roundoff<Real>);
    Found("the velocity of the grip by your own velocity_after_blow", "m/s",
          after_blow(bat, blow, Vec3<Real>(found, 0, 0), Vec3<Real>(-grip, 0, 0)))
        .must_be(Vec3<Real>::Zero(), some_roundings<Real>);
  }
}
