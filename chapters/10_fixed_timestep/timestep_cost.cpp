#include <benchmark/benchmark.h>

#include <tumble/interpolation.hpp>
#include <tumble/step_clock.hpp>
#include <vector>

using namespace tumble;

namespace {

void clock_frame(benchmark::State& state) {
  StepClock clock = make_step_clock(steps_per_second(60));
  std::int64_t frame = 6'944'444;
  for (auto _ : state) {
    benchmark::DoNotOptimize(frame);
    benchmark::DoNotOptimize(steps_due(clock, frame));
  }
  state.SetItemsProcessed(state.iterations());
}

template <class Real>
void interpolate(benchmark::State& state) {
  Pose<Real> from, to;
  to.position = Vec3<Real>(1, 2, 3);
  to.orientation = quaternion_about(Vec3<Real>(1, 2, 2), Real(0.1));
  std::vector<Pose<Real>> before(250, from), after(250, to), drawn(250);
  for (auto _ : state) {
    for (std::size_t n = 0; n < drawn.size(); ++n)
      drawn[n] = interpolated(before[n], after[n], Real(0.3));
    benchmark::DoNotOptimize(drawn.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(drawn.size()));
}

}  // namespace

BENCHMARK(clock_frame)->Name("the clock, a frame");
BENCHMARK(interpolate<float>)->Name("a pose between two poses, float");
BENCHMARK(interpolate<double>)->Name("a pose between two poses, double");
