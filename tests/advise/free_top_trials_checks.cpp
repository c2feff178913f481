#include <free_top_rungs.hpp>
#include <support/checks.hpp>

using namespace tumble;
using namespace tumble::advise;

TEST_CASE("A free top has the moments and the spin of the question in right-handed axes") {
  const std::array<double, 3> moments = {1, 2, 2.5};
  const Vec3d spin(0.5, 2, -1);
  std::array<std::size_t, 3> order = {0, 1, 2};
  do {
    const auto in_order = [&](const auto& three) {
      return Vec3d(three[order[0]], three[order[1]], three[order[2]]);
    };
    const Vec3d I = in_order(moments), w = in_order(std::array{spin.x(), spin.y(), spin.z()});
    const Top<double> top = top_of<double>({I.x(), I.y(), I.z()}, w);
    const Vec3d inverse = top.inverse_moments, L = top.angular_momentum_body;
    // w . (L x I L) is the same in all right-handed axes, and the opposite in the others.
    const auto handed = [](const Vec3d& of_moments, const Vec3d& spin_of_it) {
      const Vec3d momentum = of_moments.cwiseProduct(spin_of_it);
      return spin_of_it.dot(momentum.cross(of_moments.cwiseProduct(momentum)));
    };
    const Vec3d built = inverse.cwiseInverse();
    CHECK(handed(built, L.cwiseProduct(inverse)) == doctest::Approx(handed(I, w)));
    CHECK(L.cwiseAbs2().dot(inverse) == doctest::Approx(w.cwiseAbs2().dot(I)));
    CHECK(L.norm() == doctest::Approx(w.cwiseProduct(I).norm()));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("The questions like the one asked differ from it and from each other by a hundredth") {
  const FreeTopQuestion question{{1, 2, 2.5}, {300, 400, 1200}};
  std::vector<Top<double>> tops;
  for (int trial = 0; trial < trials; ++trial) tops.push_back(start_of<double>(question, trial));
  for (int a = 0; a < trials; ++a)
    for (int b = 0; b < a; ++b) {
      const auto& one = tops[std::size_t(a)];
      const auto& other = tops[std::size_t(b)];
      const double apart = (angular_velocity_body(one) - angular_velocity_body(other)).norm();
      CHECK(apart > 0);
      CHECK(apart <= doctest::Approx(1300 * 0.01 * (b == 0 ? 1 : 2)));
      if (b == 0) CHECK(apart == doctest::Approx(1300 * 0.01));
      CHECK(angle_between(one.orientation, other.orientation) > 0.01);
    }
}

TEST_CASE("An angular momentum of the right length in a wrong direction is an error") {
  const Top<double> top = top_of<double>({1, 2, 2.5}, Vec3d(0.5, 2, -1));
  Top<double> turned = top;
  turned.orientation =
      quaternion_of_rotation_vector<double>(0.1 * angular_momentum_world(top).unitOrthogonal());
  const Errors errors = errors_at(turned, support::exactly(top));
  CHECK(errors.angle == doctest::Approx(0.1));
  CHECK(errors.momentum == doctest::Approx(2 * std::sin(0.05)));
  CHECK(errors.energy <= 4 * 0x1p-53);
}
