// A free kick with spin and without, and a ball that bobs in a lake.
#include <support/record.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/spheres.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

// A football: 0.43 kg, radius 0.11 m, struck with 25 m/s and six turns a second about the
// upright.
World<double> free_kick(double turns_per_second) {
  //! [kick]
  const double radius = 0.11, density = 1.2, area = std::numbers::pi * radius * radius;
  const double spin = 2 * std::numbers::pi * turns_per_second;
  World<double> world(steps_per_second(240));
  world.add("ball",
            make_rigid_body<double>("ball", mass_properties(HollowSphere<double>{radius}, 0.43),
                                    {{0, 0, radius}}, {24.1, 0, 6.5}, {0, 0, spin})
                .body);
  world.add(Gravity<double>{});
  world.add(QuadraticDrag<double>{.coefficient = drag_coefficient(density, 0.25, area)});
  // A fifth of what air without friction would give: a wake is not so well behaved.
  world.add(Magnus<double>{.strength = 8.0 / 3 * std::numbers::pi * density * radius * radius *
                                       radius / 5});
  //! [kick]
  return world;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  World<double> curved = free_kick(6), straight = free_kick(0);
  auto path = notebook.table(
      "free_kick", {"x with spin (m)", "y with spin (m)", "x without (m)", "y without (m)"});
  for (int n = 0; n < 290; ++n) {
    const auto a = curved.position(curved.find("ball"));
    const auto b = straight.position(straight.find("ball"));
    if (n % 4 == 0) path.row(a.x(), a.y(), b.x(), b.y());
    curved.step();
    straight.step();
  }
  const double bend = curved.position(curved.find("ball")).y();
  for (const World<double>* world : {&curved, &straight}) {
    World<double> copy = *world;
    for (const PlanRow& row : copy.plan().rows)
      if (row.effect == "Magnus force")
        std::printf("Magnus force: %zu of %zu bodies; %s\n", row.visited, row.of,
                    row.reason.c_str());
  }
  std::printf("after %.2f s the spinning ball is %.2f m to the side\n", curved.time(), bend);
  support::expect(std::abs(straight.position(straight.find("ball")).y()) == 0,
                  "without spin it flies straight");
  support::expect(bend > 1, "with spin it bends to the left, as seen from the foot");
  notebook.value("bend", support::number("%.1f m", bend));

  //! [lake]
  World<double> lake(steps_per_second(240));
  const double radius = 0.11, mass = 0.43;
  const BodyHandle floating = lake.add("ball", make_particle<double>(mass, {0, 0, -1}));
  lake.add(Gravity<double>{});
  lake.add(Buoyancy<double>{.radius = radius});
  lake.add(LinearDamping<double>{.rate = 3});
  //! [lake]
  auto bobbing = notebook.table("bobbing", {"time (s)", "height (m)"});
  for (int n = 0; n < 240 * 10; ++n) {
    bobbing.row(lake.time(), lake.position(floating).z());
    lake.step();
  }
  const double height = lake.position(floating).z();
  const double depth = radius - height;
  const double displaced = 1000 * std::numbers::pi * depth * depth * (radius - depth / 3);
  notebook.value("depth", support::number("%.0f mm", 1000 * depth));
  std::printf("it comes to rest with %.1f mm below the surface, which displaces %.3f kg of water\n",
              1000 * depth, displaced);
  support::expect(std::abs(displaced - mass) < 1e-3, "it displaces its own weight: Archimedes");
}
