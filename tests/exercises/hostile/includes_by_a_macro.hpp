// earns: 0
// because: it doesn't compile
#pragma once
// clang-format off
#define SOLUTION "@ROOT@/solutions/01_force/doubled/doubled.hpp"
# /* hidden */ include SOLUTION
// clang-format on

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
