// Two turns in either order, live; and a quaternion that needs two whole turns to come back.
#include <numbers>
#include <support/live.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

namespace {

constexpr double degree = std::numbers::pi / 180;

Quaterniond about_x(double angle) {
  return quaternion_about(Vec3d(1, 0, 0), angle * degree);
}
Quaterniond about_z(double angle) {
  return quaternion_about(Vec3d(0, 0, 1), angle * degree);
}

void push(support::Live& live, const std::string& name, const Quaterniond& q) {
  live.column(name, "").assign({q.real, q.imaginary.x(), q.imaginary.y(), q.imaginary.z()});
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const double first = live.knob("first", "°", 90, 0, 720);
  const double second = live.knob("second", "°", 90, 0, 720);
  const int sign = live.choice("sign", 0, 2);

  // A turn that comes later in world axes stands on the left.
  const Quaterniond x = about_x(first), z = about_z(second);
  const Quaterniond q = sign == 0 ? x : -x;
  push(live, "one", q);
  push(live, "x then z", z * q);
  push(live, "z then x", q * z);
  push(live, "between", conjugate(z * q) * (q * z));
  // Where q takes a point beside its axis.
  const Vec3d there = rotate(q, Vec3d(0, 1, 0));
  live.column("point", "").assign({there.x(), there.y(), there.z()});

  // The components of the first turn, up to two whole ones.
  std::vector<double>&angles = live.column("angle", "°"), &cosines = live.column("real", ""),
  &sines = live.column("along", "");
  for (int n = 0; n <= 144; ++n) {
    const Quaterniond turn = about_x(5.0 * n);
    angles.push_back(5.0 * n);
    cosines.push_back(turn.real);
    sines.push_back(turn.imaginary.x());
  }
  // Both turns made smaller together: how far apart the two orders end.
  std::vector<double>&parts = live.column("part", ""), &reals = live.column("apart real", ""),
  &sizes = live.column("apart size", "");
  for (int n = 0; n <= 480; ++n) {  // of two whole turns each degree and a half
    const double part = n / 480.0;
    const Quaterniond a = about_x(part * first), b = about_z(part * second);
    const Quaterniond apart = conjugate(b * a) * (a * b);
    parts.push_back(part);
    reals.push_back(apart.real);
    sizes.push_back(apart.imaginary.norm());
  }
}
