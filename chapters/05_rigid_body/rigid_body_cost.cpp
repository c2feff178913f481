#include <benchmark/benchmark.h>

#include <tumble/rigid_body.hpp>
#include <vector>

using namespace tumble;

namespace {

/// Runs `action` on each of 250 tops, few enough to stay in the nearest cache.
template <class Real, class Action>
void on_each_top(benchmark::State& state, const Action& action) {
  Top<Real> top;
  top.orientation = {.real = Real(0.8), .imaginary = Vec3<Real>(Real(0.6), 0, 0)};
  top.inverse_moments = Vec3<Real>(1, 2, 4);
  top.angular_momentum_body = Vec3<Real>(1, 2, 3);
  std::vector<Top<Real>> tops(250, top);
  for (auto _ : state) {
    for (Top<Real>& each : tops) action(each);
    benchmark::DoNotOptimize(tops.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(tops.size()));
}

template <class Real>
void by_rotating(benchmark::State& state) {
  on_each_top<Real>(state,
                    [](Top<Real>& top) { top.torque = inverse_inertia_times(top, top.torque); });
}

template <class Real>
void by_tensor(benchmark::State& state) {
  on_each_top<Real>(state,
                    [](Top<Real>& top) { top.torque = world_inverse_inertia(top) * top.torque; });
}

template <class Real>
void blow(benchmark::State& state) {
  const Vec3<Real> impulse(1, 2, 3);
  on_each_top<Real>(state, [&](Top<Real>& top) { add_angular_momentum(top, impulse); });
}

}  // namespace

BENCHMARK(by_rotating<float>)->Name("rotate in, divide, rotate out, float");
BENCHMARK(by_rotating<double>)->Name("rotate in, divide, rotate out, double");
BENCHMARK(by_tensor<float>)->Name("form the world tensor and multiply, float");
BENCHMARK(by_tensor<double>)->Name("form the world tensor and multiply, double");
BENCHMARK(blow<float>)->Name("a blow's angular momentum, float");
BENCHMARK(blow<double>)->Name("a blow's angular momentum, double");
