// A top between springs, live: which steps let a tilt grow, by how far its nutation turns in one.
#include <array>
#include <numbers>
#include <support/live.hpp>
#include <tumble/sine_cosine.hpp>

using namespace tumble;

namespace {

/// A tilt across the axis, two numbers, and what a step adds to it, two more.
using Tilt = std::array<double, 4>;

/// One step in units of its length: the springs kick by κ of the tilt in each direction and the
/// dampers by γ of the speed; then the speed circles by the angle θ of the nutation.
struct Step {
  double angle, first, second, damping;
  void kick(Tilt& tilt) const {
    tilt[2] -= first * tilt[0] + damping * tilt[2];
    tilt[3] -= second * tilt[1] + damping * tilt[3];
  }
  /// A part of the drift that follows.
  void drift(Tilt& tilt, double part = 1) const {
    const auto [sine, cosine] = sine_cosine(part * angle);
    const double along = angle == 0 ? part : sine / angle,
                 aside = angle == 0 ? 0 : (1 - cosine) / angle;
    const double u = tilt[2], v = tilt[3];
    tilt = {tilt[0] + along * u - aside * v, tilt[1] + aside * u + along * v, cosine * u - sine * v,
            sine * u + cosine * v};
  }
  /// True if 4096 steps make some tilt a hundred thousand times as large: squared twelve times.
  bool grows() const {
    std::array<Tilt, 4> columns{};
    for (std::size_t i = 0; i < 4; ++i) {
      columns[i][i] = 1;
      kick(columns[i]);
      drift(columns[i]);
    }
    double most = 1;
    for (int n = 0; n < 12 && most < 1e100; ++n) {
      std::array<Tilt, 4> square{};
      most = 0;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
          for (std::size_t k = 0; k < 4; ++k) square[i][j] += columns[i][k] * columns[k][j];
          most = std::max(most, std::abs(square[i][j]));
        }
      columns = square;
    }
    return most > 1e5;
  }
};

}  // namespace

void tumble::support::run_live(Live& live) {
  const double angle = live.knob("angle", "rad", 3.98, 0, 13);
  const double kappa = live.knob("kappa", "", 3.12, 0.02, 4.2);
  const double other = live.knob("other", "", 1, 0.1, 1);
  const double damping = live.knob("damping", "", 0, 0, 1);

  // Rows of the map: from where to where a tilt grows, with a gap after each stretch.
  std::vector<double>&band_angle = live.column("band angle", "rad"),
  &band_kappa = live.column("band kappa", "");
  constexpr int rows = 42, columns = 260;
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  for (int row = 0; row < rows; ++row) {
    const double k = 4.2 * (row + 0.5) / rows;
    bool was = false;
    for (int column = 0; column <= columns; ++column) {
      const double at = 13.0 * column / columns;
      const bool now = column < columns && Step{at, k, other * k, damping}.grows();
      if (now == was) continue;
      band_angle.push_back(at);
      band_kappa.push_back(k);
      if (was) band_angle.push_back(nowhere), band_kappa.push_back(nowhere);
      was = now;
    }
  }
  std::vector<double>&bound_angle = live.column("bound angle", "rad"),
  &bound_kappa = live.column("bound kappa", "");
  for (int n = 0; n < 120; ++n) {
    const double at = std::numbers::pi * n / 120;
    bound_angle.push_back(at);
    const auto [sine, cosine] = sine_cosine(at / 2);
    const double yields = n == 0 ? 1 : sine / cosine / (at / 2);  // see yielding()
    bound_kappa.push_back(std::max(0.0, 4 / yields - 2 * damping));
  }

  // The tip of the axis, from a tilt of 1, until it is a thousand times as far.
  std::vector<double>&x = live.column("x", ""), &y = live.column("y", ""),
  &kick_x = live.column("kick x", ""), &kick_y = live.column("kick y", "");
  const Step step{angle, kappa, other * kappa, damping};
  Tilt tilt{1, 0, 0, 0};
  for (int n = 0; n < 60 && std::hypot(tilt[0], tilt[1]) < 1000; ++n) {
    kick_x.push_back(tilt[0]);
    kick_y.push_back(tilt[1]);
    step.kick(tilt);
    for (int part = 0; part < 24; ++part) {
      Tilt between = tilt;
      step.drift(between, part / 24.0);
      x.push_back(between[0]);
      y.push_back(between[1]);
    }
    step.drift(tilt);
  }
  live.column("grows", "").push_back(step.grows() ? 1 : 0);
}
