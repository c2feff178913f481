// earns: 0
// because: it doesn't compile
#pragma once
// clang-format off
#define NOTHING
#include "@SECRET@"
// clang-format on

template <class Real>
Real doubled(Real number) {
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
