// earns: 0
// because: it doesn't compile
#include __FILE__

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
