// Worlds whose bodies several threads step, compiled so that every access to memory is watched.
#include <cstdio>
#include <string>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>
#include <vector>

using namespace tumble;

namespace {

/// Points and boxes in turn, under an effect of each form, joined by springs criss-cross.
template <class Real>
ManyBodies<Real> net() {
  constexpr std::size_t count = 3001;
  ManyBodies<Real> world;
  const auto shape = mass_properties(Box<Real>{{1, 2, 3}}, 2);
  std::vector<BodyHandle> bodies, joined;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t row = n / 100;
    const Vec3<Real> place(static_cast<Real>(n % 100), static_cast<Real>(row), 0);
    const std::string name = std::to_string(n);
    if (n % 3 == 0)
      bodies.push_back(world.add(name, make_particle<Real>(1, place)));
    else
      bodies.push_back(world.add(
          name, make_rigid_body<Real>("box", shape, {place, {}}, {1, 0, 0}, {0, 1, 2}).body));
  }
  for (std::size_t n = 0; n < count; ++n)
    joined.insert(joined.end(), {bodies[n], bodies[(n + 1 + n * 7919 % (count - 1)) % count]});
  world.add(Gravity<Real>{});
  world.add(AngularDamping<Real>{.rate = Real(0.1)});
  world.add(Magnus<Real>{.strength = Real(0.01), .wind = {1, 0, 0}});
  world.add(SpringBetween<Real>{{.stiffness = 3, .rest_length = 1}}, joined);
  return world;
}

template <class Real>
void step() {
  ManyBodies<Real> world = net<Real>();
  world.backend().use_threads(2);
  for (int n = 0; n < 3; ++n) world.step();
}

}  // namespace

int main() {
  step<float>();
  step<double>();
  std::puts("stepped");
}
