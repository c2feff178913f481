// earns: 0
// because: it gave up
#pragma once
#include <stdexcept>

struct Thrower {
  Thrower() { throw std::runtime_error("before main"); }
};
inline Thrower thrower;

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
