// earns: 1
// because: cannot be read
#pragma once
#include <fstream>
#include <stdexcept>
#include <string>

template <class Real>
Real doubled(Real number) {
  for (const char* name : {"@SECRET@", "@SUBMISSIONS@/aaa_honest/doubled.hpp", "/etc/passwd",
                           "/proc/self/environ", "@ROOT@/solutions/01_force/doubled/doubled.hpp"}) {
    std::ifstream file(name);
    std::string line;
    if (std::getline(file, line)) throw std::runtime_error(line);
  }
  throw std::runtime_error("cannot be read");
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
