// earns: 0
// because: Permission denied
#pragma once
#include_next "@ROOT@/solutions/01_force/doubled/doubled.hpp"
