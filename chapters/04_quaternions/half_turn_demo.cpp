// A mistake, run on purpose: a quaternion from the trace of a matrix alone, near half a turn.
#include <numbers>
#include <support/record.hpp>
#include <tumble/rotation_matrix.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

namespace {

//! [by_trace]
Quaternionf by_trace(const Mat3f& R) {
  const float w = std::sqrt(1 + R.trace()) / 2;
  const Vec3f differences(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  return {.real = w, .imaginary = differences / (4 * w)};
}
//! [by_trace]

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::printf("short of half a turn    trace: norm, error (rad)   quaternion_of: error (rad)\n");
  for (const float missing : {1.0f, 1e-1f, 1e-2f, 1e-3f, 1e-4f}) {
    const Quaternionf q = quaternion_about(Vec3f(1, 2, 3), std::numbers::pi_v<float> - missing);
    const Mat3f matrix = matrix_of(q);
    const Quaternionf lossy = by_trace(matrix), kept = quaternion_of(matrix);
    const float lossy_error = angle_between(q, normalized(lossy)), error = angle_between(q, kept);
    if (std::isnan(norm(lossy)))
      std::printf("%16g rad   %16s, %-7s   %26.1e\n", missing, "NaN", "NaN", error);
    else
      std::printf("%16g rad   %16.4f, %.1e   %26.1e\n", missing, norm(lossy), lossy_error, error);
    support::expect(error < 1e-6f, "the largest column loses nothing");
    if (missing == 1e-3f) {
      notebook.value("norm", support::number("%.2f", norm(lossy)));
      support::expect(!(lossy_error < 1e-5f), "the trace loses digits near half a turn");
    }
  }
}
