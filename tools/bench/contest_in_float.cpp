#include <support/bench/contenders.hpp>

template void tumble::support::bench::Contest::in_precision<float>();
template tumble::support::bench::Pace tumble::support::bench::Contest::pace<float>() const;
