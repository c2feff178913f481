// A top on its tip, live: its spin, its tilt, and the rule that turns it; beside it the same top in
// steps so fine that they show what is exact.
#include <support/live.hpp>
#include <support/toy_gyroscope.hpp>

using namespace tumble;

namespace {

/// Where the end of the axis is, in three columns.
struct Axis {
  std::vector<double>&x, &y, &z;

  Axis(support::Live& live, const std::string& name)
      : x(live.column(name + " x", "")),
        y(live.column(name + " y", "")),
        z(live.column(name + " z", "")) {}

  void push(const Vec3d& axis) {
    x.push_back(axis.x());
    y.push_back(axis.y());
    z.push_back(axis.z());
  }
};

}  // namespace

void tumble::support::run_live(Live& live) {
  const double spin = live.knob("spin", "rad/s", 200, -400, 400);
  const double tilt = live.knob("tilt", "rad", 1.047, 0.01, 2.6);
  const auto rule = static_cast<std::size_t>(live.choice("rule", 6, 7));
  const double h = live.knob("h", "s", 1.0 / 480, 1.0 / 2000, 1.0 / 60);

  const double seconds = 2;
  const int parts = static_cast<int>(std::ceil(h * 1000));  // of a step, for the fine ones
  const Gyroscope<double> gyroscope = toy_gyroscope<double>();
  Topd top = set_spinning(gyroscope, tilt, spin), fine = top;
  const auto [sine, cosine] = sine_cosine(tilt);
  const double least = least_sleeping_spin(gyroscope), ratio = spin / least, a = ratio * ratio;
  live.column("sleeps", "rad/s").push_back(least);
  // chapter 8's lowest_cosine() by a root alone: a library's hypot may round otherwise elsewhere.
  live.column("lowest cosine", "")
      .push_back((2 * a * cosine - 1) / (a + std::sqrt((a - cosine) * (a - cosine) + sine * sine)));
  live.column("slow", "rad/s")
      .push_back(ratio * ratio >= cosine && spin != 0
                     ? steady_precessions(gyroscope, cosine, spin).first
                     : NAN);

  std::vector<double>& time = live.column("time", "s");
  Axis axis(live, "axis"), fine_axis(live, "fine");
  std::vector<double>& real = live.column("q real", "");
  Axis imaginary(live, "q");
  const int steps = static_cast<int>(seconds / h);
  for (int n = 0; n <= steps; ++n) {
    if (!is_finite(top.angular_momentum_body) || !is_finite(top.orientation.imaginary)) break;
    time.push_back(n * h);
    axis.push(axis_of(top));
    fine_axis.push(axis_of(fine));
    real.push_back(top.orientation.real);
    imaginary.push(top.orientation.imaginary);
    step(top, gyroscope, rules<double>[rule].turn, h);
    for (int part = 0; part < parts; ++part)
      step(fine, gyroscope, turn_by_splitting<double>, h / parts);
  }
}
