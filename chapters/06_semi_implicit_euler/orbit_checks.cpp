#include <support/checks.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A satellite of 1 kg in units where a circle of radius 1 takes 2π. `eccentricity` 0 is the
/// circle; it starts where it is nearest.
template <class Real>
Particle<Real> satellite(Real eccentricity) {
  return make_particle(Real(1), Vec3<Real>(1, 0, 0), Vec3<Real>(0, std::sqrt(1 + eccentricity), 0));
}

template <class Real>
void gather_pull(Particle<Real>& body) {
  const Real radius = body.position.norm();
  clear_force(body);
  add_force(body, -body.position / (radius * radius * radius));
}

template <class Real>
Real orbit_energy(const Particle<Real>& body) {
  return body.velocity.squaredNorm() / 2 - 1 / body.position.norm();
}

template <class Real>
Real angular_momentum(const Particle<Real>& body) {
  return body.position.cross(body.velocity).z();
}

/// The largest error of the energy while the satellite goes round from step `first` to step `last`.
double energy_error(int steps_per_radian, int first, int last) {
  Particled body = satellite(0.5);
  const double start = orbit_energy(body);
  double largest = 0;
  for (int n = 1; n <= last; ++n) {
    gather_pull(body);
    step(body, 1.0 / steps_per_radian);
    if (n >= first) largest = std::max(largest, std::abs(orbit_energy(body) - start));
  }
  return largest;
}

}  // namespace

TEST_CASE_TEMPLATE("On an orbit kick and drift keeps the angular momentum", Real, EVERY_PRECISION) {
  Particle<Real> body = satellite(Real(0.5));
  const Real start = angular_momentum(body), time_step = Real(0.02);
  const int steps = 2000;
  for (int n = 1; n <= steps; ++n) {
    gather_pull(body);
    step(body, time_step);
    // The force is off its direction by some roundings, r F h < 0.03; v and x by one each a step.
    // |x| stays under 3.1 and |v| under 1.3, so |x||v| stays under 4.
    const Real bound =
        Real(n) * unit_roundoff<Real> * (2 * 4 + 8 * Real(0.03)) + 4 * unit_roundoff<Real>;
    REQUIRE(std::abs(angular_momentum(body) - start) <= bound);
  }
}

TEST_CASE_TEMPLATE("On an orbit explicit Euler multiplies the angular momentum by 1 + h^2/r^3",
                   Real, EVERY_PRECISION) {
  Particle<Real> body = satellite(Real(0.5));
  const Real time_step = Real(0.02);
  for (int n = 1; n <= 1000; ++n) {
    const Real radius = body.position.norm(), before = angular_momentum(body);
    gather_pull(body);
    explicit_step(body, time_step);
    const Real factor = 1 + time_step * time_step / (radius * radius * radius);
    // The products of a long orbit cancel; |x||v| is under 5 times their difference here.
    REQUIRE(std::abs(angular_momentum(body) - before * factor) <=
            16 * 5 * unit_roundoff<Real> * before);
  }
  CHECK(angular_momentum(body) > Real(1.02) * angular_momentum(satellite(Real(0.5))));
}

TEST_CASE("On an orbit the energy of kick and drift swings and does not drift") {
  // An orbit of eccentricity 0.5 that starts at distance 1 takes 2π √8 = 17.8.
  const int steps_per_radian = 50, orbit = 889;
  const double early = energy_error(steps_per_radian, 1, 10 * orbit);
  const double late = energy_error(steps_per_radian, 490 * orbit, 500 * orbit);
  CHECK(late < 1.05 * early);
  // First order: half the step, half the swing.
  for (const int steps : {100, 200, 400}) {
    const double ratio =
        energy_error(steps, 1, 18 * steps) / energy_error(2 * steps, 1, 36 * steps);
    CHECK(ratio > 1.9);
    CHECK(ratio < 2.1);
  }
}

TEST_CASE("Under a pendulum's pull or a sun's E + hFv/2 wavers by h², and E by h") {
  // Of 1 kg: a pendulum of 1 rad/s released at 2 rad, and the satellite.
  const auto pendulum_pull = [](const Vec3d& place) { return Vec3d(-std::sin(place.x()), 0, 0); };
  const auto pendulum_energy = [](const Particled& body) {
    return body.velocity.squaredNorm() / 2 - std::cos(body.position.x());
  };
  const auto sun_pull = [](const Vec3d& place) -> Vec3d {
    return -place / std::pow(place.norm(), 3);
  };
  /// How far E, and E + ½ h F·v, get from their start in the time between two moments.
  const auto wavering = [](const auto& pull, const auto& energy, const Particled& start, double h,
                           double from, double to) {
    Particled body = start;
    const auto nearby = [&] {
      return energy(body) + h / 2 * pull(body.position).dot(body.velocity);
    };
    const double first_energy = energy(body), first_nearby = nearby();
    double energy_off = 0, nearby_off = 0;
    for (int n = 1; n * h <= to; ++n) {
      clear_force(body);
      add_force(body, pull(body.position));
      step(body, h);
      if (n * h < from) continue;
      energy_off = std::max(energy_off, std::abs(energy(body) - first_energy));
      nearby_off = std::max(nearby_off, std::abs(nearby() - first_nearby));
    }
    return std::pair(energy_off, nearby_off);
  };
  const auto check = [&](const auto& pull, const auto& energy, const Particled& start) {
    for (const double h : {0.04, 0.02, 0.01}) {
      CAPTURE(h);
      const auto [energy_off, nearby_off] = wavering(pull, energy, start, h, 0, 100);
      const auto [half_energy, half_nearby] = wavering(pull, energy, start, h / 2, 0, 100);
      // A first order halves, a second quarters; the next order is below a twentieth of either.
      const double ratio = energy_off / half_energy, nearby_ratio = nearby_off / half_nearby;
      CHECK(ratio > 1.9);
      CHECK(ratio < 2.1);
      CHECK(nearby_ratio > 3.9);
      CHECK(nearby_ratio < 4.1);
    }
    // It does not drift: some hundred swings later it wavers as far.
    const double early = wavering(pull, energy, start, 0.04, 0, 100).second;
    const double late = wavering(pull, energy, start, 0.04, 1900, 2000).second;
    CHECK(late < 1.05 * early);
  };
  check(pendulum_pull, pendulum_energy, make_particle(1.0, Vec3d(2, 0, 0)));
  check(sun_pull, orbit_energy<double>, satellite(0.5));
}

TEST_CASE("On an orbit of eccentricity 0.5 explicit Euler gains energy in every step") {
  Particled body = satellite(0.5);
  for (int n = 0; n < 2000; ++n) {
    const double before = orbit_energy(body);
    gather_pull(body);
    explicit_step(body, 0.02);
    REQUIRE(orbit_energy(body) > before);
  }
}
