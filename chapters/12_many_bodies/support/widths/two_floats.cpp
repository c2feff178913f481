#include <support/beside_one_by_one.hpp>

template void tumble::support::compare_with_one_by_one<float, 2>(std::uint64_t, int, int);
