// earns: 1
// because: something that is no std::exception
#pragma once

template <class Real>
Real doubled(Real number) {
  throw 4;
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
