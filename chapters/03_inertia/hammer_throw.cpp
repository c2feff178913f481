// A hammer is put together from two solids and thrown by one push that misses its centre of mass.
#include <numbers>
#include <support/record.hpp>
#include <tumble/force.hpp>
#include <tumble/solids.hpp>
#include <tumble/torque.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;
using support::number;

namespace {

const Vec3d gravity(0, 0, -9.81);  // m/s²
const double handle_length = 0.32, handle_radius = 0.015;
const Vec3d head_size(0.13, 0.04, 0.04);

/// The hammer in its own axes: the grip's end at the origin, the handle up along z, the head
/// across.
//! [hammer]
MassPropertiesd make_hammer() {
  const MassPropertiesd handle = mass_properties_of_density(
      Cylinder<double>{handle_radius, handle_length}, 800);  // kg/m³, wood
  const MassPropertiesd head = mass_properties_of_density(Box<double>{head_size}, 7850);  // steel
  const double head_height = handle_length + head_size.z() / 2;
  const Mat3d upright = Mat3d::Identity();
  return combined(std::vector{moved(handle, upright, {0, 0, handle_length / 2}),
                              moved(head, upright, {0, 0, head_height})});
}
//! [hammer]

/// A turn by `angle` about y, which carries z towards x.
Mat3d turn(double angle) {
  return Eigen::AngleAxisd(angle, Vec3d::UnitY()).toRotationMatrix();
}

/// Writes a rectangle of the hammer's own x-z plane as it stands in the world.
void outline(support::Table& table, const std::string& kind, const Vec3d& low, const Vec3d& high,
             const auto& to_world) {
  for (const auto& [x, z] : {std::pair{low.x(), low.z()},
                             {high.x(), low.z()},
                             {high.x(), high.z()},
                             {low.x(), high.z()},
                             {low.x(), low.z()}}) {
    const Vec3d corner = to_world(Vec3d(x, 0, z));
    table.row(kind, corner.x(), corner.z(), 0.0, 0.0);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const MassPropertiesd hammer = make_hammer();
  const double first_angle = 0.64;
  const Mat3d first_turn = turn(first_angle);

  //! [throw]
  const Vec3d grip = -(first_turn * hammer.centre_of_mass);  // seen from the centre of mass
  const Vec3d push = turn(0.056) * grip * (-4.7 * hammer.mass / grip.norm());  // N s
  const Vec3d velocity = push / hammer.mass;
  const Mat3d inverse_inertia_world =
      in_other_axes(inverse_inertia("hammer", hammer.inertia), first_turn);
  const Vec3d spin = inverse_inertia_world * torque_about(Vec3d::Zero().eval(), grip, push);
  //! [throw]
  support::expect(std::abs(spin.x()) + std::abs(spin.z()) < 1e-12 * std::abs(spin.y()),
                  "the hammer is mirrored in the plane of the throw, so it turns about y alone");

  const double flight = -2 * velocity.z() / gravity.z();
  const int poses = 10, steps_per_pose = 100;
  const double time_step = flight / (poses * steps_per_pose);
  support::Table table = notebook.table("hammer_throw", {"kind", "x (m)", "z (m)", "dx", "dz"});
  Particled centre = make_particle(hammer.mass, Vec3d(0, 0, 0), velocity);
  std::vector<Vec3d> path, parabola, end_of_handle;
  double farthest = 0;
  for (int n = 0; n <= poses * steps_per_pose; ++n) {
    const double time = n * time_step;
    const Mat3d R = turn(first_angle + spin.y() * time);
    const auto to_world = [&](const Vec3d& point) {
      return Vec3d(centre.position + R * (point - hammer.centre_of_mass));
    };
    if (n % steps_per_pose == 0) {
      const std::string pose = std::to_string(n / steps_per_pose);
      outline(table, "handle " + pose, {-handle_radius, 0, 0}, {handle_radius, 0, handle_length},
              to_world);
      outline(table, "head " + pose, {-head_size.x() / 2, 0, handle_length},
              {head_size.x() / 2, 0, handle_length + head_size.z()}, to_world);
      path.push_back(centre.position);
    }
    parabola.push_back(velocity * time + gravity * (time * time / 2));
    end_of_handle.push_back(to_world(Vec3d::Zero()));
    farthest = std::max(farthest, (centre.position - parabola.back()).norm());

    accelerate(centre, gravity, time_step);
    step(centre, time_step);
  }
  const auto draw = [&table](const char* kind, const std::vector<Vec3d>& points) {
    for (const Vec3d& point : points) table.row(kind, point.x(), point.z(), 0.0, 0.0);
  };
  draw("centre", path);
  draw("parabola", parabola);
  draw("end", end_of_handle);
  const Vec3d arrow = push / (hammer.mass * 14);
  table.row("push", grip.x() - arrow.x(), grip.z() - arrow.z(), arrow.x(), arrow.z());
  // First order: the steps fall behind by g h t / 2, and by a rounding or two.
  support::expect(farthest < 9.81 * time_step * flight / 2 * 1.0001,
                  "the stepped centre of mass stays on the parabola");

  const double miss = torque_about(Vec3d::Zero().eval(), grip, push).norm() / push.norm();
  const double turns = std::abs(spin.y()) * flight / (2 * std::numbers::pi);
  const Vec3d moments = principal_axes(hammer.inertia).moments;
  std::printf("mass                    %.3f kg\n", hammer.mass);
  std::printf("centre of mass          %.0f mm from the grip's end\n",
              1e3 * hammer.centre_of_mass.z());
  std::printf("principal moments       %.2e  %.2e  %.2e kg m^2\n", moments.x(), moments.y(),
              moments.z());
  std::printf("the push                %.2f N s, past the centre of mass by %.0f mm\n", push.norm(),
              1e3 * miss);
  std::printf("velocity of the centre  %.2f m/s\n", velocity.norm());
  std::printf("turning                 %.1f rad/s, %.1f turns in %.2f s\n", std::abs(spin.y()),
              turns, flight);
  notebook.value("miss", number("%.0f mm", 1e3 * miss));
  notebook.value("turns", number("%.1f", turns));
  notebook.value("poses", number("%.0f", poses + 1));
}
