// What another project may do with tumble::tumble. The README shows the lines between its marks.
#include <iostream>
// README
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/world.hpp>
// end

namespace {

/// Whether a product and a sum round one after the other, as the library's target asks of every
/// user's compiler. A fused operation would keep the last term of (1 + e)² = 1 + 2e + e².
bool rounds_twice() {
  volatile double given = 1 + 0x1p-30;
  const double factor = given;
  const double rounded = 1 + 0x1p-29;
  return factor * factor - rounded == 0;
}

}  // namespace

int main() {
  // clang-format off
  // README
  tumble::World<double> world(tumble::steps_per_second(240));
  const auto brick = tumble::mass_properties(tumble::Box<double>{{0.1, 0.2, 0.3}}, 2.0);  // m and kg
  world.add("brick", tumble::make_rigid_body<double>("brick", brick, {{0, 0, 1}}, {3, 0, 4}, {1, 5, 0}).body);
  world.add(tumble::Gravity<double>{});
  for (int n = 0; n < 120; ++n) world.step();
  std::cout << world.body(world.find("brick")).centre.position.transpose() << " m\n";
  // end
  // clang-format on
  return rounds_twice() ? 0 : 1;
}
