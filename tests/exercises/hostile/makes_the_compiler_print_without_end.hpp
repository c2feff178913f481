// earns: 0
// because: it printed more than
#if __INCLUDE_LEVEL__ < 100
#warning \
    "Once more, and then twice more of each of those, and then twice more of each of those, until the disk is full."
#include __FILE__
#include __FILE__
#endif

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
