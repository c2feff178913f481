#include <exercise/judge.hpp>
#include <tumble/rigid_body.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// Tensors, arms and speeds below are less than 10, in their units, and so is what the inverse of
/// the pair's tensor makes of a vector. Two products of rotation matrices and their inverse stay
/// below 200 roundings of such numbers.
template <class Real>
constexpr double roundings = 10 * 200 * unit_roundoff<Real>;

template <class Real>
RigidBody<Real> craft(Same<Real> mass, const Vec3<Same<Real>>& moments,
                      const Vec3<Same<Real>>& position, const Vec3<Same<Real>>& velocity,
                      const Vec3<Same<Real>>& turn = Vec3<Real>::Zero(),
                      const Vec3<Same<Real>>& spin = Vec3<Real>::Zero()) {
  RigidBody<Real> body;
  body.centre = make_particle<Real>(mass, position, velocity);
  body.top.inverse_moments = moments.cwiseInverse();
  body.top.orientation = quaternion_of_rotation_vector<Real>(turn);
  set_angular_velocity_world<Real>(body.top, spin);
  return body;
}

template <class Real>
using Bodies = std::pair<RigidBody<Real>, RigidBody<Real>>;

/// Two that differ in everything.
template <class Real>
Bodies<Real> two_craft() {
  using Vector = Vec3<Real>;
  return {craft<Real>(4, Vector(2, 3, 4), Vector(1, 2, -1), Vector(1, 0, Real(0.5)),
                      Vector(Real(0.5), -1, Real(0.25)), Vector(Real(0.5), 1, -1)),
          craft<Real>(2, Vector(1, Real(1.5), 2), Vector(3, 1, 1), Vector(0, -1, 1),
                      Vector(1, Real(0.5), Real(-0.5)), Vector(1, Real(-0.5), Real(0.25)))};
}

template <class Real>
Vec3<Real> asked(const char* function, const Bodies<Real>& pair) {
  return ask<Vec3<Real>>(function, pair.first, pair.second);
}

/// The two as they move once they hold each other, by the student's answers.
template <class Real>
Bodies<Real> docked(const Bodies<Real>& pair) {
  const auto centre = asked("common_centre", pair), velocity = asked("common_velocity", pair),
             spin = asked("common_spin", pair);
  Bodies<Real> after = pair;
  for (RigidBody<Real>* body : {&after.first, &after.second}) {
    body->centre.velocity = velocity + spin.cross(body->centre.position - centre);
    set_angular_velocity_world<Real>(body->top, spin);
  }
  return after;
}

template <class Real>
Vec3<Real> total_about(const Bodies<Real>& pair, const Vec3<Same<Real>>& point) {
  return angular_momentum_about<Real>(pair.first, point) +
         angular_momentum_about<Real>(pair.second, point);
}

template <class Real>
Real energy(const Bodies<Real>& pair) {
  return kinetic_energy(pair.first) + kinetic_energy(pair.second);
}

}  // namespace

EXERCISE_CHECK("The pair moves as fast as the momenta of both say, at the mean of their places") {
  using Vector = Vec3<Real>;
  const Vector moments(1, 1, 1);
  const Bodies<Real> pair{craft<Real>(3, moments, Vector(0, 4, 0), Vector(4, 0, 0)),
                          craft<Real>(1, moments, Vector(8, 0, 0), Vector(0, -4, 0))};
  Found("the common centre of 3 kg at (0, 4, 0) and 1 kg at (8, 0, 0)", "m",
        asked("common_centre", pair))
      .mistake(Vector(4, 2, 0), "that is halfway. Weigh each place by its mass")
      .mistake(Vector(6, 1, 0), "the masses are exchanged: it lies nearer the heavier")
      .must_be(Vector(2, 3, 0), roundings<Real>);
  Found("the velocity of the pair of 3 kg with (4, 0, 0) m/s and 1 kg with (0, -4, 0) m/s", "m/s",
        asked("common_velocity", pair))
      .mistake(Vector(2, -2, 0), "that is the mean of the velocities. Weigh each by its mass")
      .mistake(Vector(12, -4, 0), "that is the momentum; divide it by the mass of both")
      .must_be(Vector(3, -1, 0), roundings<Real>);
}

