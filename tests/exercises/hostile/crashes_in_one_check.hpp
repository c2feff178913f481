// earns: 1
// because: it read or wrote where nothing is
#pragma once

template <class Real>
Real doubled(Real number) {
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
