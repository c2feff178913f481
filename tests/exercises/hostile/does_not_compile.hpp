// earns: 0
// because: hpp:8: error:
#pragma once
// a plain slip

template <class Real>
Real doubled(Real number) {
  return 2 * nubmer;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
