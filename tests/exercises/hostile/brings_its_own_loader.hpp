// earns: 3
// because: holds assembly
#pragma once
__asm(".section .interp,\"a\"\n.string \"/bin/sh\"\n.text");

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
