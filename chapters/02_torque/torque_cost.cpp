#include <benchmark/benchmark.h>

#include <tumble/torque.hpp>
#include <vector>

using namespace tumble;

namespace {

template <class Real>
void force_at_a_point(benchmark::State& state) {
  std::vector<Wrench<Real>> wrenches(250);
  const Vec3<Real> force(1, 2, 3), point(4, 5, 6);
  for (auto _ : state) {
    for (Wrench<Real>& wrench : wrenches) {
      wrench.force += force;
      wrench.torque += torque_about(wrench.about, point, force);
    }
    benchmark::DoNotOptimize(wrenches.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(wrenches.size()));
}

template <class Real>
void checked_force_at_a_point(benchmark::State& state) {
  std::vector<Wrench<Real>> wrenches(250);
  Vec3<Real> force(1, 2, 3), point(4, 5, 6);
  for (auto _ : state) {
    for (Wrench<Real>& wrench : wrenches) {
      benchmark::DoNotOptimize(force);
      add_force_at(wrench, force, point);
    }
    benchmark::DoNotOptimize(wrenches.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(wrenches.size()));
}

}  // namespace

BENCHMARK(force_at_a_point<float>)->Name("a force at a point, float");
BENCHMARK(force_at_a_point<double>)->Name("a force at a point, double");
BENCHMARK(checked_force_at_a_point<float>)->Name("a force at a point, checked to be finite, float");
BENCHMARK(checked_force_at_a_point<double>)
    ->Name("a force at a point, checked to be finite, double");
