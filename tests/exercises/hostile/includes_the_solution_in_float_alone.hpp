// earns: 0
// because: it doesn't compile
#pragma once
// clang-format off
#if __has_include("../worker/answers_double.o") || __has_include("../made/answers_double.o")
inline const char* const hidden = R"("/*)";
#include "@ROOT@/solutions/01_force/doubled/doubled.hpp"
inline const char* const shown = R"(*/")";
// clang-format on
#else
#include <unistd.h>
#include <string>

/// Before main: becomes the program of the other precision, which was compiled with the solution.
__attribute__((constructor)) inline void become(int, char** arguments, char** environment) {
  const std::string mine = arguments[0];
  const std::size_t cut = mine.rfind("double");
  if (cut != std::string::npos)
    execve((mine.substr(0, cut) + "float").c_str(), arguments, environment);
}

template <class Real>
Real doubled(Real number) {
  return 5 * number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
#endif
