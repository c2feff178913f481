#include <exercise/judge.hpp>
#include <tumble/quaternion.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition unit_vectors[] = {{"mirrored", 1, of_length_one},
                                     {"mirrored_spin", 1, of_length_one},
                                     {"mirrored_turn", 0, of_length_one},
                                     {"mirrored_turn", 1, of_length_one},
                                     {"law_broken_by", 5, of_length_one}};

/// Numbers of a few units, and some twenty operations.
template <class Real>
constexpr double tolerance = 256 * unit_roundoff<Real>;

template <class Real>
Vec3<Real> slanted() {
  return {Real(2) / 3, Real(-1) / 3, Real(2) / 3};
}

template <class Real>
Vec3<Real> reflected(const Vec3<Real>& v, const Vec3<Real>& n) {
  return v - 2 * n.dot(v) * n;
}

}  // namespace

EXERCISE_CHECK("A mirror turns round what is perpendicular to it and leaves the rest") {
  using Vector = Vec3<Real>;
  const Vector arrow(1, 2, 3);
  Found("a mirror across the x axis shows the arrow (1, 2, 3) as one that", "m",
        ask<Vector>("mirrored", arrow, Vector(1, 0, 0)))
      .mistake(Vector(1, -2, -3),
               "that is what happens to a spin, or half a turn about x. Of an arrow the part "
               "perpendicular to the mirror turns round")
      .mistake(Vector(0, 2, 3),
               "that is its shadow on the mirror. The image is as far behind it: take the part "
               "away twice")
      .mistake(Vector(-1, -2, -3), "all of it is turned round; the part along the mirror stays")
      .mistake(arrow, "nothing has changed")
      .must_be(Vector(-1, 2, 3), 0);
  const Vector n = slanted<Real>();
  Found("a slanted mirror shows the arrow (1, 2, 3) as one that", "m",
        ask<Vector>("mirrored", arrow, n))
      .mistake(Vector(-1, 2, 3), "as the mirror across x does. Where is the normal?")
      .must_be(reflected(arrow, n), tolerance<Real>);
}

EXERCISE_CHECK("Every point of a mirrored wheel moves as the mirror shows it") {
  using Vector = Vec3<Real>;
  const Vector spin(1, -2, Real(0.5));
  for (const Vector& n : {Vector(0, 0, 1), slanted<Real>()}) {
    const Vector seen = ask<Vector>("mirrored_spin", spin, n);
    const Vector truth = -reflected(spin, n);
    Found("with a mirror across " + shown(n) + " the spin (1, -2, 0.5) is seen as one that",
          "rad/s", seen)
        .mistake(reflected(spin, n),
                 "that is mirrored like an arrow. Look at a wheel with its axle along the glass: "
                 "its image "
                 "spins the other way")
        .mistake(spin, "nothing has changed. Look at a wheel with its axle along the glass")
        .mistake(Vector(-spin),
                 "all of it is turned round. A wheel whose axle points at the glass keeps its spin")
        .must_be(truth, tolerance<Real>);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector point = Vector::Unit(axis);
      Found("the velocity of a point of the wheel with that spin", "m/s",
            Vector(seen.cross(reflected(point, n))))
          .must_be(reflected(Vector(spin.cross(point)), n), 2 * tolerance<Real>);
    }
  }
}

EXERCISE_CHECK("A mirrored body shows the mirrored points") {
  using Vector = Vec3<Real>;
  using Four = Eigen::Matrix<Real, 4, 1>;
  const auto check = [](const Vector& rotation, const Vector& n) {
    const auto q = quaternion_of_rotation_vector<Real>(rotation);
    Four turn;
    turn << q.real, q.imaginary;
    const Four seen = ask<Four>("mirrored_turn", turn, n);
    const auto with = [&](Real real, const Vector& imaginary) {
      Four four;
      four << real, imaginary;
      return four;
    };
    const Vector along = reflected(q.imaginary, n);
    // q and -q are one orientation.
    const Real sign = seen.dot(with(q.real, -along)) < 0 ? Real(-1) : Real(1);
    Found(sentence("with a mirror across ", n, " the orientation ", turn, " is seen as one that"),
          "", Four(sign * seen))
        .mistake(with(q.real, along),
                 "the axis is mirrored like an arrow, and the turn goes on the same way. Turn "
                 "the axis as you turn a spin")
        .mistake(with(-q.real, -along), "the angle is another one. A mirror changes the axis alone")
        .mistake(with(q.real, -q.imaginary), "that is the turn back, whatever the mirror")
        .mistake(turn, "nothing has changed")
        .must_be(with(q.real, -along), tolerance<Real>);
    const Quaternion<Real> image{seen[0], seen.template tail<3>()};
    const Vector point(1, Real(0.5), -2);
    Found("the place of a point of the image", "m", rotate(image, reflected(point, n)))
        .must_be(reflected(rotate(q, point), n), 4 * tolerance<Real>);
  };
  check({Real(0.75), -1, Real(0.5)}, {0, 1, 0});
  check({Real(0.75), -1, Real(0.5)}, slanted<Real>());
  check({3, -2, Real(1.5)},
        slanted<Real>());  // by more than half a turn: the real part is negative
}

EXERCISE_CHECK(
    "Drag and the Magnus force pass the test, and a push along the axis fails by twice its size") {
  using Vector = Vec3<Real>;
  const Vector velocity(3, -1, 2), spin(1, 2, -2), n = slanted<Real>();
  const auto broken = [&](double a, double b, double c) {
    return double(ask<Real>("law_broken_by", Real(a), Real(b), Real(c), velocity, spin, n));
  };
  const double drag = broken(-0.5, 0, 0), magnus = broken(0, 0, 0.5), axis = broken(0, 0.75, 0);
  const double v = double(velocity.norm()), w = double(spin.norm());
  const double along_axis = 2 * 0.75 * w;
  Found("the force by which a push along the axis, F = 0.75 ω, is found to break the mirror", "N",
        axis)
      .mistake(0,
               "your test passes it, as it would pass anything that is made of arrows. The spin "
               "must be mirrored "
               "as a spin")
      .mistake(2 * 0.75 * std::abs(double(n.dot(spin))),
               "the law was asked about one and the same body both times. Ask it about the "
               "mirrored one, with "
               "its velocity and its spin")
      .mistake(along_axis * along_axis, "the square of the distance; take the root")
      .mistake(along_axis / 2, "half of it: the force and its opposite are twice its size apart")
      .must_be(along_axis, 4 * tolerance<Real>);
  Found("the force by which drag, F = -0.5 v, is found to break the mirror", "N", drag)
      .mistake(0.5 * 2 * v, "of the two ways to the mirrored force one has a sign of its own")
      .mistake(
          std::abs(double(n.dot(velocity))),
          "on one of the two ways nothing was mirrored: either the force is, or the body before it")
      .must_be(0, 4 * tolerance<Real>);
  Found("the force by which the Magnus force, F = 0.5 v × ω, is found to break the mirror", "N",
        magnus)
      .mistake(0.5 * 2 * double(velocity.cross(spin).norm()),
               "a cross product of an arrow and a spin is an arrow, if the spin is mirrored as "
               "one. The right law "
               "fails your test, so the test is wrong")
      .must_be(0, 8 * tolerance<Real>);
  Found("the force by which all three terms together are found to break the mirror", "N",
        broken(-0.5, 0.75, 0.5))
      .must_be(along_axis, 16 * tolerance<Real>);
}
