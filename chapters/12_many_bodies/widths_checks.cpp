#include <support/beside_one_by_one.hpp>

using namespace tumble;
using namespace tumble::support;

#ifdef TUMBLE_COMPILED_RANDOM_WORLDS
// Each kind of world is compiled in a file of its own, see support/widths.
extern template void support::compare_with_one_by_one<float, 2>(std::uint64_t, int, int);
extern template void support::compare_with_one_by_one<float, 8>(std::uint64_t, int, int);
extern template void support::compare_with_one_by_one<double, 2>(std::uint64_t, int, int);
extern template void support::compare_with_one_by_one<double, 4>(std::uint64_t, int, int);
#endif

TEST_CASE_TEMPLATE("The width of the packs changes no bit", Real, EVERY_PRECISION) {
  compare_with_one_by_one<Real, 2>(1001, 40, 1);
  compare_with_one_by_one<Real, 32 / sizeof(Real)>(1041, 40, 1);
}
