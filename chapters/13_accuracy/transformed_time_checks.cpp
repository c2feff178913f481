#include <support/checks.hpp>
#include <tumble/alternation.hpp>
#include <tumble/transformed_time.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A star of strength 1 at the origin, that counts how often it is asked.
struct CountingStar {
  long* count;
  void operator()(Particled& particle, double) const {
    const double r = particle.position.norm();
    particle.force = -particle.position / (r * r * r);
    ++*count;
  }
  double pull_energy(const Particled& particle) const { return 1 / particle.position.norm(); }
};

/// A push that depends on time and place; its energy is made up, so that there is one to ask for.
struct ChangingPush {
  void operator()(Particled& particle, double time) const {
    particle.force = Vec3d(time, 2, -time) + particle.position;
  }
  double pull_energy(const Particled&) const { return 10; }
};

}  // namespace

TEST_CASE("The rest of an integration is a drift, a kick of the middle's push, and a drift") {
  const auto start = make_particle<double>(2, {1, 2, 3}, {4, 5, 6});
  const ChangingPush push;
  TransformedTime<ChangingPush, double> motion(start, push);
  CHECK(motion.bound() == 10 - 77);
  motion.finish(0.5);
  CHECK(motion.time() == 0.5);
  const Vec3d middle = Vec3d(1, 2, 3) + 0.25 * Vec3d(4, 5, 6);
  const Vec3d gained = 0.5 * (Vec3d(0.25, 2, -0.25) + middle) / 2;
  CHECK(distance(motion.particle().velocity, Vec3d(4, 5, 6) + gained) <=
        16 * unit_roundoff<double>);
  CHECK(distance(motion.particle().position, Vec3d(1, 2, 3) + 0.5 * Vec3d(4, 5, 6) +
                                                 0.25 * gained) <= 16 * unit_roundoff<double>);
  CHECK(motion.particle().force == Vec3d(0.5, 2, -0.5) + motion.particle().position);
}

TEST_CASE("A particle that would just escape is refused, and what it lacks is told") {
  long count = 0;
  const CountingStar star{&count};
  auto comet = make_particle<double>(1, {0.5, 0, 0}, {0, 2, 0});  // 1/r is v²/2
  CHECK(complaint_of([&] { carry_in_transformed_time<Verlet>(comet, star, 1, 10); }) ==
        "binding energy is 0 J; it must be greater than 0: the orbit is open");
  CHECK(comet.position == Vec3d(0.5, 0, 0));
}

TEST_CASE("About as many steps are made as were asked for, and a few trials to end in time") {
  for (const long steps : {1L, 10L, 100L}) {
    long count = 0;
    const CountingStar star{&count};
    auto planet = make_particle<double>(1, {1, 0, 0}, {0, 1, 0});  // round in 2 pi s
    carry_in_transformed_time<Verlet>(planet, star, 6, steps);
    CHECK(count >= steps);
    // A step more that went too far, up to four trials, and the finish asks twice. Verlet's rule
    // asks once in a step, or twice.
    CHECK(count <= 2 * (steps + 1 + 4) + 4);
    if (steps == 100) {
      CHECK(distance(planet.position, Vec3d(std::cos(6.0), std::sin(6.0), 0)) <= 1e-2);
      CHECK(distance(planet.force, -planet.position) <= 1e-2);
    }
  }
  long count = 0;
  auto planet = make_particle<double>(1, {1, 0, 0}, {0, 1, 0});
  const CountingStar star{&count};
  CHECK(complaint_of([&] { carry_in_transformed_time<Verlet>(planet, star, -1, 10); }) ==
        "time is -1 s; it must be 0 or more");
}
