#include <benchmark/benchmark.h>

#include <tumble/orientation.hpp>
#include <vector>

using namespace tumble;

namespace {

/// Steps each of some bodies that fit into the nearest cache by `rule`.
template <class Real, class Rule>
void each(benchmark::State& state, const Rule& rule) {
  struct Body {
    Quaternion<Real> orientation;
    Vec3<Real> angular_velocity = {Real(0.1), Real(0.2), Real(-0.3)};
  };
  std::vector<Body> bodies(250);
  for (auto _ : state) {
    for (Body& body : bodies)
      body.orientation = rule(body.orientation, body.angular_velocity, Real(1) / 60);
    benchmark::DoNotOptimize(bodies.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(bodies.size()));
}

template <class Real>
void first_order(benchmark::State& state) {
  each<Real>(state, [](const auto& q, const auto& w, Real h) { return turn_first_order(q, w, h); });
}
template <class Real>
void exponential(benchmark::State& state) {
  each<Real>(state, [](const auto& q, const auto& w, Real h) { return turn_exponential(q, w, h); });
}

}  // namespace

BENCHMARK(first_order<float>)->Name("a first-order turn, float");
BENCHMARK(first_order<double>)->Name("a first-order turn, double");
BENCHMARK(exponential<float>)->Name("an exponential turn, float");
BENCHMARK(exponential<double>)->Name("an exponential turn, double");
