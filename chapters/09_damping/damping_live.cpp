// Four formulas that are called damping, live: what a step leaves of a speed, and what follows.
#include <support/damping_forms.hpp>
#include <support/live.hpp>
#include <tumble/damping.hpp>

using namespace tumble;

void tumble::support::run_live(Live& live) {
  const int form = live.choice("form", 1, 4);
  const double rate = live.knob("rate", "1/s", 2, 0.1, 50);
  const double h = live.knob("h", "s", 0.4, 1.0 / 240, 1);

  // "0.99 in every step" is what somebody tuned at 60 steps a second to the same rate.
  const double exact = fraction_kept(rate, h), tuned = fraction_kept(rate, 1.0 / 60);
  const double fraction = form == 0   ? exact
                          : form == 1 ? linear_form(rate, h)
                          : form == 2 ? fractional_form(rate, h)
                                      : tuned;
  live.column("fraction", "").push_back(fraction);
  live.column("exact fraction", "").push_back(exact);

  std::vector<double>&kh = live.column("k h", ""), &exponential = live.column("exponential", ""),
  &linear = live.column("linear", ""), &fractional = live.column("fractional", "");
  for (int n = 0; n <= 60; ++n) {
    kh.push_back(0.05 * n);
    exponential.push_back(fraction_kept(kh.back(), 1.0));
    linear.push_back(linear_form(kh.back(), 1.0));
    fractional.push_back(fractional_form(kh.back(), 1.0));
  }

  // Four times 1/k, or ten steps where those are longer.
  std::vector<double>&time = live.column("time", "s"), &speeds = live.column("speed", "m/s"),
  &exact_time = live.column("exact time", "s"), &exact_speeds = live.column("exact speed", "m/s");
  Particled puck = make_particle(1.0, Vec3d::Zero(), Vec3d(1, 0, 0));
  const int steps = std::max(10, static_cast<int>(4 / rate / h));
  for (int n = 0; n <= steps; ++n) {
    time.push_back(n * h);
    speeds.push_back(puck.velocity.x());
    damp(puck, fraction);
  }
  for (int n = 0; n <= 100; ++n) {
    exact_time.push_back(0.01 * n * steps * h);
    exact_speeds.push_back(fraction_kept(rate, exact_time.back()));
  }
}
