#include <benchmark/benchmark.h>

#include <tumble/force.hpp>

using namespace tumble;

namespace {

template <class Real>
void step_with_gravity(benchmark::State& state) {
  Particle<Real> ball = make_particle(Real(0.4), Vec3<Real>::Zero(), Vec3<Real>(8, 0, 10));
  const Vec3<Real> gravity(0, 0, Real(-9.81));
  for (auto _ : state) {
    add_gravity(ball, gravity);
    step(ball, Real(1e-9));
    clear_force(ball);
    benchmark::DoNotOptimize(ball);
  }
}

}  // namespace

BENCHMARK(step_with_gravity<float>)->Name("gravity, step and clear, float");
BENCHMARK(step_with_gravity<double>)->Name("gravity, step and clear, double");
