#include <support/checks.hpp>
#include <tumble/midpoint.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE("Newton's method makes one more round after a small correction, and gives up after 20") {
  const auto rounds = [](std::vector<double> sizes) {
    std::size_t count = 0;
    const Vec3d found = newton<double>(Vec3d(1, 0, 0), [&](const Vec3d&) -> Vec3d {
      const double size = count < sizes.size() ? sizes[count] : sizes.back();
      ++count;
      return {0, size, 0};
    });
    CHECK(found.x() == 1);
    return count;
  };
  // Small is less than the root of epsilon, 1.5e-8, of the vector's own size.
  CHECK(rounds({0.5, 1e-3, 1e-9, 1e-18}) == 4);
  CHECK(rounds({0.5, 1e-3, 1e-7, 1e-18}) == 5);
  CHECK(rounds({0}) == 2);
  CHECK(rounds({1e4, 1e-5, 1e-18}) == 3);  // the vector is large by then
  CHECK(rounds({0.5}) == 20);
  int at_rest = 0;
  CHECK(newton<double>(Vec3d::Zero(), [&](const Vec3d& at) -> Vec3d {
          ++at_rest;
          return at;
        }) == Vec3d::Zero());
  CHECK(at_rest == 2);  // nothing to correct, where nothing is small beside the vector
  CHECK(newton<double>(Vec3d(1, 2, 3), [](const Vec3d& at) -> Vec3d {
          return Vec3d(4, 4, 4) - at;
        }) == Vec3d(4, 4, 4));
}

TEST_CASE("How a turn answers to a change of its vector is told to the eighth power of the angle") {
  for (const double size : {0.05, 0.2, 0.6}) {
    const Vec3d v = size / 7 * Vec3d(2, 3, 6);
    const Mat3<double> found = change_of_turn(v), across = cross_matrix(v);
    const Mat3<double> odd = (found - found.transpose()) / 2,
                       even = (found + found.transpose()) / 2 - Mat3<double>::Identity();
    // 1 - cos and angle - sin without cancellation, by their own series to the end.
    double cosine_part = 0, sine_part = 0, term = 0.5;
    for (int n = 2; std::abs(term) > 1e-20; n += 2) {
      cosine_part += term;
      sine_part += term / (n + 1);
      term *= -size * size / (n + 1) / (n + 2);
    }
    // What is left out first is angle^8/10! and angle^8/11!.
    const double left_out = std::pow(size, 8) / 3628800;
    CHECK((odd + cosine_part * across).norm() <=
          (left_out + 16 * unit_roundoff<double>)*across.norm());
    CHECK((even - sine_part * across * across).norm() <=
          (left_out / 11) * (across * across).norm() + 64 * unit_roundoff<double>);
  }
}
