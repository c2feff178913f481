// Worlds whose bodies several threads step, and worlds that several threads ask, compiled so that
// every access to memory is watched.
#include <cstdio>
#include <string>
#include <thread>
#include <tumble/air_and_water.hpp>
#include <tumble/energy.hpp>
#include <tumble/gravity.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>
#include <tuple>
#include <utility>
#include <vector>

using namespace tumble;

namespace {

/// Points and boxes in turn, under an effect of each form, joined by springs criss-cross.
template <class SomeWorld>
SomeWorld net(std::size_t count) {
  using Real = decltype(SomeWorld().time_step());
  SomeWorld world;
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
  auto world = net<ManyBodies<Real>>(3001);
  world.use_threads(2);
  for (int n = 0; n < 3; ++n) world.step();
}

/// Two threads ask the same world all that it can answer.
template <class SomeWorld>
void ask() {
  auto world = net<SomeWorld>(301);
  world.step();
  const BodyHandle body = world.find("1");
  const auto questions = [&world = std::as_const(world), body] {
    const auto answers = std::tuple(world.bodies(), world.body(body), world.name_of(body),
                                    world.handles(), world.save(), world.plan(), world.warnings(),
                                    world.step_limit(), world.change_log(), stored_energy(world));
    if (std::get<3>(answers).size() != world.body_count()) std::puts("a handle is missing");
  };
  std::thread other(questions);
  questions();
  other.join();
}

}  // namespace

int main() {
  step<float>();
  step<double>();
  ask<World<double>>();
  ask<ManyBodies<float>>();
  std::puts("stepped and asked");
}
