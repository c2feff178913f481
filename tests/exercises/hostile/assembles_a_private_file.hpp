// earns: 0
// because: it doesn't compile
#pragma once
#include <stdexcept>

// clang-format off
__asm(".section .rodata\nprivate_file: .inc" "bin \"@SECRET@\"\n.byte 0\n.text");
// clang-format on
extern "C" const char private_file[];

template <class Real>
Real doubled(Real number) {
  throw std::runtime_error(private_file);
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
