// What four numbers that are no orientation get: a sentence, before anything turns.
#include <support/record.hpp>
#include <tumble/rotation_matrix.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

namespace {

template <class Action>
bool refused(const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    std::printf("%s\n", error.what());
    return true;
  }
  return false;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  using Limits = std::numeric_limits<double>;
  int count = 0;
  const Vec3d none = Vec3d::Zero();
  for (const Quaterniond& q : {Quaterniond{0, none}, Quaterniond{Limits::quiet_NaN(), none},
                               Quaterniond{1, Vec3d(1, 0, 0)}})
    count += refused([&] { checked_orientation(q, "orientation of the book"); });
  count += refused([] { quaternion_about(Vec3d(0, 0, 0), 1.0); });
  count += refused([] { quaternion_about(Vec3d(0, 0, 1), 1e7); });
  count += refused([] { quaternion_of<double>(Vec3d(1, 1, -1).asDiagonal(), "camera"); });
  support::expect(count == 6, "each of the six is refused");
}
