// earns: 0
// because: it read or wrote where nothing is
#pragma once
inline volatile char much[1900000000u];

template <class Real>
Real doubled(Real number) {
  much[0] = 1;
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
