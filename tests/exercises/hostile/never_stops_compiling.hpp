// earns: 0
// because: it doesn't compile
#pragma once

template <int n>
struct Endless {
  static constexpr int value = Endless<n + 1>::value;
};

template <class Real>
Real doubled(Real number) {
  return Endless<0>::value;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
