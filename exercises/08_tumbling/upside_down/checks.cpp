#include <exercise/judge.hpp>
#include <tumble/splitting.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
const Vec3<Real> hull(3, Real(2.5), 1);

const double mass = 0.4, reach = 1;

/// A satellite with these angular momenta, in body axes, its booms in.
template <class Real>
Top<Real> satellite(const Vec3<Same<Real>>& angular_momentum) {
  Top<Real> top;
  top.orientation = quaternion_of_rotation_vector(Vec3<Real>(Real(0.5), -1, Real(0.25)));
  top.inverse_moments = hull<Real>.cwiseInverse();
  top.angular_momentum_body = angular_momentum;
  return top;
}

template <class Real>
Top<Real> with_booms(const Top<Real>& top, double at) {
  return ask<Top<Real>>("set_booms", top, hull<Real>, Real(mass), Real(at));
}

template <class Real>
Top<Real> thrown() {
  const Real spin = Real(parameter("spin"));
  auto top = satellite<Real>(Vec3<Real>::Zero());
  set_angular_velocity_body<Real>(top, Vec3<Real>(spin, spin / 64, spin / 64));
  return top;
}

const int steps_a_second = 60;

template <class Real>
Top<Real> flown(const Top<Real>& top, double seconds) {
  return ask<Top<Real>>("flown", top, hull<Real>, Real(mass), Real(reach), Real(1) / steps_a_second,
                        int(seconds * steps_a_second));
}

/// Who sets L down upside down has not flown: the flight is what the student's parts make of it.
template <class Real>
void require_flight(const Top<Real>& start, double seconds, const Top<Real>& end) {
  auto top = start;
  bool out = false;
  for (int n = 0; n < int(seconds * steps_a_second); ++n) {
    out = ask<bool>("booms_out", top, out);
    top = with_booms(top, out ? reach : 0);
    turn_by_splitting(top, Real(1) / steps_a_second);
  }
  require(
      end.angular_momentum_body == top.angular_momentum_body &&
          end.orientation.real == top.orientation.real &&
          end.orientation.imaginary == top.orientation.imaginary,
      sentence("after ", seconds, " s flown gives the angular momentum ", end.angular_momentum_body,
               " kg m²/s in body axes, and your booms_out and set_booms, step by step, ",
               top.angular_momentum_body, ". Leave flown as it was"));
}

/// What rounding makes of L meanwhile: a step turns four times and rotates L with it, 40 roundings
/// each.
template <class Real>
double rounding_of_L(const Top<Real>& start, double seconds) {
  return 4 * 40 * seconds * steps_a_second * double(start.angular_momentum_body.norm()) *
         unit_roundoff<Real>;
}

/// How far the satellite is upright: 1 with L along x, -1 upside down.
template <class Real>
Real upright(const Top<Real>& top) {
  return top.angular_momentum_body.x() / top.angular_momentum_body.norm();
}

}  // namespace

EXERCISE_CHECK("Masses on the booms resist a turn across them, and none about them") {
  const Vec3<Real> h = hull<Real>;
  const auto start = satellite<Real>(Vec3<Real>(1, 2, 3));
  const auto found = with_booms(start, 0.5);
  const auto with = [&](double x, double y, double z) {
    return Vec3<Real>(h.x() + Real(x), h.y() + Real(y), h.z() + Real(z));
  };
  Found("the principal moments with two masses of 0.4 kg at half a metre", "kg m²",
        moments_of(found))
      .mistake(with(0, 0.1, 0.1), "only one mass counts. There is one on each side")
      .mistake(with(0, 0.4, 0.4), "the distance counts with its square")
      .mistake(with(0.2, 0.2, 0.2), "the masses sit on the x axis, so they resist no turn about it")
      .mistake(with(0.2, 0, 0), "the masses sit on the x axis: they resist turns across it")
      .mistake(h, "the masses have not moved")
      .must_be(with(0, 0.2, 0.2), 3.3 * 16 * unit_roundoff<Real>);
  Found("the principal moments once they are in again", "kg m²", moments_of(with_booms(found, 0)))
      .mistake(with(0, 0.2, 0.2),
               "the masses still count as if they were out. Start from the hull each time")
      .must_be(h, 3.3 * 16 * unit_roundoff<Real>);
  // Half a metre counts as much as its square, twice; so other numbers too.
  const Vec3<Real> other(4, 3, 2);
  Found("the principal moments of a hull of 4, 3 and 2 kg m² with 3 kg at a quarter of a metre",
        "kg m²", moments_of(ask<Top<Real>>("set_booms", start, other, Real(3), Real(0.25))))
      .must_be(other + Vec3<Real>(0, Real(0.375), Real(0.375)), 4 * 16 * unit_roundoff<Real>);
}

