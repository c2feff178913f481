// earns: 0
// because: what stands here
#pragma once
#line 1 "@SECRET@"
#error what stands here

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
