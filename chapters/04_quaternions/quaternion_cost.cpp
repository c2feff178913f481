#include <benchmark/benchmark.h>

#include <tumble/rotation_matrix.hpp>
#include <tumble/rotation_vector.hpp>
#include <vector>

using namespace tumble;

namespace {

/// Applies `function` to each of some quaternions and vectors that fit into the nearest cache.
template <class Real, class Function>
void each(benchmark::State& state, const Function& function) {
  struct Item {
    Quaternion<Real> q;
    Vec3<Real> v;
  };
  const Vec3<Real> turn(Real(0.1), Real(0.2), Real(-0.3));
  std::vector<Item> items(250, {quaternion_of_rotation_vector(turn), turn});
  for (auto _ : state) {
    for (Item& item : items) function(item.q, item.v);
    benchmark::DoNotOptimize(items.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(items.size()));
}

template <class Real>
using Q = Quaternion<Real>;
template <class Real>
using V = Vec3<Real>;

template <class Real>
void product(benchmark::State& state) {
  each<Real>(state, [](Q<Real>& q, V<Real>&) { q = q * q; });
}
template <class Real>
void rotation(benchmark::State& state) {
  each<Real>(state, [](Q<Real>& q, V<Real>& v) { v = rotate(q, v); });
}
template <class Real>
void sandwich(benchmark::State& state) {
  each<Real>(state, [](Q<Real>& q, V<Real>& v) { v = (q * pure(v) * conjugate(q)).imaginary; });
}
template <class Real>
void normalisation(benchmark::State& state) {
  each<Real>(state, [](Q<Real>& q, V<Real>&) { q = normalized(q); });
}
template <class Real>
void exponential(benchmark::State& state) {
  each<Real>(state, [](Q<Real>& q, V<Real>& v) { q = quaternion_of_rotation_vector(v); });
}
template <class Real>
void our_sine(benchmark::State& state) {
  each<Real>(state, [](Q<Real>& q, V<Real>& v) {
    const SineCosine<Real> both = sine_cosine(v.x());
    q.real = both.cosine;
    q.imaginary.x() = both.sine;
  });
}
template <class Real>
void library_sine(benchmark::State& state) {
  each<Real>(state, [](Q<Real>& q, V<Real>& v) {
    q.real = std::cos(v.x());
    q.imaginary.x() = std::sin(v.x());
  });
}

}  // namespace

BENCHMARK(product<float>)->Name("product of two quaternions, float");
BENCHMARK(product<double>)->Name("product of two quaternions, double");
BENCHMARK(rotation<float>)->Name("rotate a vector, float");
BENCHMARK(rotation<double>)->Name("rotate a vector, double");
BENCHMARK(sandwich<float>)->Name("rotate a vector, as two products, float");
BENCHMARK(sandwich<double>)->Name("rotate a vector, as two products, double");
BENCHMARK(normalisation<float>)->Name("normalise, float");
BENCHMARK(normalisation<double>)->Name("normalise, double");
BENCHMARK(exponential<float>)->Name("the exponential of a vector, float");
BENCHMARK(exponential<double>)->Name("the exponential of a vector, double");
BENCHMARK(our_sine<float>)->Name("sine_cosine, float");
BENCHMARK(our_sine<double>)->Name("sine_cosine, double");
BENCHMARK(library_sine<float>)->Name("std::sin and std::cos, float");
BENCHMARK(library_sine<double>)->Name("std::sin and std::cos, double");
