// earns: 0
// because: Permission denied
#pragma once
// clang-format off
%:include "@ROOT@/solutions/01_force/doubled/doubled.hpp"
