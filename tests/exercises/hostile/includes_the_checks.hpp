// earns: 0
// because: it doesn't compile
#pragma once
#define EXERCISE_CHECK(sentence) inline void check()
#include "@ROOT@/exercises/01_force/doubled/checks.cpp"

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
