#include <exercise/judge.hpp>
#include <tumble/splitting.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
Real wobbles(Same<Real> across, Same<Real> about, Same<Real> tilt) {
  return ask<Real>("wobbles_per_turn", across, about, tilt);
}

template <class Real>
Quaternion<Real> after(const Top<Real>& top, Same<Real> time) {
  return ask<Quaternion<Real>>("after", top, time);
}

/// A symmetric top, tilted, with `spin` in body axes.
template <class Real>
Top<Real> thrown(Same<Real> across, Same<Real> about, const Vec3<Same<Real>>& spin) {
  Top<Real> top;
  top.inverse_moments = Vec3<Real>(1 / across, 1 / across, 1 / about);
  top.orientation = quaternion_of_rotation_vector(Vec3<Real>(Real(0.5), -1, Real(0.25)));
  set_angular_velocity_body<Real>(top, spin);
  return top;
}

template <class Real>
constexpr double roundings = 32 * unit_roundoff<Real>;

}  // namespace

EXERCISE_CHECK("A plate that wobbles a little wobbles twice while it turns once") {
  Found("the wobbles in a turn of a flat plate with hardly any tilt", "",
        wobbles<Real>(Real(0.5), 1, 0))
      .mistake(Real(0.5),
               "so Feynman remembered it, the wrong way round: how often does the axis go round "
               "while the plate spins once?")
      .mistake(1,
               "one is how often L goes round in the body, at ω₃ (I₃ - I₁)/I₁. The axis in the "
               "world goes round at |L|/I₁")
      .mistake(0, "the tangent or sine of the tilt stands where its cosine should")
      .must_be(2, roundings<Real>);
  Found(
      "the wobbles in a turn of a thick plate, with moments of 0.5 across and 0.75 about the axis,",
      "", wobbles<Real>(Real(0.5), Real(0.75), 0))
      .mistake(2, "two are those of a flat plate. Where do the moments come in?")
      .must_be(Real(1.5), roundings<Real>);
}

EXERCISE_CHECK("A rod wobbles less often than it turns, and a slanting axis goes round faster") {
  const Real tilt = Real(parameter("tilt") * std::numbers::pi / 180);
  for (const auto& [across, about] :
       {std::pair<Real, Real>{1, Real(0.125)}, {Real(0.5), 1}, {2, 3}}) {
    const Real truth = about / across / std::cos(tilt);
    Found("the wobbles in a turn with the moments " + shown(across) + " across and " +
              shown(about) + " about the axis, at " + shown(parameter("tilt")) + "°,",
          "", wobbles<Real>(across, about, tilt))
        .mistake(about / across,
                 "right without a tilt. The spin is only the part of the motion along the axis: "
                 "L₃ = |L| cos(tilt)")
        .mistake(about / across * std::cos(tilt), "the cosine belongs in the denominator")
        .mistake(across / about / std::cos(tilt), "the moments are exchanged")
        .mistake(about / across / std::cos(tilt * Real(std::numbers::pi / 180)),
                 "the tilt is in rad already")
        .mistake((about - across) / across, "that is how often L goes round in the body")
        .must_be(truth, truth * roundings<Real>);
  }
}

EXERCISE_CHECK("Two steady turns are the whole motion, at any time") {
  for (const auto& [across, about] : {std::pair<Real, Real>{1, Real(0.125)}, {Real(0.5), 1}}) {
    const auto start = thrown<Real>(across, about, Vec3<Real>(1, Real(-0.5), 3));
    for (const double seconds : {0.125, 1.0, 2.5, -0.75}) {
      const Real time = Real(seconds);
      // Chapter 8's splitting is exact for a symmetric top, however long the step.
      auto top = start;
      turn_by_splitting(top, time);
      const auto found = after(start, time);
      // Each turn is off by some 24 roundings, and by those of an angle up to 20 rad.
      const double rounding = 3 * (24 + 8 * 20) * double(unit_roundoff<Real>);
      Found("the norm of the orientation after " + shown(seconds) + " s", "", norm(found))
          .must_be(1, rounding);
      const auto turn = [&](const Vec3<Real>& v) {
        return quaternion_of_rotation_vector(Vec3<Real>(time * v));
      };
      const Vec3<Real> round = start.inverse_moments.x() * angular_momentum_world(start);
      const Vec3<Real> own(0, 0,
                           (start.inverse_moments.z() - start.inverse_moments.x()) *
                               start.angular_momentum_body.z());
      const Quaternion<Real>& q = start.orientation;
      const auto off = [&](const Quaternion<Real>& other) {
        return angle_between(top.orientation, other);
      };
      Found("the angle by which the plate is off after " + shown(seconds) + " s", "rad", off(found))
          .mistake(off(turn(angular_velocity_world(start)) * q),
                   "that is one steady turn about the ω of the start. But ω itself goes round L")
          .mistake(
              off(turn(start.inverse_moments.x() * start.angular_momentum_body) * q * turn(own)),
              "the turn about L takes L as the body sees it. L stands still in the world: take "
              "it in world axes")
          .mistake(off(turn(round) * q),
                   "the turn about L is right, and the one about the plate's own axis is missing")
          .mistake(off(q * turn(own)), "the turn about L is missing")
          .mistake(off(turn(round) * q * turn(-own)),
                   "the turn about the axis goes the wrong way round. Which sign has 1/I₃ - 1/I₁?")
          .mistake(off(turn(own) * q * turn(round)),
                   "the two turns stand on each other's side. World on the left, body on the right")
          .mistake(off(turn(round) * turn(own) * q),
                   "both turns stand on the left. The one about the axis is given in the body, and "
                   "belongs on the right")
          .mistake(off(turn(round) * q * turn(Vec3<Real>(0, 0, angular_velocity_body(start).z()))),
                   "about its axis it turns by ω₃ less what the turn about L does there already")
          .must_be(0, rounding);
    }
  }
}

EXERCISE_CHECK("A ball has one turn only, and without time nothing turns") {
  const auto ball = thrown<Real>(2, 2, Vec3<Real>(1, Real(-0.5), 3));
  auto turned = ball;
  turn_by_splitting(turned, Real(0.5));
  const double rounding = 3 * (24 + 8 * 4) * double(unit_roundoff<Real>);
  const auto found = after(ball, Real(0.5));
  Found("the norm of a ball's orientation after half a second", "", norm(found))
      .not_a_number("not a number: for a ball the moments' difference is zero. Is it divided by?")
      .must_be(1, rounding);
  Found("the angle by which a ball is off after half a second", "rad",
        angle_between(turned.orientation, found))
      .not_a_number("not a number: for a ball the moments' difference is zero. Is it divided by?")
      .must_be(0, rounding);
  const auto plate = thrown<Real>(Real(0.5), 1, Vec3<Real>(1, Real(-0.5), 3));
  Found("the angle turned in no time", "rad", angle_between(plate.orientation, after(plate, 0)))
      .must_be(0, rounding);
}
