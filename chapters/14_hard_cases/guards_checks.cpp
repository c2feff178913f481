// Where the rungs that claim no bound stop, and what they say.
#include <support/bad_vectors.hpp>
#include <support/random_quaternion.hpp>
#include <support/tumbling_problems.hpp>
#include <tumble/guarded_turn.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Runs until the guard stops the rung. @return what it says, or nothing after `steps`
template <class Real>
std::string stopped(const TurningRung<Real>& rung, Top<Real>& top, Real time_step, int steps) {
  for (int n = 0; n < steps; ++n) {
    const Top<Real> before = top;
    try {
      turn_or_stop(rung, top, time_step);
    } catch (const TurnError& error) {
      CHECK(error.rung == rung.name);
      CHECK(same_bits(top.angular_momentum_body, before.angular_momentum_body));
      CHECK(same_bits(top.orientation.imaginary, before.orientation.imaginary));
      CHECK(top.orientation.real == before.orientation.real);
      return error.what();
    }
    REQUIRE(is_finite(top.angular_momentum_body));
    REQUIRE(std::isfinite(norm(top.orientation)));
  }
  return "";
}

/// Which number of a top a rung loses, and what it makes of it: a rung is a bare function.
int lost_part = 0;
template <class Real>
Real lost_value = 0;

}  // namespace

TEST_CASE_TEMPLATE("A rung that blows up is stopped with its name and the limit, before any NaN",
                   Real, EVERY_PRECISION) {
  const std::string limit = " rad in this step, and no finite orientation was found; at most " +
                            text_of(2 * SineCosineConstants<Real>::limit) + " rad can be turned";
  for (const char* name : {"explicit", "Runge-Kutta", "Dormand-Prince 5"}) {
    const TurningRung<Real>& rung = turning_rung<Real>(name);
    Top<Real> top = top_of<Real>(tumbling_problems[3]);  // the needle, 3.3 rad a step
    const std::string what = stopped(rung, top, Real(1) / 60, 1000);
    CAPTURE(std::string(name));
    CAPTURE(what);
    CHECK(what.find("'" + std::string(name) + "' would turn by ") == 0);
    const std::size_t end = what.find(limit);
    REQUIRE(end != std::string::npos);
    CHECK(end == what.size() - limit.size());
  }
}

TEST_CASE_TEMPLATE("Up to the limit a guarded rung is the rung itself, to the bit", Real,
                   EVERY_PRECISION) {
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    CAPTURE(std::string(rung.name));
    Top<Real> guarded = top_of<Real>(tumbling_problems[0]), plain = guarded;
    for (int n = 0; n < 10; ++n) {
      turn_or_stop(rung, guarded, Real(1) / 60);
      rung.turn(plain, Real(1) / 60);
    }
    CHECK(same_bits(guarded.angular_momentum_body, plain.angular_momentum_body));
    CHECK(same_bits(guarded.orientation, plain.orientation));
    // With ever longer steps, up to one that would turn by the whole range of the sine.
    const Top<Real> start = top_of<Real>(tumbling_problems[0]);
    const Real spin = angular_velocity_body(start).norm();
    for (Real angle = 1; angle < 2 * SineCosineConstants<Real>::limit; angle *= 3) {
      guarded = plain = start;
      rung.turn(plain, angle / spin);
      if (!is_finite(plain)) break;
      turn_or_stop(rung, guarded, angle / spin);
      CHECK(same_bits(guarded.angular_momentum_body, plain.angular_momentum_body));
      CHECK(same_bits(guarded.orientation, plain.orientation));
    }
  }
}

TEST_CASE_TEMPLATE("The guard lets the largest turn through, and nothing beyond it", Real,
                   EVERY_PRECISION) {
  const Real limit = 2 * SineCosineConstants<Real>::limit;
  for (const Real size : {std::ldexp(Real(1), -100), Real(1), std::ldexp(Real(1), 100)}) {
    // L of any size: its square need not be a number.
    const Top<Real> ball{.angular_momentum_body = {0, 0, size},
                         .inverse_moments = Vec3<Real>::Constant(1 / size)};
    const TurningRung<Real>& rung = turning_rung<Real>("splitting");
    Top<Real> top = ball;
    turn_or_stop(rung, top, limit);
    CHECK(std::abs(norm(top.orientation) - 1) <= 10 * unit_roundoff<Real>);
    top = ball;
    const std::string what =
        stopped(rung, top, std::nextafter(limit, std::numeric_limits<Real>::infinity()), 1);
    CAPTURE(what);
    CHECK(what.find("'splitting' would turn by ") == 0);
  }
}

TEST_CASE_TEMPLATE("A guarded rung is stopped whichever of its numbers is not finite", Real,
                   EVERY_PRECISION) {
  for (const Real bad : not_finite<Real>)
    for (int part = 0; part < 7; ++part) {
      lost_part = part;
      lost_value<Real> = bad;
      const TurningRung<Real> rung = {"lost", {}, [](Top<Real>& top, Real) {
                                        auto& [q, L, torque, inverse] = top;
                                        (lost_part < 3   ? L[lost_part]
                                         : lost_part < 6 ? q.imaginary[lost_part - 3]
                                                         : q.real) = lost_value<Real>;
                                      }};
      Top<Real> top{.angular_momentum_body = {0, 0, 2}, .inverse_moments = {1, 1, 1}};
      CAPTURE(part);
      CHECK(stopped(rung, top, Real(1), 1).find("'lost' would turn by 2 rad in this step, and ") ==
            0);
    }
}
