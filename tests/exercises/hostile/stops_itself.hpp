// earns: 1
// because: it must be 4 m
#pragma once
#include <signal.h>

template <class Real>
Real doubled(Real number) {
  raise(SIGSTOP);
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
