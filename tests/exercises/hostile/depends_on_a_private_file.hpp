// earns: 0
// because: Permission denied
#pragma once
#pragma GCC dependency "@SECRET@" what stands there

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
