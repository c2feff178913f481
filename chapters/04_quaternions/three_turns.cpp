// One turn by a vector, against three turns about x, y and z: how far apart they end.
#include <algorithm>
#include <numbers>
#include <support/record.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

namespace {

//! [three_turns]
/// First about the last axis of `order`, then about the one before it, and so on.
Quaterniond three_turns(const Vec3d& v, const std::array<int, 3>& order) {
  Quaterniond q;
  for (const int axis : order) q = q * quaternion_about<double>(Vec3d::Unit(axis), v[axis]);
  return q;
}
//! [three_turns]

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Vec3d direction = Vec3d(1, 2, -2) / 3;

  support::Table table =
      notebook.table("three_turns", {"angle (rad)", "error (rad)", "predicted error (rad)"});
  std::printf("angle of the turn      error of the three   ratio   half of the cross products\n");
  double before = 0, last_ratio = 0;
  for (int halvings = 0; halvings <= 10; ++halvings) {
    const double angle = std::ldexp(1.0, -halvings);
    const Vec3d v = angle * direction;
    const double error = angle_between(three_turns(v, {0, 1, 2}), quaternion_of_rotation_vector(v));
    const double predicted = Vec3d(v.y() * v.z(), v.x() * v.z(), v.x() * v.y()).norm() / 2;
    table.row(angle, error, predicted);
    if (halvings > 0) last_ratio = before / error;
    std::printf("%13.6f rad   %14.3e rad   %7s   %14.3e rad\n", angle, error,
                halvings > 0 ? support::number("%.3f", last_ratio).c_str() : "", predicted);
    if (halvings == 0) notebook.value("error_1", support::number("%.2f rad", error));
    before = error;
  }
  notebook.value("ratio", support::number("%.3f", last_ratio));
  notebook.value("slope", support::number("%.2f", std::log2(last_ratio)));
  support::expect(std::abs(last_ratio - 4) < 0.01, "half the angle, a quarter of the error");

  std::printf("\nthe same three angles, summing to a turn of 1 rad, in every order:\n");
  std::array<int, 3> order = {0, 1, 2};
  std::vector<Quaterniond> ends;
  do {
    ends.push_back(three_turns(direction, order));
    const double error = angle_between(ends.back(), quaternion_of_rotation_vector(direction));
    std::printf("  %c first, then %c, then %c: %.3f rad from the one true turn\n", "xyz"[order[2]],
                "xyz"[order[1]], "xyz"[order[0]], error);
  } while (std::next_permutation(order.begin(), order.end()));
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      support::expect(angle_between(ends[i], ends[j]) > 0.1, "six orders end in six orientations");
}
