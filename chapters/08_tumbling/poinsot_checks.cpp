#include <support/checks.hpp>
#include <support/polhodes.hpp>
#include <support/rules.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Exact = long double;

/// A top that faces anywhere, with these moments and this spin, rad/s, body axes.
Top<Exact> thrown(const Vec3<Exact>& moments, const Vec3<Exact>& spin) {
  Top<Exact> top{.orientation = quaternion_about(Vec3<Exact>(0.6L, 0, 0.8L), 1.0L),
                 .inverse_moments = moments.cwiseInverse()};
  set_angular_velocity_body(top, spin);
  return top;
}

/// Round axis 1, round axis 3, and close to the border between them.
const std::array<Vec3<Exact>, 3> spins = {
    {{2, 0.5L, 0.3L}, {0.3L, -0.5L, 2}, {0.001L, 1, 0.0005L}}};
const Vec3<Exact> moments(1, 2, 2.5L);

/// What the exact solution claims after a time, s: some tens of roundings for each radian.
Exact rounding_after(Exact time) {
  const Exact fastest = 3;  // rad/s
  return 100 * (1 + fastest * time) * unit_roundoff<Exact>;
}

}  // namespace

TEST_CASE("The plane that touches the ellipsoid at the tip of omega never moves") {
  for (const Vec3<Exact>& spin : spins) {
    const Top<Exact> start = thrown(moments, spin);
    const exact::FreeTop<Exact> exact(start);
    const Vec3<Exact> L = angular_momentum_world(start);
    const Exact twice_energy = 2 * kinetic_energy(start);
    for (int n = 0; n <= 100; ++n) {
      const Exact time = n * 0.3L;
      const Top<Exact> now = exact.at(time);
      // How far the ellipsoid reaches in the direction u that L had at the start, and where: of all
      // x with x·I x = 2 E the product x·u is largest at I⁻¹u √(2E/(u·I⁻¹u)), √(2E u·I⁻¹u).
      const Vec3<Exact> u = rotate_back(now.orientation, Vec3<Exact>(L / L.norm()));
      const Vec3<Exact> towards = now.inverse_moments.cwiseProduct(u);
      const Vec3<Exact> farthest = towards * std::sqrt(twice_energy / dot(u, towards));
      CHECK(std::abs(dot(farthest, u) - twice_energy / L.norm()) <= 3 * rounding_after(time));
      CHECK(distance(farthest, angular_velocity_body(now)) <= 3 * rounding_after(time));
    }
  }
}

TEST_CASE("Where the ellipsoid touches its plane the body is at rest: it rolls") {
  for (const Vec3<Exact>& spin : spins) {
    const exact::FreeTop<Exact> exact(thrown(moments, spin));
    for (const Exact time : {0.4L, 2.0L, 7.0L}) {
      const Vec3<Exact> contact = angular_velocity_body(exact.at(time));
      // The velocity of that point of the body, by a difference of places that errs by δ².
      const auto speed = [&](Exact delta) {
        const Vec3<Exact> before = rotate(exact.at(time - delta).orientation, contact),
                          after = rotate(exact.at(time + delta).orientation, contact);
        return (after - before).norm() / (2 * delta);
      };
      // With more of the series the quotient is 4 to about (ω δ)², with ω below 3 rad/s.
      const Exact delta = 1e-3L;
      CHECK(std::abs(speed(2 * delta) / speed(delta) - 4) <= 4 * (3 * delta) * (3 * delta));
    }
  }
}

