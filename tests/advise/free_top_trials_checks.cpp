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
    CHECK(std::abs(inverse[0] - inverse[1]) == doctest::Approx(1 / 2.0 - 1 / 2.5));  // the closest
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

TEST_CASE(
    "Of many frames so many are compared that there are 4096 at most, and half of them at least") {
  for (const long count : {1L, 4096L, 4097L, 8191L, 8192L, 10'000'000L}) {
    CAPTURE(count);
    const long compared = count / frames_between_samples({.count = count});
    CHECK(compared <= 4096);
    CHECK(compared >= std::min(count, 2048L));
  }
}

TEST_CASE(
    "The candidates for a free top are all rungs that turn it rightly, by such steps as are asked "
    "for") {
  const Frames frames{.count = 6, .rate = 3};
  const auto named = [&](const FreeTopQuestion& question, const StepKinds& kinds) {
    std::vector<Candidate> candidates;
    append_free_top<double>(candidates, question, frames, kinds, 1);
    std::string names;
    for (const Candidate& candidate : candidates) {
      CAPTURE(candidate.method);
      CHECK(candidate.trials == trials);
      if (!candidate.takes_steps)  // 290 roundings and 65 for each of 5 radians
        CHECK(candidate.errors(1, trials - 1).angle <= 1000 * 0x1p-53);
      if (candidate.chooses_steps() && !candidate.is_given_angle) {
        const double least = 3 * 0x1p-52;  // rad/s: for each state a rounding
        CHECK(candidate.given(candidate.finest) >= least);
        CHECK(candidate.given(candidate.finest + 1) < least);
      }
      names += candidate.method + ", ";
    }
    return names;
  };
  std::string steady, tumbling, own;
  for (const TurningRung<double>& rung : turning_ladder<double>)
    (rung.claims.order == 0 ? steady : tumbling) += std::string(rung.name) + ", ";
  for (const FreeTopRung<double>& rung : free_top_rungs<double>)
    own += std::string(rung.name) + ", ";
  const FreeTopQuestion tumbles{{1, 2, 3}, {1, 2, 0.5}}, spins{{2, 2, 2}, {1, 2, 0.5}};
  CHECK(named(tumbles, {.even = true, .own = false}) == tumbling);
  CHECK(named(tumbles, {.even = false, .own = true}) == own);
  CHECK(named(tumbles, {}) == tumbling + own + "exact solution, ");
  CHECK(named(spins, {}) == steady + "exact solution, ");
}
