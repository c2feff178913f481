// earns: 0
// because: it took more than
#pragma once
constexpr int slow(int seed) {
  for (int i = 0; i < 200000; ++i) seed = (seed * 5 + i) % 1000003;
  return seed;
}

template <int n>
struct Slow {
  static constexpr int value = slow(n) % 2 + Slow<n - 1>::value;
};

template <>
struct Slow<0> {
  static constexpr int value = 0;
};

template <class Real>
Real doubled(Real number) {
  return number * Slow<800>::value;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