EXERCISE_CHECK("When the masses move, the angular momentum stays and the spin gives way") {
  const Vec3<Real> L(6, Real(2.5), 1), spin(2, 1, 1);
  const auto start = satellite<Real>(L), found = with_booms(start, 0.5);
  const Vec3<Real> moments = hull<Real> + Vec3<Real>(0, Real(0.2), Real(0.2));
  Found("the angular momentum after the masses have moved out", "kg m²/s",
        found.angular_momentum_body)
      .mistake(moments.cwiseProduct(spin),
               "it grew with the moments: the angular velocity was kept. Nothing pushes from "
               "outside, so L is what stays")
      .mistake(Vec3<Real>::Zero(), "it is gone")
      .must_be(L, 0);
  Found("the angular velocity after the masses have moved out", "rad/s",
        angular_velocity_body(found))
      .must_be(L.cwiseQuotient(moments), 16 * 2 * unit_roundoff<Real>);
  require(found.orientation.real == start.orientation.real &&
              found.orientation.imaginary == start.orientation.imaginary,
          "the satellite has turned. The masses move in no time; turning comes later");
}

EXERCISE_CHECK("The booms stay out until the satellite is as far upside down as it gets") {
  const auto asked = [](Real x, Real y, Real z, bool out) {
    auto top = satellite<Real>(Vec3<Real>(x, y, z));
    if (out) top.inverse_moments.tail(2) = (hull<Real>.tail(2).array() + Real(0.8)).inverse();
    return ask<bool>("booms_out", top, out);
  };
  require(asked(12, Real(0.125), Real(0.125), false),
          "it is upright and its booms stay in: so nothing will ever happen");
  for (const Real x : {Real(8), Real(0.125)})
    for (const Real y : {Real(-0.5), Real(0.5)})  // L_x falls, and L_x rises
      require(asked(x, y, 4, true),
              "it is not upside down yet, L_x is " + shown(x) + ", and the booms come in again");
  require(
      asked(-2, -8, 4, true),
      "it is hardly past the middle, and L_x still falls; the booms come in too early, and leave "
      "it in a tumble. How does L_x change?");
  require(asked(-12, Real(-0.25), Real(0.25), true),
          "it is nearly upside down, and L_x still falls: the booms come in before it is so as far "
          "as it gets. How does L_x change?");
  require(
      !asked(-12, Real(0.25), Real(0.25), true),
      "it is upside down, and L_x is rising again; the booms are still out, and it will turn back");
  require(!asked(-8, 4, 4, true),
          "four fifths of L are upside down, and L_x is rising again: it gets no farther, and "
          "the booms are still out. How does L_x change?");
  require(!asked(-12, Real(0.25), Real(-0.25), false),
          "it is upside down with its booms in, and they go out again. There they must stay in");
  require(!asked(-11, Real(0.25), Real(0.25), false),
          "it is upside down with its booms in, and they go out again. There they must stay in");
}

EXERCISE_CHECK("Ordered upside down, it turns over and stays so") {
  const double spin = parameter("spin");
  for (const double turns : {14.0, 20.0, 40.0}) {
    const double seconds = 2 * std::numbers::pi * turns / spin;
    const auto start = thrown<Real>(), end = flown(start, seconds);
    // A length of 0 upside down would be a quotient of -infinity.
    Found("the size of L after " + shown(seconds) + " s", "kg m²/s",
          end.angular_momentum_body.norm())
        .not_a_number("is a moment zero, or its inverse?")
        .must_be(start.angular_momentum_body.norm(), rounding_of_L(start, seconds));
    const Real found = upright(end);
    const std::string when = sentence("after ", seconds, " s the part of L along x is ", found,
                                      " of L; it must be -1, or nearly");
    // It begins with L 0.015 rad off the axis, and pulls its masses in when as little is left. The
    // wobble's path is four times as long as wide. -0.98 are 0.2 rad.
    require(found < Real(-0.98),
            when + ". Do the booms go out, and do they come in at the right moment to stay in?");
    if (turns < 20) require_flight(start, seconds, end);
  }
}

EXERCISE_CHECK("Seen from the world, the angular momentum has not moved") {
  const auto start = thrown<Real>();
  const Vec3<Real> before = angular_momentum_world(start);
  const double seconds = 30;
  const auto end = flown(start, seconds);
  require(std::abs(upright(end) - 1) > Real(0.5),
          "the satellite has not turned over, so there is nothing to see here yet");
  Found("the angular momentum in the world after 30 s", "kg m²/s", angular_momentum_world(end))
      .mistake(-before,
               "it has turned over along with the satellite. Nothing pushed: in the world L stands "
               "still")
      .must_be(before, rounding_of_L(start, seconds));
  require_flight(start, seconds, end);
}
