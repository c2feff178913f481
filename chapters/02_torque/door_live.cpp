// A door seen from above, live: one push, somewhere on it, and its torque about the hinge.
#include <numbers>
#include <support/live.hpp>
#include <tumble/sine_cosine.hpp>
#include <tumble/torque.hpp>

using namespace tumble;

namespace {

Vec3d direction(double degrees) {
  const auto [sine, cosine] = sine_cosine(degrees * std::numbers::pi / 180);
  return {cosine, sine, 0};
}

/// How far the line of the force passes from the origin: positive if the push turns anticlockwise.
double distance_of_line(const Vec3d& point, const Vec3d& along) {
  const Vec3d foot = point - along * along.dot(point);
  return std::copysign(foot.norm(), foot.x() * along.y() - foot.y() * along.x());
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const double at = live.knob("at", "m", 0.8, 0, 0.8);
  const double angle = live.knob("angle", "°", 60, -180, 180);
  const double force = live.knob("force", "N", 10, 1, 15);

  // The hinge is the origin, the door lies along x, and its width is 0.8 m.
  const Vec3d point(at, 0, 0);
  Wrenchd wrench;
  add_force_at(wrench, force * direction(angle), point);
  live.column("torque", "N m").push_back(wrench.torque.z());
  live.column("distance", "m").push_back(distance_of_line(point, direction(angle)));

  std::vector<double>&angles = live.column("angles", "°"), &torques = live.column("torques", "N m"),
  &second_way = live.column("force times distance", "N m");
  for (int degrees = -180; degrees <= 180; degrees += 3) {
    angles.push_back(degrees);
    torques.push_back(torque_about<double>({0, 0, 0}, point, force * direction(degrees)).z());
    second_way.push_back(force * distance_of_line(point, direction(degrees)));
  }
}
