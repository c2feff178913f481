#include <benchmark/benchmark.h>

#include <tumble/damping.hpp>
#include <vector>

using namespace tumble;

namespace {

template <class Real, class Damp>
void damping(benchmark::State& state, Real speed, Damp damp_one) {
  std::vector<Particle<Real>> particles(
      250,
      make_particle(Real(0.4), Vec3<Real>(Vec3<Real>::Zero()), Vec3<Real>(speed, speed, speed)));
  for (auto _ : state) {
    for (Particle<Real>& particle : particles) damp_one(particle);
    benchmark::DoNotOptimize(particles.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(particles.size()));
}

/// So near to 1 that the speeds stay what they are during the measurement.
const float rate = 1e-9f;

void factor_once(benchmark::State& state) {
  const float kept = fraction_kept(rate, 1.0f / 60);
  damping<float>(state, 5, [kept](Particlef& particle) { damp(particle, kept); });
}

void factor_per_body(benchmark::State& state) {
  float time_step = 1.0f / 60;
  benchmark::DoNotOptimize(time_step);
  damping<float>(state, 5, [&time_step](Particlef& particle) {
    benchmark::DoNotOptimize(time_step);
    damp(particle, fraction_kept(rate, time_step));
  });
}

void multiply_only(benchmark::State& state, float speed) {
  const float kept = 0.999f;
  damping<float>(state, speed, [kept](Particlef& particle) {
    const Vec3f damped = kept * particle.velocity;
    benchmark::DoNotOptimize(damped.data());
  });
}

void normal(benchmark::State& state) {
  multiply_only(state, 5);
}

void denormal(benchmark::State& state) {
  multiply_only(state, 1e-41f);
}

}  // namespace

BENCHMARK(factor_once)->Name("damp, the factor computed once a step");
BENCHMARK(factor_per_body)->Name("damp, the factor computed once a body");
BENCHMARK(normal)->Name("multiplication alone, of normal speeds");
BENCHMARK(denormal)->Name("multiplication alone, of denormal speeds");
