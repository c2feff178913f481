#include <support/checks.hpp>
#include <support/exact_motion.hpp>
#include <support/own_steps.hpp>
#include <support/rules.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Wide = long double;

/// A particle on a spring that a push swings, from a look at the clock too.
struct SwungSpring {
  template <class Real>
  void operator()(Particle<Real>& particle, Real time) const {
    particle.force = -particle.position;
    particle.force.x() += std::cos(2 * time);
  }
};

}  // namespace

TEST_CASE_TEMPLATE("By each pair an orbit is where the exact one is, within the tolerance's reach",
                   Real, EVERY_PRECISION) {
  const auto orbit = eccentric_orbit<Real>();
  const auto truth = truth_of(orbit);
  for (auto& contestant : by_own_steps(orbit)) {
    CAPTURE(contestant.name);
    // What is lost at the nearest point is spread by 81 (the ratio of the accelerations) and by the
    // round that follows.
    for (const double tolerance : {1e-2, 1e-3})
      CHECK(error_of(exactly(contestant.run(tolerance)), truth) <= 81 * 10 * tolerance);
  }
  CHECK(error_of(exactly(nystrom_by_own_steps(orbit).run(1e-3)), truth) <= 81 * 10 * 1e-3);
}

TEST_CASE(
    "The Nystrom pair's error falls as its order says, under a force that changes with time") {
  Particle<Wide> start = make_particle<Wide>(1, {0.5L, 0, 0}, {0, 1, 0});
  const SwungSpring force;
  const auto error = [&](int count) {
    NystromSteps<DormandPrinceNystrom86, SwungSpring, Wide> steps(start, force, 0, {1, 1});
    for (int n = 0; n < count; ++n) {
      steps.attempt(2.0L / count);
      steps.accept();
    }
    const Particle<Wide> end = steps.body();
    const Vec3<Wide> place(5 * std::cos(2.0L) / 6 - std::cos(4.0L) / 3, std::sin(2.0L), 0),
        velocity(2 * std::sin(4.0L) / 3 - 5 * std::sin(2.0L) / 6, std::cos(2.0L), 0);
    return (end.position - place).norm() + (end.velocity - velocity).norm();
  };
  const Wide order = std::log2(error(8) / error(16));
  CAPTURE(double(order));
  CHECK(std::abs(order - 8) < 0.3L);
}

TEST_CASE("The number of a particle's steps does not depend on the unit of time or of length") {
  // Lengths in units of 2^-length m, times in units of 2^time s: velocities, tolerances and the
  // star's strength change as their units say.
  const auto steps = [](int time, int length, bool with_its_unit = true) {
    const double t = std::ldexp(1, time), l = std::ldexp(1, length);
    auto orbit = eccentric_orbit<double>();
    orbit.start.position *= l;
    orbit.start.velocity *= l * t;
    orbit.evaluate_forces.strength *= l * l * l * t * t;
    const ParticleTolerance<double> tolerance{1e-6 * l * t,
                                              with_its_unit ? 1e-6 * l * t * t : 1e-6 * l * t};
    Particled by_pair = orbit.start, by_nystrom = orbit.start;
    const double seconds = orbit.seconds / t;
    return std::pair(
        integrate<DormandPrince54>(by_pair, orbit.evaluate_forces, 0.0, seconds, tolerance).steps,
        integrate_by_nystrom<DormandPrinceNystrom86>(by_nystrom, orbit.evaluate_forces, 0.0,
                                                     seconds, tolerance)
            .steps);
  };
  const auto in_seconds = steps(0, 0);
  for (const int time : {-10, 10})
    for (const int length : {-10, 0, 10}) CHECK(steps(time, length) == in_seconds);
  // One number for both, which is no tolerance but a choice of units.
  CHECK(steps(10, 0, false).first > 2 * in_seconds.first);
}

TEST_CASE_TEMPLATE("In transformed time a planet stays on its ellipse, however long its steps",
                   Real, EVERY_PRECISION) {
  const auto orbit = eccentric_orbit<Real>();
  const Vec3<Wide> x = orbit.start.position.template cast<Wide>(),
                   v = orbit.start.velocity.template cast<Wide>();
  const auto eccentricity = [](const Vec3<Wide>& place, const Vec3<Wide>& velocity) -> Vec3<Wide> {
    return velocity.cross(place.cross(velocity)) - place.normalized();
  };
  // How far from its ellipse a row leads the planet, by its energy and its eccentricity vector.
  const int steps = 40;
  const auto off = [&]<class Row>(Row, Real length) {
    TransformedTime<Star<Real>, Real> motion(orbit.start, orbit.evaluate_forces);
    Wide most = 0;
    for (int n = 0; n < steps; ++n) {
      motion.template step<Row>(length);
      const Vec3<Wide> place = motion.particle().position.template cast<Wide>(),
                       velocity = motion.particle().velocity.template cast<Wide>();
      most = std::max({most,
                       std::abs(velocity.squaredNorm() / 2 - 1 / place.norm() -
                                (v.squaredNorm() / 2 - 1 / x.norm())),
                       (eccentricity(place, velocity) - eccentricity(x, v)).norm()});
    }
    return most;
  };
  for (const Real length : {Real(0.5), Real(2), Real(10), Real(100)}) {  // a round has 2 pi
    CAPTURE(length);
    // 30 roundings a step, and a speed that is three times as large at the nearest point, as a
    // square. A step of many rounds makes numbers that are larger by so much, and takes them back.
    const Wide bound = 5 * 9 * 30 * steps * unit_roundoff<Real> * std::max(Real(1), length);
    CHECK(off(Verlet(), length) <= bound);
    CHECK(off(Suzuki(), length) <= 5 * bound);
  }
  // What is not made of whole steps of Verlet leaves it.
  CHECK(off(BlanesMoanFourth(), Real(0.5)) > 1e-3L);
}

TEST_CASE("In transformed time each row has its order in time, against the exact orbit") {
  Problem<Particle<Wide>, Star<Wide>> orbit = eccentric_orbit<Wide>();
  const auto truth = truth_of(orbit);
  const auto order = [&]<class Row>(Row, int steps) {
    const auto error = [&](int count) {
      Particle<Wide> particle = orbit.start;
      carry_in_transformed_time<Row>(particle, orbit.evaluate_forces, orbit.seconds, count);
      return (particle.position - truth.position).norm();
    };
    return std::log2(error(steps) / error(2 * steps));
  };
  CHECK(std::abs(order(Verlet(), 256) - 2) < 0.1L);
  CHECK(std::abs(order(KahanLiSixth(), 64) - 6) < 0.3L);
  CHECK(std::abs(order(KahanLiEighth(), 32) - 8) < 0.4L);
}
