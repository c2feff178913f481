#include <benchmark/benchmark.h>

#include <tumble/semi_implicit_euler.hpp>
#include <vector>

using namespace tumble;

namespace {

template <class Real>
void stepping(benchmark::State& state, void (*advance)(Particle<Real>&, Real)) {
  std::vector<Particle<Real>> particles(
      250, make_particle(Real(0.4), Vec3<Real>(Vec3<Real>::Zero()), Vec3<Real>(8, 0, 10)));
  for (Particle<Real>& particle : particles) add_force(particle, Vec3<Real>(1, 2, 3));
  for (auto _ : state) {
    for (Particle<Real>& particle : particles) advance(particle, Real(1e-9));
    benchmark::DoNotOptimize(particles.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(particles.size()));
}

template <class Real>
void kick_then_drift(benchmark::State& state) {
  stepping<Real>(state, [](Particle<Real>& particle, Real h) { step(particle, h); });
}

template <class Real>
void explicit_euler(benchmark::State& state) {
  stepping<Real>(state, [](Particle<Real>& particle, Real h) { explicit_step(particle, h); });
}

}  // namespace

BENCHMARK(kick_then_drift<float>)->Name("kick, then drift, float");
BENCHMARK(explicit_euler<float>)->Name("explicit Euler, float");
BENCHMARK(kick_then_drift<double>)->Name("kick, then drift, double");
BENCHMARK(explicit_euler<double>)->Name("explicit Euler, double");
