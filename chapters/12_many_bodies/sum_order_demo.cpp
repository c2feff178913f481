// Three numbers added in another order: another sum.
#include <support/record.hpp>
#include <tumble/real.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [order]
  const Vec3d v(1, 1e-8, 1e-8);
  const double left_first = (v.x() * v.x() + v.y() * v.y()) + v.z() * v.z();
  const double right_first = v.x() * v.x() + (v.y() * v.y() + v.z() * v.z());
  //! [order]
  std::printf("(x^2 + y^2) + z^2 = %.17g\n", left_first);
  std::printf("x^2 + (y^2 + z^2) = %.17g\n", right_first);
  std::printf("what Eigen sums   = %.17g\n", v.squaredNorm());
  support::expect(left_first != right_first, "the order of a sum changes its rounding");
  support::expect(v.squaredNorm() == right_first, "Eigen sums as it does for a pack");
}
