// A turn in one step, live: how far each rule turns, and where the nose of a tilted body goes when
// the turn is multiplied on either side.
#include <numbers>
#include <support/live.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;

namespace {

/// Turns about the world's z by `angle` rad in one step.
Quaterniond turned(const Quaterniond& from, int rule, int side, double angle) {
  const Vec3d omega(0, 0, 1);
  if (side == 0)
    return rule == 0 ? turn_first_order(from, omega, angle) : turn_exponential(from, omega, angle);
  // The mistake: the same ω, which is one in world axes, on the body's side.
  return rule == 0 ? turn_first_order_body(from, omega, angle)
                   : turn_exponential_body(from, omega, angle);
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const double asked = live.knob("asked", "rad", 1, 0.01, 6.28);
  const int rule = live.choice("rule", 0, 2);
  const int side = live.choice("side", 0, 2);

  // One turn from no turn at all: the cosine and sine of half of what it turned.
  std::vector<double>&angles = live.column("curve asked", "rad"),
  &cosines = live.column("curve cosine", ""), &sines = live.column("curve sine", "");
  for (int n = 0; n <= 126; ++n) {
    const Quaterniond q = turned({}, 0, 0, 0.05 * n);
    angles.push_back(0.05 * n);
    cosines.push_back(q.real);
    sines.push_back(q.imaginary.z());
  }
  const Quaterniond one = turned({}, rule, 0, asked);
  live.column("cosine", "").push_back(one.real);
  live.column("sine", "").push_back(one.imaginary.z());

  // A body with its nose raised by 0.6 rad, as many steps as make a turn, and at least six.
  std::vector<double>&x = live.column("nose x", ""), &y = live.column("nose y", ""),
  &z = live.column("nose z", "");
  Quaterniond q = quaternion_about(Vec3d(0, 1, 0), -0.6);
  const int steps = std::max(6, static_cast<int>(std::ceil(2 * std::numbers::pi / asked)));
  for (int n = 0; n <= steps; ++n) {
    const Vec3d nose = rotate(q, Vec3d(1, 0, 0));
    x.push_back(nose.x());
    y.push_back(nose.y());
    z.push_back(nose.z());
    q = turned(q, rule, side, asked);
  }
}
