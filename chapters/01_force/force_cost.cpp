#include <benchmark/benchmark.h>

#include <tumble/force.hpp>
#include <vector>

using namespace tumble;

namespace {

/// Enough balls for a steady mean, few enough to stay in the nearest cache.
template <class Real>
std::vector<Particle<Real>> balls() {
  return std::vector(
      250, make_particle(Real(0.4), Vec3<Real>(Vec3<Real>::Zero()), Vec3<Real>(8, 0, 10)));
}

template <class Real>
void by_force(benchmark::State& state) {
  std::vector<Particle<Real>> particles = balls<Real>();
  const Vec3<Real> gravity(0, 0, Real(-9.81));
  for (auto _ : state) {
    for (Particle<Real>& ball : particles) {
      add_gravity(ball, gravity);
      step(ball, Real(1e-9));
      clear_force(ball);
    }
    benchmark::DoNotOptimize(particles.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(particles.size()));
}

template <class Real>
void by_acceleration(benchmark::State& state) {
  std::vector<Particle<Real>> particles = balls<Real>();
  const Vec3<Real> gravity(0, 0, Real(-9.81));
  for (auto _ : state) {
    for (Particle<Real>& ball : particles) {
      accelerate(ball, gravity, Real(1e-9));
      step(ball, Real(1e-9));
    }
    benchmark::DoNotOptimize(particles.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(particles.size()));
}

}  // namespace

BENCHMARK(by_force<float>)->Name("gravity as a force, step and clear, float");
BENCHMARK(by_force<double>)->Name("gravity as a force, step and clear, double");
BENCHMARK(by_acceleration<float>)->Name("gravity as an acceleration and step, float");
BENCHMARK(by_acceleration<double>)->Name("gravity as an acceleration and step, double");
