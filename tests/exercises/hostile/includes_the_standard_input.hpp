// earns: 0
// because: it doesn't compile
#pragma once
#include "/dev/stdin"
#include "/proc/self/fd/0"

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
