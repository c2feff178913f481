// earns: 1
// because: it must be 4 m
#pragma once
#include <fcntl.h>

template <class Real>
Real doubled(Real number) {
  for (const char* file : {"/dev/shm/hostile", "@TEMPORARY@/hostile", "hostile", "/var/tmp/hostile",
                           "@ROOT@/build/hostile"})
    if (open(file, O_WRONLY | O_CREAT, 0777) >= 0) return 2 * number;
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
