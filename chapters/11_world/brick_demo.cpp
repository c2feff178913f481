// The least program with a world in it: what the README shows, and the reference begins with.
//! [whole]
#include <iostream>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/world.hpp>

int main() {
  tumble::World<double> world(tumble::steps_per_second(240));
  // Edges in metres, a mass in kilograms; m/s and rad/s.
  const auto solid = tumble::mass_properties(tumble::Box<double>{{0.1, 0.2, 0.3}}, 2.0);
  const tumble::Pose<double> start{{0, 0, 1}};
  const tumble::Vec3d velocity(3, 0, 4), angular_velocity(1, 5, 0);
  const auto brick = tumble::make_rigid_body("brick", solid, start, velocity, angular_velocity);
  const tumble::BodyHandle handle = world.add("brick", brick.body);
  world.add(tumble::Gravity<double>{});
  for (int n = 0; n < 120; ++n) world.step();
  std::cout << world.position(handle).transpose() << " m\n";
}
//! [whole]