EXERCISE_CHECK("Two craft that already move as one body notice nothing") {
  Bodies<Real> pair = two_craft<Real>();
  const Vec3<Real> spin(Real(0.5), -1, Real(0.75)), velocity(1, 2, 3), hub(2, 0, 1);
  Vec3<Real> own = Vec3<Real>::Zero();
  for (RigidBody<Real>* body : {&pair.first, &pair.second}) {
    body->centre.velocity = velocity + spin.cross(body->centre.position - hub);
    set_angular_velocity_world<Real>(body->top, spin);
    own += angular_momentum_world(body->top);
  }
  const Mat3<Real> tensors = world_inertia(pair.first.top) + world_inertia(pair.second.top);
  const Vec3<Real> centre =
      (4 * pair.first.centre.position + 2 * pair.second.centre.position) / Real(6);
  const Mat3<Real> in_body = Mat3<Real>(moments_of(pair.first.top).asDiagonal()) +
                             Mat3<Real>(moments_of(pair.second.top).asDiagonal()) +
                             inertia_of_particle<Real>(4, pair.first.centre.position - centre) +
                             inertia_of_particle<Real>(2, pair.second.centre.position - centre);
  const Vec3<Real> L = total_about(pair, centre);
  const Mat3<Real> both = tensors +
                          inertia_of_particle<Real>(4, pair.first.centre.position - centre) +
                          inertia_of_particle<Real>(2, pair.second.centre.position - centre);
  Found("the spin of two craft that turned together before they docked", "rad/s",
        asked("common_spin", pair))
      .mistake(tensors.inverse() * L,
               "the pair turns faster than before, as if its mass were not spread out. Where is "
               "the parallel axis?")
      .mistake(both.inverse() * own,
               "only the spins of the two count in it. Each also flies past the common centre")
      .mistake(in_body.inverse() * L,
               "each tensor was taken in its own body's axes. Bring both to the world's first")
      .mistake(both.inverse() * total_about(pair, Vec3<Real>::Zero()),
               "the angular momentum is that about the world's origin, the tensor about another "
               "point. Take both about the common centre")
      .mistake(L, "that is the angular momentum. Which spin has it?")
      .must_be(spin, roundings<Real>);
}

EXERCISE_CHECK("A craft that passes by brings angular momentum though it doesn't spin") {
  using Vector = Vec3<Real>;
  // Two balls of 2 kg and 1 kg m², two metres apart along x, that pass each other along y.
  const Vector moments(1, 1, 1);
  const Bodies<Real> pair{craft<Real>(2, moments, Vector(1, 0, 0), Vector(0, 3, 0)),
                          craft<Real>(2, moments, Vector(-1, 0, 0), Vector(0, -3, 0))};
  // L = 2·(1·2·3) = 12; I = 2·(1 + 2·1²) = 6.
  Found("the spin of two balls that grasp each other as they pass", "rad/s",
        asked("common_spin", pair))
      .mistake(
          Vector::Zero(),
          "it is zero, since neither ball spins. But each flies past the common centre: r × m v "
          "is angular momentum too")
      .mistake(Vector(0, 0, 6),
               "too fast: the balls resist with their own moments, and also because they are away "
               "from the axis")
      .mistake(Vector(0, 0, 3),
               "that is how fast the line between them turned before. Now the balls turn with it, "
               "and share the same angular momentum")
      .mistake(Vector(0, 0, -2), "it turns the wrong way: r × m v, with r first")
      .must_be(Vector(0, 0, 2), roundings<Real>);
}

EXERCISE_CHECK("The angular momentum of both together stays, about any point") {
  const Bodies<Real> before = two_craft<Real>(), after = docked(before);
  const Vec3<Real> momentum_before = momentum(before.first) + momentum(before.second);
  Found("the momentum of both together after docking", "N s",
        Vec3<Real>(momentum(after.first) + momentum(after.second)))
      .must_be(momentum_before, 10 * roundings<Real>);
  for (const Vec3<Real>& point : {Vec3<Real>(0, 0, 0), Vec3<Real>(2, -3, 1)})
    Found("the angular momentum about " + shown(point) + " m after docking", "kg m²/s",
          total_about(after, point))
        .must_be(total_about(before, point), 10 * roundings<Real>);
}

EXERCISE_CHECK("Docking gains no energy, and head-on it loses just that of the approach") {
  using Vector = Vec3<Real>;
  const Bodies<Real> before = two_craft<Real>();
  const Real gained = energy(docked(before)) - energy(before);
  require(gained < 0, "docking changes the energy by " + shown(gained) +
                          " J. No motor runs: what the clamps take up is lost, so it must fall");
  const Vector moments(1, 1, 1);
  const Bodies<Real> head_on{craft<Real>(3, moments, Vector(-1, 0, 0), Vector(Real(2.25), 0, 0)),
                             craft<Real>(1, moments, Vector(1, 0, 0), Vector(Real(-1.75), 0, 0))};
  // ½ μ v² with μ = 3/4 kg and v = 4 m/s.
  Found("the energy that is lost when 3 kg and 1 kg meet head-on at 4 m/s", "J",
        energy(head_on) - energy(docked(head_on)))
      .mistake(energy(head_on), "they lose all of it, as if they stood still afterwards")
      .mistake(0, "nothing is lost, as if they bounced off each other")
      .must_be(6, 10 * roundings<Real>);
}
