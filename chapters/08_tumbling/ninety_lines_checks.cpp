// The program of ninety lines against the library, of which it includes nothing.
#include <cstdio>
#include <support/checks.hpp>
#include <support/rules.hpp>

using namespace tumble;
namespace ninety_lines {
#define main fly
#include "ninety_lines_demo.cpp"  // NOLINT(bugprone-suspicious-include)
#undef main

Topd top_of(const Body& b) {
  return {.orientation = {.real = b.w, .imaginary = Vec3d(b.q.data())},
          .angular_momentum_body = Vec3d(b.angular_momentum.data()),
          .inverse_moments = Vec3d(b.moments.data()).cwiseInverse()};
}

/// From one flip to the next, s; 0 if a minute has no two.
double between_flips(double step) {
  Body body = thrown_t_handle();
  const Vector& L = body.angular_momentum;
  for (double n = 0, last = 0, flip = 0; n * step < 60; ++n) {
    const double before = L[1];
    drift(body, step);
    if (before * L[1] < 0) last = std::exchange(flip, step * (n + before / (before - L[1])));
    if (last > 0) return flip - last;
  }
  return 0;
}

TEST_CASE("In ninety lines each kick and drift of the flight is chapter 8's, to rounding") {
  Body body = thrown_t_handle();
  const Vec3d moments(body.moments.data());
  const double h = 1.0 / 60, size = top_of(body).angular_momentum_body.norm();
  // Each side rounds some 16 times in a kick, and in each of five turns. A turn's angle hangs on L:
  // that magnifies what was rounded before by 1 + h |L|/I at most.
  const double growth = std::pow(1 + h * size / moments[0], 5);
  const double bound = 6 * 32 * growth * support::unit_roundoff<double>;
  CHECK((moments - support::t_handle().inertia.diagonal()).norm() <= bound * moments[0]);
  for (int n = 0; n < 12 * 60; ++n) {
    Body kicked = body;
    Topd turned = top_of(body), pushed = turned;
    pushed.torque = {3 * size, -2 * size, 5 * size};
    kick(pushed, h), turn_axis_by_axis(turned, h), drift(body, h);
    kick(kicked, {0, 0, 2 * body.mass}, {3 * size, -2 * size, 5 * size}, h);
    CHECK(angle_between(top_of(body).orientation, turned.orientation) <= bound);
    for (const auto& [own, other] : {std::pair(top_of(body), turned), {top_of(kicked), pushed}})
      CHECK((own.angular_momentum_body - other.angular_momentum_body).norm() <= bound * size);
    CHECK(std::abs(kicked.velocity[2] - body.velocity[2] - 2 * h) <= 60 * bound);
  }
}

TEST_CASE("In ninety lines the handle flips when it must, to the second order") {
  const exact::FreeTop<long double> truth(support::exactly(top_of(thrown_t_handle())));
  // Of second order: off by 4/3 of what half the step changes, and by (h omega)^2 of that besides.
  const double h = 1.0 / 60, found = between_flips(h), off = 4 * (found - between_flips(h / 2)) / 3;
  CHECK(std::abs(found - off - double(truth.period()) / 2) <= std::pow(10 * h, 2) * std::abs(off));
}
}  // namespace ninety_lines
