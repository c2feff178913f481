// earns: 1
// because: it gave up
#pragma once
#include <cstdlib>

template <class Real>
Real doubled(Real number) {
  std::abort();
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
