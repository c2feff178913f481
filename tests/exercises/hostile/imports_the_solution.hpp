// earns: 0
// because: it doesn't compile
#pragma once
import "@ROOT@/solutions/01_force/doubled/doubled.hpp";
