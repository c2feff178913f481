// earns: 0
// because: it doesn't compile
#pragma once
extern "C" [[gnu::used]] inline int serve_in_its_place() __asm("main");
extern "C" inline int serve_in_its_place() {
  return 0;
}

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
