// What every rung of the ladder owes to the symmetries of the physics.
#include <support/body_bounds.hpp>
#include <support/other_methods.hpp>
#include <support/random_tops.hpp>
#include <support/scene_rules.hpp>
#include <support/tumbling_problems.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A step of the ladder makes most_turns of three roundings each at most. In another frame they are
/// other roundings: twice as much.
template <class Real>
constexpr Real other_frame = 2 * 3 * Real(most_turns) * unit_roundoff<Real>;

/// Problem by problem and rung by rung. The needle turns by 3.3 rad a step, which only those endure
/// that say so.
template <class Real, class Check>
void for_every_rung(const Check& check) {
  for (const TumblingProblem& problem : tumbling_problems)
    for (const TurningRung<Real>& rung : rungs<Real>()) {
      if (problem.letter == 'D' && !rung.claims.bounded) continue;
      CAPTURE(problem.letter);
      CAPTURE(std::string(rung.name));
      Top<Real> top = top_of<Real>(problem);
      top.orientation = normalized(Quaternion<Real>{1, {2, -3, 4}});
      check(top, rung);
    }
}

/// Three steps, with a torque of a third of |L| a second, askew.
template <class Real>
Top<Real> flown(Top<Real> top, const Vec3<Same<Real>>& torque, const TurningRung<Real>& rung) {
  for (int n = 0; n < 3; ++n) {
    add_torque(top, torque);
    kick(top, Real(1) / 60);
    clear_torque(top);
    rung.turn(top, Real(1) / 60);
  }
  return top;
}

template <class Real>
Vec3<Real> askew(const Top<Real>& top) {
  return top.angular_momentum_body.norm() * Vec3<Real>(Real(0.1), Real(-0.2), Real(0.3));
}

/// Takes a scene's choice as a world does, and turns one top by it.
template <class Real>
struct OneTop {
  Top<Real> top;
  void turn_by(const auto& rule) { rule(top, Real(1) / 60); }
};

}  // namespace

TEST_CASE_TEMPLATE("Whatever a scene can turn by has a row in the table of hard cases, to the bit",
                   Real, EVERY_PRECISION) {
  const std::vector<TurningRung<Real>> all = all_methods<Real>();
  for (std::size_t rule = 0; rule < SceneRules::names.size(); ++rule) {
    CAPTURE(SceneRules::names[rule]);
    const Top<Real> start = top_of<Real>(tumbling_problems[0]);
    OneTop<Real> chosen{start};
    SceneRules::choose(chosen, rule);
    CHECK(std::any_of(all.begin(), all.end(), [&](const TurningRung<Real>& method) {
      Top<Real> top = start;
      method.turn(top, Real(1) / 60);
      return same_bits(top.angular_momentum_body, chosen.top.angular_momentum_body) &&
             same_bits(top.orientation, chosen.top.orientation);
    }));
  }
}

TEST_CASE("No row has more turns than the longest that the bounds count") {
  const auto turns = [](const auto& row) { return row.kicks.size() + row.drifts.size() + 1; };
  CHECK(most_turns == 72);
  CHECK(turns(Verlet::row) == 4);
  for (const std::size_t others :
       {turns(Suzuki::row), turns(Yoshida::row), turns(KahanLiEighth::row),
        turns(BlanesMoanFourth::row), turns(BlanesMoanSixth::row)})
    CHECK(others < most_turns);
}

TEST_CASE("The energy's book closes for any turning, that of L for what keeps L") {
  // What a turn makes of the energy is entered as whatever it was; so a rule that is nonsense
  // closes that book too, and it is the book of L that finds it out.
  const auto nonsense = [](Topd& top, double) {
    top.angular_momentum_body = {top.angular_momentum_body.y() + 0.3,
                                 -top.angular_momentum_body.x(), 0.1};
  };
  const int steps = 100;
  for (const TumblingProblem* problem : {&tumbling_problems[0], &tumbling_problems[1]}) {
    Topd sane = top_of<double>(*problem), mad = sane;
    sane.torque = mad.torque = {0.1, -0.2, 0.3};
    const auto right = booked(sane, turn_by_splitting<double>, 1.0 / 60, steps);
    const auto wrong = booked(mad, nonsense, 1.0 / 60, steps);
    const double rounding = steps * 40 * unit_roundoff<double>;
    CHECK(right.energy <= rounding);
    CHECK(right.momentum <= rounding);
    CHECK(wrong.energy <= rounding);
    CHECK(wrong.momentum > 1e6 * rounding);  // a matter of the rule, not of digits
  }
}

TEST_CASE_TEMPLATE("In a turned scene every rung of the ladder turns a body by the same", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(141);
  for_every_rung<Real>([&](Top<Real> plain, const TurningRung<Real>& rung) {
    const Quaternion<Real> scene = random_orientation<Real>(generator);
    Top<Real> turned = plain;
    turned.orientation = scene * plain.orientation;
    rung.turn(plain, Real(1) / 60);
    rung.turn(turned, Real(1) / 60);
    CHECK(same_bits(turned.angular_momentum_body, plain.angular_momentum_body));
    CHECK(angle_between(turned.orientation, scene * plain.orientation) <= other_frame<Real>);
  });
}

TEST_CASE_TEMPLATE("Every rung turns a body a trillion times as heavy by the same, to the bit",
                   Real, EVERY_PRECISION) {
  for_every_rung<Real>([](const Top<Real>& top, const TurningRung<Real>& rung) {
    const Vec3<Real> torque = askew(top);
    const Top<Real> plain = flown(top, torque, rung);
    // Squares of L are the furthest that any rung goes. In float they keep all digits while each
    // component lies between 2^-62 and 2^63; L begins with them from 2^-13 to 9.
    for (const int exponent : {-40, -13, 7, 40}) {
      CAPTURE(exponent);
      const Real scale = std::ldexp(Real(1), exponent);
      Top<Real> heavy = top;
      heavy.inverse_moments /= scale;
      heavy.angular_momentum_body *= scale;
      heavy = flown(heavy, scale * torque, rung);
      CHECK(same_bits(heavy.orientation, plain.orientation));
      CHECK(same_bits(heavy.angular_momentum_body, scale * plain.angular_momentum_body));
    }
  });
}

TEST_CASE_TEMPLATE("Every rung turns a mirrored body the mirrored way, to the bit", Real,
                   EVERY_PRECISION) {
  for_every_rung<Real>([](const Top<Real>& top, const TurningRung<Real>& rung) {
    const Vec3<Real> torque = askew(top);
    const Top<Real> plain = flown(top, torque, rung);
    for (int axis = 0; axis < 3; ++axis) {
      // Turns mirror as torques do: the part along the mirrored axis keeps its sign.
      Vec3<Real> sign(-1, -1, -1);
      sign[axis] = 1;
      Top<Real> mirrored = top;
      mirrored.orientation.imaginary = top.orientation.imaginary.cwiseProduct(sign);
      mirrored.angular_momentum_body = top.angular_momentum_body.cwiseProduct(sign);
      mirrored = flown(mirrored, torque.cwiseProduct(sign), rung);
      CHECK(mirrored.orientation.real == plain.orientation.real);
      CHECK(same_bits(mirrored.orientation.imaginary,
                      plain.orientation.imaginary.cwiseProduct(sign)));
      CHECK(same_bits(mirrored.angular_momentum_body,
                      plain.angular_momentum_body.cwiseProduct(sign)));
    }
  });
}
