#include "close_approaches.hpp"

#include <support/checks.hpp>

using namespace tumble;
using simulate::CloseApproaches;

namespace {

/// Past a point with G M = 1 at the distance 1, from the distance 18 on, in steps of h seconds; h
/// is w h at the closest place. `energy` per mass, J/kg.
struct Passage {
  double energy, h;
  Scheme scheme = Scheme::semi_implicit_euler;
  double phase = 0;  ///< of the steps
};

struct Passed {
  double lasting;    ///< change of the energy, in units of the kinetic energy at the closest place
  std::string said;  ///< first
  std::string summary;
};

World<double> world_of(const Passage& p, double distance = 18) {
  World<double> world(step_of_nanoseconds(std::int64_t(1e9 * p.h)));
  world.step_by(p.scheme);
  world.on_warning([](const std::string&) {});
  const double speed = std::sqrt(2 * (p.energy + 1 / distance));
  const double across = std::sqrt(2 * (p.energy + 1)) / distance;
  const Vec3d v = {-std::sqrt(speed * speed - across * across), across, 0};
  world.add("comet", Particle<double>{.position = Vec3d(distance, 0, 0) + p.phase * p.h * v,
                                      .velocity = v,
                                      .inverse_mass = 1});
  world.add("sun", Particle<double>{.inverse_mass = 0});
  world.add(PointGravity<double>{.strength = 1});
  return world;
}

/// What steps keep, H − (h/2) v·∇V of Euler's and of the others H, as far away as this.
double kept_energy(const World<double>& world, const Passage& p) {
  const Particle<double> comet = world.body(world.find("comet")).centre;
  const double r = comet.position.norm();
  const double swing = p.scheme == Scheme::semi_implicit_euler
                           ? p.h / 2 * comet.velocity.dot(comet.position) / (r * r * r)
                           : 0;
  return comet.velocity.squaredNorm() / 2 - 1 / r - swing;
}

Passed passed(const Passage& p) {
  World<double> world = world_of(p);
  CloseApproaches<double> approaches(world);
  const double before = kept_energy(world, p);
  std::string said;
  for (int n = 0; n < 1000; ++n) {
    const std::string now = approaches.look(world);
    CHECK((now.empty() || said.empty()));  // once
    said += now;
    world.step();
    const Particle<double> comet = world.body(world.find("comet")).centre;
    if (comet.position.norm() > 18 && comet.position.dot(comet.velocity) > 0) break;
  }
  return {std::abs(kept_energy(world, p) - before) / (1 + p.energy), said,
          approaches.summary(world)};
}

/// The largest lasting change among steps that begin elsewhere.
double largest_change(Passage p) {
  double largest = 0;
  for (p.phase = 0; p.phase < 1; p.phase += 0.125) largest = std::max(largest, passed(p).lasting);
  return largest;
}

constexpr Scheme schemes[] = {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki};

}  // namespace

TEST_CASE("A body that passes a point is told of if w h exceeds a quarter there, however fast") {
  for (const Scheme scheme : schemes)
    for (const double energy : {-0.05, 0.0, 0.5, 5.0, 50.0})
      for (double phase = 0; phase < 1; phase += 0.125) {
        INFO("scheme " << int(scheme) << ", energy " << energy << ", phase " << phase);
        CHECK(passed({energy, 0.22, scheme, phase}).said == "");
        // The fastest goes by in steps that are ten times as long as it is near at the closest.
        for (const double h : {0.3, 1.0})
          CHECK(passed({energy, h, scheme, phase}).said.find("'comet' is too close") !=
                std::string::npos);
      }
}

TEST_CASE("By any scheme a passage at a quarter keeps its energy, and one at 1 or 2 loses it") {
  // The bounds are those of what was measured, see most_turn_of_passage.
  for (const double energy : {-0.05, 0.0, 0.5, 5.0, 50.0})
    for (const double h : {0.25, 1.0, 2.0}) {
      INFO("energy " << energy << ", w h " << h);
      const double euler = largest_change({energy, h, Scheme::semi_implicit_euler}),
                   verlet = largest_change({energy, h, Scheme::verlet}),
                   suzuki = largest_change({energy, h, Scheme::suzuki});
      const double most = h == 2 ? 2 / 3. : h == 1 ? 0.2 : energy < 1 ? 1e-6 : 0.015;
      for (const double change : {euler, verlet, suzuki}) CHECK(change < most);
      if (h < 1) continue;
      const double least = h == 1 ? 0.004 : 0.09;
      for (const double change : {euler, verlet, suzuki}) CHECK(change > least);
      CHECK(verlet > euler / 2);
      CHECK(verlet < 2 * euler);
      CHECK(suzuki > euler / 7);
    }
}

TEST_CASE("Who comes too close is told once, with the distance and a step that is short enough") {
  CHECK(
      passed({0, 1}).said ==
      "at 36 s 'comet' is too close to the centre of 'point gravity' for steps of 1 s: it passes "
      "at 1.05 m, and its energy may change for good. That passage takes steps of 0.23 s or less");
  CHECK(passed({0, 1}).summary == "");
  for (const Scheme scheme : schemes)
    for (double phase = 0; phase < 1; phase += 0.125)
      for (const double energy : {-0.05, 0.0, 0.5, 5.0, 50.0}) {
        INFO("scheme " << int(scheme) << ", energy " << energy << ", phase " << phase);
        const std::string said = passed({energy, 1, scheme, phase}).said;
        const double step = std::stod(said.substr(said.find("takes steps of ") + 15));
        CHECK(step > 0.15);
        CHECK(passed({energy, step, scheme, phase}).said == "");
      }
}

TEST_CASE(
    "Of several bodies that come too close the one that needs the shortest steps is told last") {
  World<double> world = world_of({0, 1});
  // 9 m/s take it away for good; the diver falls from rest far away, past the point at half a
  // metre.
  world.add("leaver",
            Particle<double>{.position = {0, 2, 0}, .velocity = {0, 9, 0}, .inverse_mass = 1});
  world.add("diver",
            Particle<double>{
                .position = {0, 0, 10}, .velocity = {0.1, 0, -std::sqrt(0.19)}, .inverse_mass = 1});
  CloseApproaches<double> approaches(world);
  CHECK(approaches.look(world).starts_with(
      "at 0 s 'leaver' is too close to the centre of 'point gravity' for steps of 1 s: it passes "
      "at 2 m,"));
  for (int n = 0; n < 60; ++n) {
    CHECK(approaches.look(world) == "");
    world.step();
  }
  CHECK(
      approaches.summary(world) ==
      "3 bodies came too close to a point that attracts; at 13 s 'diver' is too close to the "
      "centre of 'point gravity' for steps of 1 s: it passes at 0.509 m, and its energy may change "
      "for good. That passage takes steps of 0.077 s or less");
}

TEST_CASE(
    "For who falls straight to a point no step is short enough, and who can't move is never told") {
  World<double> world = world_of({0, 1});
  world.add("stone",
            Particle<double>{.position = {0, 0, 2}, .velocity = {0, 0, -1}, .inverse_mass = 1});
  CHECK(CloseApproaches<double>(world).look(world).ends_with(
      "'stone' is too close to the centre of 'point gravity' for steps of 1 s: it passes at 0 m, "
      "and its energy may change for good. No step is short enough for that; let it pass farther "
      "away"));
}
