// earns: 0
// because: it doesn't compile
#pragma once
// clang-format off
__asm(".rept 100000000\n.quad 1, 2, 3, 4, 5, 6, 7, 8\n.endr");
// clang-format on

template <class Real>
Real doubled(Real number) {
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
