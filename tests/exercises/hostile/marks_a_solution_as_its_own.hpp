// earns: 0
// because: what stands here
#pragma once
# 1 "@ROOT@/solutions/01_force/doubled/doubled.hpp" 1 3
#error what stands here

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
