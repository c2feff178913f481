// How often a step asks for memory: each `new` of this program is counted.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <new>
#include <support/record.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>

namespace {

std::atomic<long> asked = 0;

void* counted(void* memory) {
  ++asked;
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t bytes) {
  return counted(std::malloc(std::max<std::size_t>(bytes, 1)));
}
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace {

using namespace tumble;

/// A thousand boxes in wind, two of them joined by a spring.
template <class AnyWorld>
void fill(AnyWorld& world) {
  const auto solid = mass_properties(Box<double>{{0.1, 0.2, 0.3}}, 2.0);
  std::vector<BodyHandle> boxes;
  for (int n = 0; n < 1000; ++n) {
    const Pose<double> start{{double(n), 0, 0}};
    const auto made = make_rigid_body("box", solid, start, Vec3d(0, 0, 0), Vec3d(1, 5, 0));
    boxes.push_back(world.add(made.body));
  }
  world.add(Gravity<double>{});
  world.add(QuadraticDrag<double>{.coefficient = 0.1, .wind = {1, 0, 0}});
  world.add(SpringBetween<double>{.spring = {.stiffness = 1}}, {boxes[0], boxes[1]});
}

/// In a hundred steps, after a first one.
template <class AnyWorld>
long asked_in_steps(AnyWorld& world) {
  world.step();
  const long before = asked;
  for (int n = 0; n < 100; ++n) world.step();
  return asked - before;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  World<double> world(steps_per_second(60));
  ManyBodies<double> packed(steps_per_second(60)), threaded(steps_per_second(60));
  fill(world);
  fill(packed);
  fill(threaded);
  threaded.use_threads(2);
  support::expect(asked > 1000, "to fill three worlds takes memory, and it is counted");
  const std::array<long, 3> times = {asked_in_steps(world), asked_in_steps(packed),
                                     asked_in_steps(threaded)};
  std::printf("a hundred steps of a thousand boxes ask for memory %ld times;\n", times[0]);
  std::printf("in packs %ld times, and on two threads %ld times\n", times[1], times[2]);
  support::expect(times == std::array<long, 3>{}, "no step asks for memory");
}
