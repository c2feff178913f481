#include <support/second_method.hpp>
#include <support/tumbling_problems.hpp>
#include <tumble/exact/free_top.hpp>

using namespace tumble;
using namespace tumble::support;
using exact::FreeTop;

namespace {

template <class Real>
Top<Real> top_with(const Vec3<Real>& moments, const Vec3<Real>& spin) {
  Top<Real> top;
  top.orientation = normalized(Quaternion<Real>{1, {2, -3, 4}});
  top.inverse_moments = moments.cwiseInverse();
  set_angular_velocity_body(top, spin);
  return top;
}

/// What FreeTop may err by after so long; the energy allows no faster spin than this.
template <class Real>
long double claimed_error(const Top<Real>& top, long double time) {
  const auto& i = top.inverse_moments;
  const Real fastest = std::sqrt(2 * kinetic_energy(top) * std::max({i.x(), i.y(), i.z()}));
  return rounding_of_free_top<Real>(fastest * static_cast<Real>(std::abs(time)));
}

}  // namespace

TEST_CASE("The free top agrees with Fehlberg's rule, whatever the signs and the axes") {
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  const Vec3d moments(1, 2, 3);
  const double time = 3;
  const int steps = 1500;
  for (const auto& spin : {Vec3d(1, 2, 0.5), Vec3d(0.2, 0.1, 3), Vec3d(2, 0.1, 0.2)})
    for (const auto& [a, b, c] : orders)
      for (int signs = 0; signs < 8; ++signs) {
        const Vec3d sign((signs & 1) != 0 ? -1 : 1, (signs & 2) != 0 ? -1 : 1,
                         (signs & 4) != 0 ? -1 : 1);
        const Topd start = top_with<double>({moments[a], moments[b], moments[c]},
                                            Vec3d(spin[a], spin[b], spin[c]).cwiseProduct(sign));
        const auto witness = in_long_double(start);
        const auto truth = integrated_free_top(witness, time, steps);
        const long double truth_error = eighth_order_error(3.1L, time, steps);
        CHECK(difference(FreeTop(witness).at(time), truth) <=
              claimed_error(witness, time) + truth_error);
        CHECK(difference(FreeTop(start).at(time), truth) <= claimed_error(start, time));
      }
}

TEST_CASE("The free top agrees with Fehlberg's rule on the problems A to D") {
  for (const TumblingProblem& problem : tumbling_problems) {
    CAPTURE(problem.letter);
    const Topd start = top_of<double>(problem);
    const double time = 0.3;
    const int steps = 20'000;
    const auto witness = in_long_double(start);
    const auto truth = integrated_free_top(witness, time, steps);
    const long double rate = 2 * angular_velocity_body(witness).norm();
    CHECK(difference(FreeTop(witness).at(time), truth) <=
          claimed_error(witness, time) + eighth_order_error(rate, time, steps));
    CHECK(difference(FreeTop(start).at(time), truth) <= claimed_error(start, time));
  }
}

TEST_CASE_TEMPLATE(
    "The free top stays with the one in long double for 600 s on the problems A to D", Real,
    EVERY_PRECISION) {
  for (const TumblingProblem& problem : tumbling_problems) {
    CAPTURE(problem.letter);
    const Top<Real> start = top_of<Real>(problem);
    const FreeTop<Real> exact(start);
    const FreeTop<long double> truth(in_long_double(start));
    for (const double seconds : {0.0, 1e-6, 0.01, 1.0, 7.7, 60.0, 600.0}) {
      const auto time = static_cast<Real>(seconds);
      CHECK(difference(exact.at(time), truth.at(time)) <= claimed_error(start, time));
    }
  }
}

TEST_CASE_TEMPLATE("The free top returns after the periods that tables give", Real, double,
                   long double) {
  const FreeTop<Real> nearly_steady(top_with<Real>({1, 2, 3}, {Real(0.01L), 1, 0})),
      ordinary(top_with<Real>({1, 2, 3}, {1, 2, Real(0.5)}));
  CHECK(std::abs(nearly_steady.period() - 41.5092195293L) <= 0.5e-10L);
  CHECK(std::abs(ordinary.period() - 9.011153382704L) <= 0.5e-12L);
  CHECK(std::abs(ordinary.parameter() - 0.95L) <= 4 * unit_roundoff<Real>);
  // Relative to |L|, which is 4.5; an angular velocity is L by 1 at least.
  const auto allowed =
      4.5L * claimed_error(top_with<Real>({1, 2, 3}, {1, 2, Real(0.5)}), ordinary.period());
  CHECK((angular_velocity_body(ordinary.at(ordinary.period())) - Vec3<Real>(1, 2, Real(0.5)))
            .norm() <= allowed);
  CHECK((angular_velocity_body(ordinary.at(ordinary.period() / 2)) - Vec3<Real>(1, -2, -Real(0.5)))
            .norm() <= allowed);
}

TEST_CASE_TEMPLATE(
    "Wherever the free top is asked, L stands still in the world and the energy stays", Real,
    double, long double) {
  for (const TumblingProblem& problem : tumbling_problems) {
    CAPTURE(problem.letter);
    const Top<Real> start = top_of<Real>(problem);
    const auto witness = in_long_double(start);
    const Vec3<long double> L = angular_momentum_world(witness);
    const long double energy = kinetic_energy(witness);
    const FreeTop<Real> exact(start);
    for (int n = -300; n < 300; ++n) {
      const Real time = Real(0.731) * Real(n);
      const auto now = in_long_double(exact.at(time));
      // Neither grows with the time: the components come from one pair of numbers sn and cn. Each
      // rounds 20 times, 14 in sn and 6 in its amplitude. L turns back by the angles that it was
      // turned by, but for 40 roundings in the two turns and their products. The energy has each
      // component twice.
      CHECK((angular_momentum_world(now) - L).norm() / L.norm() <= spread<Real>(2 * 20 + 40));
      CHECK(std::abs(kinetic_energy(now) / energy - 1) <= 2 * spread<Real>(20));
    }
  }
}

TEST_CASE_TEMPLATE("To go on from where the free top is at some time changes nothing", Real, double,
                   long double) {
  for (const TumblingProblem& problem : tumbling_problems) {
    const Top<Real> start = top_of<Real>(problem);
    const FreeTop<Real> exact(start);
    for (const Real first : {-3.0, 0.4, 2.0})
      for (const Real second : {-5.0, 0.01, 8.0}) {
        const auto in_two = FreeTop<Real>(exact.at(first)).at(second);
        CHECK(difference(in_two, in_long_double(exact.at(first + second))) <=
              claimed_error(start, std::abs(first) + std::abs(second)) * 2);
      }
  }
}
