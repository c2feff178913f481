// earns: 0
// because: it doesn't compile
#pragma once
inline volatile char much[100000000] = {1};

template <class Real>
Real doubled(Real number) {
  much[0] = 1;
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
