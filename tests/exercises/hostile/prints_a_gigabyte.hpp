// earns: 1
// because: stopped after it had printed more than 1024 KB
#pragma once
#include <cstdio>
#include <string>

template <class Real>
Real doubled(Real number) {
  const std::string much(1 << 20, 'x');
  for (int n = 0; n < 1024; ++n) std::puts(much.c_str());
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
