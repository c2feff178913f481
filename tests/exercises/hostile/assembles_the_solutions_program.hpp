// earns: 0
// because: it doesn't compile
#pragma once
// clang-format off
__asm(".section .rodata\n.inc" "bin \"@BUILT@/answers_double.o\"\n.text");
// clang-format on

template <class Real>
Real doubled(Real number) {
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
