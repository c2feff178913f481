// earns: 1
// because: bad_alloc
#pragma once
#include <vector>

template <class Real>
Real doubled(Real number) {
  static std::vector<double*> all;
  for (;;) all.push_back(new double[1 << 22]);
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
