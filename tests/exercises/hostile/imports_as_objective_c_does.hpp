// earns: 0
// because: Permission denied
#pragma once
#import "@ROOT@/solutions/01_force/doubled/doubled.hpp"
