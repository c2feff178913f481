#include <random>
#include <support/second_method.hpp>
#include <tumble/exact/free_top.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;
using namespace tumble::support;
using exact::FreeTop;

namespace {

Topd top_with_inverse(const Vec3d& inverse_moments, const Vec3d& angular_momentum) {
  return {.orientation = normalized(Quaterniond{1, {2, -3, 4}}),
          .angular_momentum_body = angular_momentum,
          .inverse_moments = inverse_moments};
}

}  // namespace

TEST_CASE("On the edge between the two kinds of motion the top turns over once and never again") {
  // D of the middle axis is 1 (2 - 3) + 1 (2 - 1), zero without a rounding.
  for (const double third : {1.0, -1.0})
    for (const auto& inverse : {Vec3d(3, 2, 1), Vec3d(1, 2, 3)}) {
      const Topd start = top_with_inverse(inverse, {1, 2, third});
      const FreeTop<double> exact(start);
      CHECK(exact.parameter() == 1);
      CHECK(std::isinf(exact.period()));
      // |L| = sqrt 6 goes over to the middle axis as a hyperbolic tangent, and stays there.
      const double forwards = exact.at(1000).angular_momentum_body.y(),
                   backwards = exact.at(-1000).angular_momentum_body.y();
      CHECK(std::abs(std::abs(forwards) - std::sqrt(6.0)) <= 8 * unit_roundoff<double>);
      CHECK(std::abs(forwards + backwards) <= 8 * unit_roundoff<double>);
      const auto truth = integrated_free_top(in_long_double(start), 2, 3000);
      CHECK(difference(exact.at(2), truth) <= rounding_of_free_top<double>(2 * 7));  // 7 rad/s
    }
}

TEST_CASE("A spin about the middle axis flips at a time that only the smallest part of L tells") {
  // Half a period is K(m)/λ, and K grows as ½ ln(16/(1 - m)): ten times less of a push is ln 10/λ
  // more of a wait, from 1e-3 down to 1e-30.
  const double rate = std::sqrt((1 / 2.0 - 1 / 3.0) * (1 - 1 / 2.0));  // λ for L = (0, 1, 0)
  double before = 0;
  for (double push = 1e-3; push > 1e-30; push /= 10) {
    const Topd start = top_with_inverse({1, 1 / 2.0, 1 / 3.0}, {push, 1, 0});
    const double half = FreeTop(start).period() / 2;
    // m is off from 1, and λ from its limit, by a few times push².
    if (before > 0)
      CHECK(std::abs(half - before - 2 * std::log(10) / rate) <=
            half * (4 * (100 * push * push) + 20 * unit_roundoff<double>));
    before = half;
    const auto flipped = FreeTop(start).at(half).angular_momentum_body;
    CHECK(std::abs(flipped.y() + 1) <= 8 * unit_roundoff<double> + push * push);
  }
}

TEST_CASE("A symmetric top makes two turns, one about L and one about its axis") {
  for (int axis = 0; axis < 3; ++axis)
    for (const double along : {2.0, 0.5, 1e-6})
      for (const double sign : {1.0, -1.0}) {
        const double across = 1.0;
        Vec3d inverse = Vec3d::Constant(across), L(0.3, -0.4, 0.5);
        inverse[axis] = along;
        L[axis] *= sign;
        const Topd start = top_with_inverse(inverse, L);
        const FreeTop<double> exact(start);
        CHECK(exact.parameter() == 0);
        for (const double time : {0.1, 3.0, -40.0}) {
          const auto witness = in_long_double(start);
          const Vec3<long double> about_L = time * angular_momentum_world(witness) * across;
          Vec3<long double> about_axis = Vec3<long double>::Zero();
          about_axis[axis] = static_cast<long double>(time) * (along - across) * L[axis];
          const auto truth = quaternion_of_rotation_vector(about_L) * witness.orientation *
                             quaternion_of_rotation_vector(about_axis);
          CHECK(angle_between(in_long_double(exact.at(time)).orientation, truth) <=
                rounding_of_free_top<double>(2 * std::abs(time)));  // 2 rad/s at most
        }
      }
}

TEST_CASE_TEMPLATE("Where L x w is zero the free top turns steadily", Real, double, long double) {
  const Vec3<Real> round(2, 2, 2), flat(2, 2, 1), uneven(3, 2, 1), locked(3, 0, 1);
  struct Case {
    Vec3<Real> inverse, momentum;
  };
  for (const auto& [inverse, momentum] :
       {Case{round, {1, 2, 3}}, Case{uneven, {0, 5, 0}}, Case{flat, {Real(0.1), Real(0.7), 0}},
        Case{locked, {1, 0, 2}}, Case{uneven, {0, 0, 0}}}) {
    const Top<Real> start{.angular_momentum_body = momentum, .inverse_moments = inverse};
    const FreeTop<Real> exact(start);
    const Top<Real> later = exact.at(Real(1.5));
    CHECK(same_bits(later.angular_momentum_body, momentum));
    CHECK(std::isinf(exact.period()));
    const Vec3<Real> turn = Real(1.5) * angular_velocity_body(start);
    CHECK(angle_between(later.orientation, quaternion_of_rotation_vector(turn)) <=
          // Half the rate 5 and the time 1 for each radian; sine, axis and product 10 once.
          spread<Real>(10) + spread<Real>(6) * turn.norm());
  }
}

