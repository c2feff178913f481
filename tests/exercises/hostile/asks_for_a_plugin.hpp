// earns: 3
// because: gives the compiler orders
#pragma once
#pragma GCC optimize("-fplugin=@ROOT@/plugin.so")

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