TEST_CASE("The herpolhode runs between two circles that energy and momentum determine") {
  // No spin about the middle axis at first: the outer circle. A quarter of a period later it has
  // none about axis 3, or 1: the inner one. The border is where ω₁ = ω₃ √(I₃(I₃ − I₂)/I₁(I₂ − I₁)).
  const Exact border =
      std::sqrt(moments[2] * (moments[2] - moments[1]) / (moments[0] * (moments[1] - moments[0])));
  for (const Vec3<Exact>& spin :
       {Vec3<Exact>(2, 0, 0.5L), Vec3<Exact>(0.5L, 0, 2), Vec3<Exact>(border + 1e-3L, 0, 1),
        Vec3<Exact>(border - 1e-3L, 0, 1)}) {
    const Top<Exact> start = thrown(moments, spin);
    const exact::FreeTop<Exact> exact(start);
    const Vec3<Exact> L = angular_momentum_world(start);
    const auto [inner, outer] =
        herpolhode_radii(moments, 2 * kinetic_energy(start), L.squaredNorm());
    const auto radius_at = [&](Exact time) {
      return angular_velocity_world(exact.at(time)).cross(L).norm() / L.norm();
    };
    // Close to the border the inner radius is the root of a small difference.
    const Exact allowed = 10 * rounding_after(exact.period()) / inner;
    CHECK(std::abs(radius_at(0) - outer) <= allowed);
    CHECK(std::abs(radius_at(exact.period() / 4) - inner) <= allowed);
    for (int n = 0; n <= 200; ++n) {
      const Exact radius = radius_at(exact.period() * n / 200);
      CHECK(radius >= inner - allowed);
      CHECK(radius <= outer + allowed);
    }
  }
}

TEST_CASE("The herpolhode of a real body never bends back, and that of impossible moments does") {
  const auto sharpest_turns = [](const Vec3<Exact>& I) {
    const Top<Exact> start = thrown(I, {2, 0, 0.3L});
    const exact::FreeTop<Exact> exact(start);
    const Vec3<Exact> L = angular_momentum_world(start);
    const Exact h = exact.period() / 1000;
    const auto tip = [&](int n) { return angular_velocity_world(exact.at(n * h)); };
    Exact least = 1, most = -1;  // of the sine of the turn from one chord to the next
    for (int n = 0; n < 1000; ++n) {
      const Vec3<Exact> chord = tip(n + 1) - tip(n), next = tip(n + 2) - tip(n + 1);
      const Exact sine = dot(chord.cross(next), L) / (chord.norm() * next.norm() * L.norm());
      least = std::min(least, sine);
      most = std::max(most, sine);
    }
    return std::pair(least, most);
  };
  // The triangle inequality I₁ + I₂ ≥ I₃ decides, see chapter 3.
  for (const Vec3<Exact>& real : {Vec3<Exact>(1, 2, 2.5L), Vec3<Exact>(1, 1.1L, 2.09L)})
    CHECK(sharpest_turns(real).first > 0);
  for (const Vec3<Exact>& impossible : {Vec3<Exact>(1, 2, 3.1L), Vec3<Exact>(1, 3, 5)}) {
    CHECK(sharpest_turns(impossible).first < 0);
    CHECK(sharpest_turns(impossible).second > 0);
  }
}

TEST_CASE("The herpolhode's bend is a sum over the pairs of axes, wherever omega stands") {
  for (const Vec3<Exact>& I :
       {Vec3<Exact>(1, 2, 2.5L), Vec3<Exact>(3, 1.1L, 2), Vec3<Exact>(1, 3, 5)})
    for (const Vec3<Exact>& omega : {spins[0], spins[1], Vec3<Exact>(-0.7L, 1.3L, 0.9L)}) {
      const Vec3<Exact> L = I.cwiseProduct(omega);
      // Euler's equations, I ω' = L × ω, and their derivative; then the acceleration in the world.
      const Vec3<Exact> velocity = L.cross(omega).cwiseQuotient(I);
      const Vec3<Exact> change = I.cwiseProduct(velocity).cross(omega) + L.cross(velocity);
      const Vec3<Exact> acceleration = change.cwiseQuotient(I) + omega.cross(velocity);
      const Exact bend = dot(velocity.cross(acceleration), L);
      const Exact rest = std::pow(omega.prod(), Exact(2)) / (2 * I.prod());
      Exact sum = 0, terms = velocity.norm() * acceleration.norm() * L.norm();
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const Exact excess = I[i] + I[j] - I[k], a = omega[i] * omega[i], b = omega[j] * omega[j];
        const Exact factor = std::pow(I[i] - I[j], Exact(2)),
                    first = a * b / (I[k] * I[k]) * (I[i] * a / I[j] + I[j] * b / I[i]);
        sum += factor * (first * excess + rest * (I[i] * I[j] + I[k] * excess));
        terms += factor * (first * I.sum() + rest * (I[i] * I[j] + I[k] * I.sum()));
      }
      // Each factor of a term, and of the triple product, has a dozen roundings at most.
      CHECK(std::abs(bend - sum) <= 100 * unit_roundoff<Exact> * terms);
    }
}
