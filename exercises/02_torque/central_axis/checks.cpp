#include <exercise/judge.hpp>
#include <tumble/torque.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// A push and a twist, taken about a point that is not the origin.
template <class Real>
Wrench<Real> some_wrench() {
  return {
      .about = Vec3<Real>(1, -2, 3), .force = Vec3<Real>(2, 1, -2), .torque = Vec3<Real>(3, -1, 4)};
}

template <class Real>
Vec3<Real> axis_point(const Wrench<Real>& wrench) {
  return ask<Vec3<Real>>("point_on_central_axis", wrench);
}

}  // namespace

EXERCISE_CHECK("About the point found the torque is parallel to the force") {
  const auto wrench = some_wrench<Real>();
  const Vec3<Real> point = axis_point(wrench);
  const Vec3<Real> d = wrench.force.cross(wrench.torque) / wrench.force.squaredNorm();
  const Vec3<Real> across = taken_about(wrench, point).torque.cross(wrench.force);
  // Numbers up to 10, a dozen operations one after the other.
  const double tolerance = 12 * 100 * unit_roundoff<Real>;
  if (farthest(point, Vec3<Real>(wrench.about - d)) <= tolerance)
    fail(
        "the point lies on the wrong side: about it the torque grew. Try the other order in the "
        "cross product");
  if (farthest(point, d) <= tolerance)
    fail(
        "that is the way from the point that the wrench is taken about, and not yet a place in the "
        "world. Where does it begin?");
  Found("the torque about the point, crossed with the force,", "N² m", across)
      .not_a_number("the point that came back is not a number")
      .must_be(Vec3<Real>::Zero(), tolerance);
}

EXERCISE_CHECK(
    "It is the nearest point of the axis: the vector to it is perpendicular to the force") {
  const auto wrench = some_wrench<Real>();
  const Vec3<Real> way = axis_point(wrench) - wrench.about;
  Found("the offset of the point, along the force,", "N m", way.dot(wrench.force))
      .must_be(0, 12 * 30 * unit_roundoff<Real>);
  require(way.norm() > Real(0.1),
          "the point is the one that the wrench is taken about. Its torque isn't parallel to the "
          "force");
}

EXERCISE_CHECK("For a single force it is a point on the line of that force") {
  const Vec3<Real> force(0, 3, 4), hit(2, 0, 1);
  Wrench<Real> wrench{.about = Vec3<Real>(-1, 2, 0.5)};
  add_force_at(wrench, force, hit);
  const Vec3<Real> arm = axis_point(wrench) - hit;
  Found("the distance from the force's line, times the force,", "N m", Vec3<Real>(arm.cross(force)))
      .must_be(Vec3<Real>::Zero(), 12 * 30 * unit_roundoff<Real>);
}

EXERCISE_CHECK("Twice the force with twice the torque has the same axis") {
  auto wrench = some_wrench<Real>();
  const Vec3<Real> once = axis_point(wrench);
  const Vec3<Real> way = once - wrench.about;
  auto other = wrench;
  other.torque = Vec3<Real>(-2, 5, 1);
  require((axis_point(other) - once).norm() > Real(0.1),
          "with another torque the point is the same, " + shown(once) +
              " m. Where do force and torque come in?");
  wrench.force *= 2;
  wrench.torque *= 2;
  Found("the offset of the point for a doubled wrench", "m",
        Vec3<Real>(axis_point(wrench) - wrench.about))
      .mistake(2 * way,
               "it doubled. The denominator is |F| where it should be |F|²: force and torque both "
               "doubled in the numerator")
      .mistake(
          4 * way,
          "it grew fourfold. Force and torque are in the numerator, and there is no denominator")
      .mistake(way / 2, "it halved. There is one |F| too many in the denominator")
      .must_be(way, 12 * unit_roundoff<Real> * 8);
  // A power of two rounds nothing.
  auto faint = some_wrench<Real>();
  faint.force *= Real(0x1p-20);
  faint.torque *= Real(0x1p-20);
  Found("the way to the point for a millionth of the wrench", "m",
        Vec3<Real>(axis_point(faint) - faint.about))
      .must_be(way, 12 * unit_roundoff<Real> * 8);
}

EXERCISE_CHECK("A couple has no force and no axis, and is refused") {
  Wrench<Real> couple{.torque = Vec3<Real>(0, 0, 5)};
  require(axis_point(some_wrench<Real>()).allFinite(),
          "a wrench that has an axis must get a point of it");
  for (int axis = 0; axis < 3; ++axis) {
    const Wrench<Real> along{.about = Vec3<Real>(1, -2, 3), .force = Vec3<Real>::Unit(axis)};
    Found("the way to the axis of the force " + shown(along.force) + " N, which is without torque,",
          "m", Vec3<Real>(axis_point(along) - along.about))
        .must_be(Vec3<Real>::Zero(), 12 * 4 * unit_roundoff<Real>);
  }
  ask_refusal(
      "a couple was given a point. Its torque is the same about every point and parallel "
      "to no force: "
      "throw std::invalid_argument",
      "point_on_central_axis", couple);
}
