#include <course/beside_one_by_one.hpp>

template void tumble::course::compare_with_one_by_one<double, 2>(std::uint64_t, int, int);
