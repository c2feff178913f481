// earns: 0
// because: the program
#pragma once
extern "C" [[gnu::used]] int __libc_start_main(int (*)(int, char**, char**), int, char**,
                                               void (*)(), void (*)(), void (*)(), void*) {
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
