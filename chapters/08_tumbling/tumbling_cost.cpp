#include <benchmark/benchmark.h>

#include <support/rules.hpp>

using namespace tumble;

namespace {

/// Runs a rule on 250 tops, few enough to stay in the nearest cache.
template <class Real, class Turn>
void on_each_top(benchmark::State& state, const Turn& turn) {
  std::vector<Top<Real>> tops(250, support::top_of<Real>(support::tumbling_problems[1]));
  for (auto _ : state) {
    for (Top<Real>& top : tops) turn(top, Real(1) / 64);
    benchmark::DoNotOptimize(tops.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(tops.size()));
}

template <class Real>
void measure(const char* precision) {
  const auto add = [&](const char* name, const auto& turn) {
    benchmark::RegisterBenchmark(
        (std::string(name) + ", " + precision).c_str(),
        [turn](benchmark::State& state) { on_each_top<Real>(state, turn); });
  };
  add("steady", [](Top<Real>& top, Real h) { turn_steadily(top, h); });
  add("explicit, |L| restored", [](Top<Real>& top, Real h) { turn_restoring_momentum(top, h); });
  add("implicit, one Newton step", [](Top<Real>& top, Real h) { turn_implicitly(top, h); });
  add("momentum-carrying", [](Top<Real>& top, Real h) { turn_carrying_momentum(top, h); });
  add("splitting by axes", [](Top<Real>& top, Real h) { turn_axis_by_axis(top, h); });
  add("splitting with a sphere", [](Top<Real>& top, Real h) { turn_by_splitting(top, h); });
  add("splitting without a sine",
      [](Top<Real>& top, Real h) { turn_by_splitting_without_sine(top, h); });
}

const bool registered = [] {
  measure<float>("float");
  measure<double>("double");
  return true;
}();

}  // namespace
