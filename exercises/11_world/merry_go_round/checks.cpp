#include <exercise/judge.hpp>
#include <tumble/particle.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// 2 kg alone could stand for the 2 of Coriolis's force, or cancel the ½ of the energy.
constexpr int two_masses[] = {2, 5};

template <class Real>
Vec3<Real> force_on(const Vec3<Real>& position, const Vec3<Real>& velocity, const Vec3<Real>& spin,
                    int mass = 2) {
  return ask<Vec3<Real>>("force_on", make_particle(Real(mass), position, velocity), spin);
}

template <class Real>
Real energy_at(const Vec3<Real>& position, const Vec3<Real>& spin, int mass) {
  return ask<Real>("potential_energy_of", make_particle(Real(mass), position), spin);
}

/// Numbers of a few dozen units and some twenty operations.
template <class Real>
constexpr double tolerance = 64 * 32 * unit_roundoff<Real>;

}  // namespace

EXERCISE_CHECK(
    "What rests on board is pushed straight outward, with m Ω² times its distance from the axis") {
  using Vector = Vec3<Real>;
  const Vector place(3, -4, 5), spin(0, 0, 2), zero = Vector::Zero();
  const Vector truth(24, -32, 0);
  Found("with 2 rad/s about z, the force on 2 kg at rest at (3, -4, 5) m", "N",
        force_on<Real>(place, zero, spin))
      .mistake(Vector(-truth),
               "it pulls inward. That is what holds a rider; what he feels is the opposite")
      .mistake(Vector(truth / 2),
               "half of it: is the mass of 2 kg missing, or one of the two crosses?")
      .mistake(Vector(truth / 4), "a quarter of it: where is the rate? It counts with its square")
      .mistake(Vector(2 * truth), "twice as much. The 2 belongs to the other force, Coriolis's")
      .mistake(Vector(24, -32, 40),
               "it has a part along the axis. Ω × (Ω × x) has none: take both "
               "cross products, not Ω² x")
      .mistake(zero, "nothing. The outward part of the force is missing")
      .must_be(truth, tolerance<Real>);
}

EXERCISE_CHECK(
    "What moves on board is pushed sideways with 2 m Ω times its speed, and no work is done") {
  using Vector = Vec3<Real>;
  const Vector zero = Vector::Zero(), velocity(3, 0, 1), spin(0, 0, 2), truth(0, -24, 0);
  Found("with 2 rad/s about z, the force on 2 kg on the axis that moves with (3, 0, 1) m/s", "N",
        force_on<Real>(zero, velocity, spin))
      .mistake(Vector(-truth),
               "to the left, where on a wheel that turns left a throw bends to the right. Is the "
               "cross product turned round, or a sign lost?")
      .mistake(
          Vector(truth / 2),
          "half of it. The 2 is real: the velocity turns along with the frame, and the place from "
          "which one is carried changes too")
      .mistake(zero, "nothing. Coriolis's part of the force is missing")
      .must_be(truth, tolerance<Real>);
  const Vector tilted(1, -2, Real(0.5)), fast(-2, 1, 3);
  const Real power = (force_on<Real>(zero, fast, tilted)).dot(fast);
  Found("on the axis of a tilted merry-go-round, the power of the force", "W", power)
      .must_be(0, 8 * tolerance<Real>);
}

EXERCISE_CHECK(
    "What rests on the ground is seen to go round in a circle, and this force holds it on that "
    "circle") {
  using Vector = Vec3<Real>;
  const Vector spin(Real(0.5), -1, 2), place(1, 2, -1);
  // Seen from on board the ground turns backwards: x' = -Ω × x, and so x'' = Ω × (Ω × x).
  const Vector velocity = -spin.cross(place), acceleration = spin.cross(spin.cross(place));
  for (const int mass : two_masses) {
    const Vector truth = mass * acceleration;
    Found(
        "the force on " + std::to_string(mass) + " kg that rest on the ground, seen from on board,",
        "N", force_on<Real>(place, velocity, spin, mass))
        .mistake(Vector(-truth), "right for what rests on board. Does the force see the velocity?")
        .mistake(
            Vector::Zero(),
            "the two parts cancel each other. Coriolis's is twice as large as the other here, and "
            "what is left holds it on its circle")
        .mistake(Vector(-3 * truth),
                 "both parts point outward. Coriolis's points inward here: look at its sign")
        .must_be(truth, 3 * tolerance<Real>);
  }
}

EXERCISE_CHECK("The outward force is the downhill slope of the potential energy") {
  using Vector = Vec3<Real>;
  const Vector spin(Real(0.5), -1, 2), place(1, 2, -1);
  for (const int mass : two_masses) {
    Vector falls;
    // The energy is of second degree, so a difference across a metre is its slope to rounding.
    for (int axis = 0; axis < 3; ++axis) {
      const Vector half = Vector::Unit(axis) / 2;
      falls[axis] =
          energy_at<Real>(place - half, spin, mass) - energy_at<Real>(place + half, spin, mass);
    }
    const Vector truth = -mass * spin.cross(spin.cross(place));
    Found("the downhill slope of the energy of " + std::to_string(mass) + " kg at (1, 2, -1) m",
          "N", falls)
        .mistake(Vector(-truth), "it rises outward, where the force points outward: a sign")
        .mistake(Vector(2 * truth), "twice the force: ½ m |Ω × x|² has a half")
        .mistake(Vector(truth / mass), "the force on 1 kg: is the mass missing?")
        .mistake(Vector(Real(mass) * spin.squaredNorm() * place),
                 "that is -½ m Ω² |x|². Only the distance from the axis counts: |Ω × x|²")
        .must_be(truth, 12 * tolerance<Real>);
  }
  Found("the energy on the axis", "J", energy_at<Real>(spin, spin, 2)).must_be(0, tolerance<Real>);
}

EXERCISE_CHECK("A plan leaves it out when it stands still, and only then") {
  const auto skipped = [](const Vec3<Real>& spin) { return ask<int>("is_skipped", spin) != 0; };
  require(
      !skipped({0, 0, 1}),
      "it turns with 1 rad/s, and the plan leaves it out: the balls would fly straight on board. "
      "A predicate returns a reason only where there is nothing to do");
  require(!skipped({-1, 0, 0}), "with -1 rad/s about x the plan leaves it out. Look at all of Ω");
  require(!skipped({0, Real(0x1p-10), 0}),
          "with a thousandth of a rad/s about y the plan leaves it out. However slowly it turns, "
          "what rests on board is pushed");
  require(
      skipped({0, 0, 0}),
      "it stands still, and every body would still be asked in each step. Return a sentence that "
      "says why it isn't needed");
}
