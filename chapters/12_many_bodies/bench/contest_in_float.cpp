#include <course/bench/contenders.hpp>

template void tumble::course::bench::Contest::in_precision<float>();
