// earns: 0
// because: doesn't compile
#pragma once
#include <tumble/world.hpp>

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
