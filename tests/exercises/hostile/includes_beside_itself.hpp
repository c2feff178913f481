// earns: 0
// because: No such file or directory
#pragma once
#include "../../graded-classmate/made/answers_double"
#include "answers_double.cpp"

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