TEST_CASE_TEMPLATE("A wobble whose square is no number any more leaves a steady spin", Real, double,
                   long double) {
  // Squares of these parts of L are 0, or so small that they have lost digits.
  const Real none = std::sqrt(std::numeric_limits<Real>::denorm_min()) / 16,
             little = 2 * std::sqrt(std::numeric_limits<Real>::denorm_min());
  for (const Vec3<Real>& inverse :
       {Vec3<Real>(3, 2, 1), Vec3<Real>(1, 2, 3), Vec3<Real>(1, Real(1e4), 1), Vec3<Real>(2, 2, 1)})
    for (const Real part : {none, little})
      for (const int axis : {0, 1, 2}) {
        if (part == little && axis == 1) continue;  // about a middle axis this one grows
        Vec3<Real> momentum(part, part, part);
        momentum[axis] = 5;
        const Top<Real> start{.angular_momentum_body = momentum, .inverse_moments = inverse};
        const Top<Real> later = FreeTop<Real>(start).at(Real(1.5));
        const Vec3<Real> turn = Real(1.5) * angular_velocity_body(start);
        CHECK(angle_between(later.orientation, quaternion_of_rotation_vector(turn)) <=
              rounding_of_free_top<Real>(turn.norm()));
        CHECK(distance<Real>(later.angular_momentum_body, momentum) <=
              5 * rounding_of_free_top<Real>(turn.norm()));
      }
}

TEST_CASE(
    "The free top is the same to the bit in any unit of inertia from 2^-900 to 2^900 kg m^2") {
  const Topd start = top_with_inverse({1, 1 / 2.0, 1 / 3.0}, {1, 4, 1.5});
  const Topd later = FreeTop(start).at(5);
  // Far enough that products of two, L² and L²/I², leave the range.
  for (const int power : {-900, -500, -40, 40, 500, 900}) {
    Topd scaled = start;
    scaled.angular_momentum_body *= std::ldexp(1.0, power);
    scaled.inverse_moments *= std::ldexp(1.0, -power);
    const Topd scaled_later = FreeTop(scaled).at(5);
    CHECK(scaled_later.orientation.real == later.orientation.real);
    CHECK(same_bits(scaled_later.orientation.imaginary, later.orientation.imaginary));
    CHECK(same_bits(scaled_later.angular_momentum_body * std::ldexp(1.0, -power),
                    later.angular_momentum_body));
  }
}

TEST_CASE(
    "Random tops with moments over six decades and spins over twelve are where long double has "
    "them") {
  std::mt19937_64 generator(13);
  std::uniform_real_distribution<double> decades(-6, 0), parts(-12, 0), signs(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    Vec3d inverse, L;
    for (int n = 0; n < 3; ++n) {
      inverse[n] = std::pow(10.0, decades(generator));
      L[n] = std::copysign(std::pow(10.0, parts(generator)), signs(generator));
    }
    const Topd start = top_with_inverse(inverse, L);
    const auto witness = in_long_double(start);
    const double rate =
        std::sqrt(2 * kinetic_energy(start) * std::max({inverse.x(), inverse.y(), inverse.z()}));
    const FreeTop<double> exact(start);
    const FreeTop<long double> truth(witness);
    for (const double radians : {0.1, 10.0, -1000.0}) {
      const double time = radians / rate;
      // The edge between the two kinds of motion makes 1 - m uncertain, see FreeTop.
      const long double flips = std::abs(time) / truth.period();
      const long double uncertain = 1 + flips / (1 - truth.parameter());
      CHECK(difference(exact.at(time), truth.at(time)) <=
            rounding_of_free_top<double>(std::abs(radians)) * uncertain);
    }
  }
}

TEST_CASE("Near the edge between the two kinds of motion the free top is no later than it says") {
  std::mt19937_64 generator(47);
  const auto random = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
  };
  for (int trial = 0; trial < 5000; ++trial) {
    const double apart = std::pow(10, random(-4, 0)), middle = 1 + random(0.01, 0.5) * apart;
    const Vec3d inverse = Vec3d(1, middle, middle + random(0.01, 0.5) * apart).cwiseInverse();
    // On the edge the terms of D_y, L_x² (i_x − i_y) and L_z² (i_y − i_z), are equal.
    const double x = std::pow(10, random(-8, 0)), off = std::pow(10, random(-18, 0));
    const double z = x * std::sqrt((inverse[0] - inverse[1]) / (inverse[1] - inverse[2]));
    const Topd start =
        top_with_inverse(inverse, {x, random(-1, 1), z * (trial % 2 == 0 ? 1 + off : 1 - off)});
    const double rate = std::sqrt(2 * kinetic_energy(start));  // the largest of 1/I is 1
    const FreeTop<double> exact(start);
    const FreeTop<long double> truth(in_long_double(start));
    const double half_periods = random(0, 6),
                 time =
                     std::min(half_periods * static_cast<double>(truth.period() / 2), 1e6 / rate);
    CAPTURE(off);
    CHECK(difference(exact.at(time), truth.at(time)) <=
          rounding_of_free_top<double>(rate * time) + 2 * rate * exact.time_uncertainty(time));
  }
}
