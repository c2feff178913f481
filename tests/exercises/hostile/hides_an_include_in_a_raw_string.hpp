// earns: 0
// because: it doesn't compile
#pragma once
// clang-format off
inline const char* const hidden = R"("/*)";
#include "@ROOT@/solutions/01_force/doubled/doubled.hpp"
inline const char* const shown = R"(*/")";
