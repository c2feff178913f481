// A telescope that a wheel turns, and a spin that a wheel keeps from tumbling.
#include <numbers>
#include <support/record.hpp>
#include <tumble/reaction_wheel.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

constexpr double degree = std::numbers::pi / 180;

RigidBody<double> satellite_turning_with(const Vec3d& angular_velocity) {
  RigidBody<double> body;
  body.centre = make_particle<double>(400);
  body.top.inverse_moments = Vec3d(250, 200, 100).cwiseInverse();
  set_angular_velocity_body(body.top, angular_velocity);
  return body;
}

/// A telescope is to turn about its second axis, and then to stand still.
void turn_telescope(support::Notebook& notebook) {
  //! [telescope]
  World<double> orbit(steps_per_second(20));
  const BodyHandle telescope = orbit.add("telescope", satellite_turning_with({0, 0, 0}));
  ReactionWheel<double> wheel{.axis = {0, 1, 0}, .torque = -1, .until = 10};
  orbit.add(wheel, {telescope});
  wheel.torque = 1, wheel.from = 30, wheel.until = 40, wheel.name = "brake";
  orbit.add(wheel, {telescope});
  //! [telescope]
  std::printf("  time, s   spin, rad/s   turned, degrees\n");
  support::Table shares = notebook.table("wheel", {"time (s)", "body", "wheel"});
  double angle = 0;
  for (int n = 0; n <= 40 * 20; ++n) {
    const Top<double> top = orbit.body(telescope).top;
    if (n % 200 == 0) {
      angle = rotation_vector_of(top.orientation).norm() / degree;
      std::printf("  %7d   %11.4f   %15.3f\n", n / 20, angular_velocity_body(top).y() + 0.0, angle);
    }
    if (n % 10 == 0) {
      double wheels = 0;
      for (const auto& instance : orbit.effects())
        wheels += instance.effect->rotor_angular_momentum_body(orbit.time()).y();
      shares.row(orbit.time(), top.angular_momentum_body.y(), wheels);
    }
    orbit.step();
  }
  notebook.value("angle", support::number("%.1f°", angle));
  support::expect(std::abs(angle - 300 / 200. / degree) < 1e-9, "it turns by the area of h/I");
}

/// By how much (degrees) the spin leaves the axis of the middle moment, at most, in five minutes.
double strays(double momentum) {
  World<double> orbit(steps_per_second(20));
  const BodyHandle satellite = orbit.add("satellite", satellite_turning_with({0.001, 1, 0.001}));
  orbit.add(ReactionWheel<double>{.axis = {0, 1, 0}, .momentum = momentum}, {satellite});
  double most = 0;
  for (int n = 0; n < 300 * 20; ++n) {
    orbit.step();
    const Vec3d spin = angular_velocity_body(orbit.body(satellite).top);
    most = std::max(most, std::atan2(std::hypot(spin.x(), spin.z()), spin.y()));
  }
  return most / degree;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  turn_telescope(notebook);
  std::printf("\nThe spin leaves its axis, of the middle moment, by at most\n");
  for (const double momentum : {0.0, 45.0, 55.0, 100.0})
    std::printf("  %5.1f degrees with a wheel of %3.0f kg m^2/s\n", strays(momentum), momentum);
  support::expect(strays(45) > 20 && strays(55) < 1, "50 kg m²/s make the spin stable");
}
