// earns: 0
// because: the program
#pragma once
#include <unistd.h>
extern "C" {
static void nothing() {}
[[gnu::used]] static void (*chosen_by_us())() {
  char word[] = "3";
  char* words[] = {word, nullptr};
  execv("@BUILT@/worker_double", words);
  _exit(0);
  return nothing;
}
void chosen() __attribute__((ifunc("chosen_by_us")));
}
[[gnu::used]] static void (*const keeps_it)() = chosen;

template <class Real>
Real doubled(Real number) {
  return 2 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
