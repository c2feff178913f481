// The weight on a spring, live: three orders of a step, its length, and where the weight starts.
#include <numbers>
#include <support/live.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/sine_cosine.hpp>

using namespace tumble;

namespace {

/// Implicit Euler takes both rates from the end of the step. For a spring that can be solved:
/// v' = v − h ω² (x + h v').
void implicit_step(Particled& weight, double frequency, double h) {
  const double square = frequency * frequency;
  weight.velocity = (weight.velocity - h * square * weight.position) / (1 + h * h * square);
  drift(weight, h);
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const int rule = live.choice("rule", 0, 3);
  const double h = live.knob("h", "s", 0.3, 0.01, 4.2);
  const double w = live.knob("w", "rad/s", 1, 0.5, 2);
  const double x = live.knob("x", "m", 1, -2, 2);
  const double v = live.knob("v", "m/s", 0, -2, 2);

  // Places are multiplied by ω, so that the exact path is a circle whatever ω is.
  std::vector<double>&time = live.column("time", "s"), &places = live.column("scaled place", "m/s"),
  &speeds = live.column("velocity", "m/s"), &energies = live.column("energy", "of E₀");
  std::vector<double>&circle_x = live.column("exact scaled place", "m/s"),
  &circle_v = live.column("exact velocity", "m/s"),
  &curve_x = live.column("curve scaled place", "m/s"),
  &curve_v = live.column("curve velocity", "m/s");

  Particled weight = make_particle(1.0, Vec3d(x, 0, 0), Vec3d(v, 0, 0));
  const double square = w * w, energy = v * v + square * x * x;
  const int steps = 240;
  for (int n = 0; n <= steps; ++n) {
    const double place = weight.position.x(), velocity = weight.velocity.x();
    time.push_back(n * h);
    places.push_back(w * place);
    speeds.push_back(velocity);
    energies.push_back(energy > 0 ? (velocity * velocity + square * place * place) / energy : 1);
    clear_force(weight);
    if (std::abs(place) < 1e100) add_force(weight, -square * weight.position);
    if (rule == 0)
      explicit_step(weight, h);
    else if (rule == 1)
      step(weight, h);
    else
      implicit_step(weight, w, h);
  }

  // The circle of the exact motion, and the ellipse Q = v² + ω²x² − h ω² x v that kick and drift
  // keeps, in the coordinates a = ω x + v, b = ω x − v: Q = (a² + b²)/2 − h ω (a² − b²)/4.
  const double Q = energy - h * square * x * v;
  const double along = std::sqrt(Q / (0.5 - h * w / 4)), across = std::sqrt(Q / (0.5 + h * w / 4));
  for (int n = 0; n <= 120; ++n) {
    const auto [sine, cosine] = sine_cosine(2 * std::numbers::pi * n / 120);
    circle_x.push_back(std::sqrt(energy) * cosine);
    circle_v.push_back(std::sqrt(energy) * sine);
    if (rule != 1 || h * w >= 2) continue;
    curve_x.push_back((along * cosine + across * sine) / 2);
    curve_v.push_back((along * cosine - across * sine) / 2);
  }
}
