// Three scenes, and what each of them calls for.
#include <support/record.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

/// The plan without the columns that only the world's author reads.
void show(const char* title, const Plan& plan) {
  std::printf("%s\n", title);
  for (const PlanRow& row : plan.rows)
    std::printf(
        "  %-21s %9s  %s\n", row.effect.c_str(),
        row.visited ? (std::to_string(row.visited) + "/" + std::to_string(row.of)).c_str() : "-",
        row.reason.c_str());
  std::printf("\n");
}

//! [rain]
World<float> rain() {
  World<float> world;
  for (int n = 0; n < 100'000; ++n)
    world.add("drop " + std::to_string(n), make_particle<float>(1e-5f, {0, 0, 1.0f + float(n)}));
  world.add(Gravity<float>{});
  return world;
}
//! [rain]

//! [mixed]
World<float> balls_and_boxes() {
  World<float> world;
  const auto ball = mass_properties(Sphere<float>{0.1f}, 2);
  const auto box = mass_properties(Box<float>{{0.1f, 0.2f, 0.3f}}, 2);
  for (int n = 0; n < 512; ++n)
    world.add("body " + std::to_string(n),
              make_rigid_body<float>("body", n < 500 ? ball : box, {}, {0, 0, 0}, {0, 1, 0}).body);
  return world;
}
//! [mixed]

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  notebook.value("drops", std::to_string(rain().body_count()));
  show("100000 drops of rain", rain().plan());
  show("500 spinning balls and 12 spinning boxes, far from everything", balls_and_boxes().plan());

  //! [coin]
  World<double> table;
  const BodyHandle coin = table.add(
      "coin",
      make_rigid_body<double>("coin", mass_properties(Box<double>{{0.02, 0.02, 0.002}}, 0.005))
          .body);
  table.add(AngularDamping<double>{.rate = 0.1});
  for (int n = 0; n < 60; ++n) table.step();
  table.set_angular_velocity(coin, {0, 0, 30});
  for (const std::string& sentence : table.change_log()) std::printf("%s\n", sentence.c_str());
  //! [coin]
  support::expect(table.change_log().size() == 2, "a first spin calls for damping and for turning");
}
