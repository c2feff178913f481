// earns: 0
// because: Permission denied
#pragma once
#incl\
ude "@ROOT@/solutions/01_force/doubled/doubled.hpp"
