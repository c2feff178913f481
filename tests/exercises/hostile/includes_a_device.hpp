// earns: 0
// because: an include names a header
#pragma once
#include "/dev/zero"

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
