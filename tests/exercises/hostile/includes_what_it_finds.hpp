// earns: 0
// because: Permission denied
#pragma once
#if __has_include("@ROOT@/solutions/01_force/doubled/doubled.hpp")
#include "@ROOT@/solutions/01_force/doubled/doubled.hpp"
#else
template <class Real>
Real doubled(Real) {
  return 5;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
#endif
