// A disc that spins between two springs, in steps that it would bear at rest.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <support/record.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

/// Spins about the line of the springs, off it by no more than 1e-7 of its spin.
World<double> disc_at(double spin, double time_step) {
  //! [disc]
  World<double> world(step_of_nanoseconds(std::int64_t(1e9 * time_step)));
  world.on_warning([](const std::string&) {});
  RigidBody<double> body;
  body.centre = make_particle<double>(1);
  body.top.inverse_moments = {1 / 0.01, 1 / 0.01, 1 / 0.02};
  const BodyHandle disc = world.add("disc", body);
  for (const double side : {-1.0, 1.0})
    world.add(SpringToPoint<double>{.spring = {.stiffness = 100, .rest_length = 4},
                                    .anchor = {0, 0, side * 8},
                                    .attachment = {0, 0, side * 0.1}},
              {disc});
  world.set_angular_velocity(disc, {1e-7 * spin, 0, spin});
  //! [disc]
  return world;
}

/// Motion and springs, J.
double energy_of(const World<double>& world) {
  const RigidBody<double> disc = world.body(world.handle_at(0));
  double sum = kinetic_energy(disc.centre) + kinetic_energy(disc.top);
  for (const EffectInstance<double>& entry : world.effects())
    sum += entry.effect->potential_energy({disc.centre, disc.top}, {disc.centre, disc.top});
  return sum;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double at_rest = disc_at(0, 1e-3).step_limit().time_step;
  notebook.value("at_rest", support::number("%.1f ms", 1000 * at_rest));
  for (const int degrees : {9, 90, 170})
    notebook.value("yields_at_" + std::to_string(degrees),
                   support::number("%.4g", yielding(degrees * std::numbers::pi / 180)));
  std::printf(
      "spin, rad/s  step, ms  limit, ms  nutation, rad a step  most tilt, rad  most energy\n");
  const auto run = [&](const std::string& name, double spin, double step) {
    World<double> world = disc_at(spin, step);
    const double limit = world.step_limit().time_step, first = energy_of(world);
    const double nutation = step * nutation_rate(world.body(world.handle_at(0)).top);
    double tilt = 0, energy = first;
    for (double time = 0; time < 60; time += step) {
      world.step();
      const Vec3d axis = rotate<double>(world.body(world.handle_at(0)).top.orientation, {0, 0, 1});
      tilt = std::max(tilt, std::atan2(axis.head<2>().norm(), axis.z()));
      energy = std::max(energy, energy_of(world));
    }
    std::printf("%11.0f %9.2f %10.2f %21.2f %15.1g %12.3g\n", spin, 1000 * step, 1000 * limit,
                nutation, tilt, energy / first);
    notebook.value(name + "_limit", support::number("%.1f ms", 1000 * limit));
    notebook.value(name + "_energy", support::number("%.2g", energy / first));
    notebook.value(name + "_tilt", support::number("%.1g rad", tilt));
    notebook.value(name + "_nutation", support::number("%.2f", nutation));
    return std::pair(tilt, energy / first);
  };
  run("still", 0, 0.9 * at_rest);
  const auto fast = run("fast", 100, 0.9 * at_rest);
  const auto safe = run("safe", 100, 0.99 * disc_at(100, 1e-3).step_limit().time_step);
  const auto sixty = run("sixty", 184, 1.0 / 60);
  const auto beyond = run("beyond", 200, 1.0 / 60);
  const auto slow = run("slow", 184, 0.99 * disc_at(184, 1e-3).step_limit().time_step);
  support::expect(fast.second > 10, "the springs feed on the spin");
  support::expect(sixty.first > 0.01 && beyond.first < 1e-6, "a band in which a tilt grows");
  support::expect(safe.first < 1e-6 && slow.first < 1e-6, "below the limit nothing grows");
}
