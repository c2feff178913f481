// earns: 1
// because: no answer after 2 seconds
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
