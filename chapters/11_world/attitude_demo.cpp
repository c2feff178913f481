// A controller that holds a satellite's attitude, in steps that it bears and in steps that it
// doesn't; and which steps those are, for every mixture of stiffness and damping.
#include <numbers>
#include <support/record.hpp>
#include <tumble/solids.hpp>
#include <tumble/world.hpp>

using namespace tumble;

//! [control]
/// Holds the attitude in which the axes of body and world agree, by the torque −k θ − c ω.
template <class Real>
struct HoldAttitude {
  static constexpr std::string_view name = "attitude control";
  static constexpr Quantities reads = quantity::orientation | quantity::spin;
  Real stiffness = 0;  // k, N m/rad
  Real damping = 0;    // c, N m s/rad

  Vec3<Real> torque(const Top<Real>& top, Real) const {
    return -stiffness * rotation_vector_of(top.orientation) - damping * angular_velocity_world(top);
  }
  Response<Real> response(const BodyState<Real>&) const {
    const Mat3<Real> every_axis = Mat3<Real>::Identity();
    return {.turning_stiffness = stiffness * every_axis, .turning_damping = damping * every_axis};
  }
};
//! [control]

namespace {

/// The angle (rad) by which the satellite is off after half a minute.
double angle_left(int rate, support::Notebook& notebook, support::Table& path) {
  //! [use]
  World<double> orbit(steps_per_second(rate));
  orbit.on_warning([](const std::string& told) { std::printf("  %s\n", told.c_str()); });
  const MassPropertiesd solid = mass_properties(Box<double>{{1, 1, 2}}, 100);
  const Posed askew = {{0, 0, 0}, quaternion_of_rotation_vector<double>({0.1, 0.1, 0.1})};
  const BodyHandle satellite =
      orbit.add("satellite", make_rigid_body<double>("satellite", solid, askew).body);
  orbit.add(HoldAttitude<double>{.stiffness = 40, .damping = 60});
  //! [use]
  for (int n = 0; n < 30 * rate; ++n) {
    if (n <= 12 * rate)
      path.row(double(rate), orbit.time(), rotation_vector_of(orbit.orientation(satellite)).z());
    orbit.step();
  }
  if (rate == 10) notebook.value("limit", support::number("%.2f s", orbit.step_limit().time_step));
  return rotation_vector_of(orbit.orientation(satellite)).norm();
}

/// Moments of 1 kg m², a little askew, in steps of 1 s: any other loop on one axis is this one in
/// other units.
struct Wheel {
  Wheel(double stiffness, double damping) : world(steps_per_second(1)) {
    world.on_warning([](const std::string&) {});
    const MassPropertiesd solid{.mass = 1, .inertia = Mat3d::Identity()};
    const Posed askew = {{0, 0, 0}, quaternion_of_rotation_vector<double>({0, 0, 1e-9})};
    body = world.add("wheel", make_rigid_body<double>("wheel", solid, askew).body);
    world.add(HoldAttitude<double>{.stiffness = stiffness, .damping = damping});
  }
  /// The largest angle (rad) in so many steps.
  double farthest_in(int steps) {
    double farthest = 0;
    for (int n = 0; n < steps && farthest < 1; ++n) {
      world.step();
      farthest = std::max(farthest, rotation_vector_of(world.orientation(body)).norm());
    }
    return farthest;
  }

  World<double> world;
  BodyHandle body;
};

/// Where a step bears a loop, by trial and by the world's limit: ω h to the right, and h c upwards.
void show_region(support::Notebook& notebook) {
  support::Table tried = notebook.table("bearable", {"omega h", "h c", "grows"});
  for (int right = 0; right < 24; ++right)
    for (int up = 0; up < 24; ++up) {
      const double swing = 0.05 + 0.1 * right, damping = 0.05 + 0.1 * up;
      Wheel wheel(swing * swing, damping);
      const double limit = wheel.world.step_limit().time_step, before = wheel.farthest_in(4000);
      const bool grows = before > 0.1 || wheel.farthest_in(4000) > 2 * before;
      support::expect(grows == (limit < 1), "a loop grows in steps beyond the limit alone");
      tried.row(swing, damping, double(grows));
    }
  // The satellite's loop at its smallest moment, in no step, in its short steps and in its long
  // ones.
  support::Table steps = notebook.table("bearable_steps", {"rate", "omega h", "h c"});
  const double moment = 100.0 / 12 * (1 + 1);
  steps.row(0.0, 0.0, 0.0);
  for (const int rate : {10, 2})
    steps.row(double(rate), std::sqrt(40 / moment) / rate, 60 / moment / rate);
  support::Table border = notebook.table("bearable_limit", {"omega h", "h c"});
  for (int n = 0; n <= 90; ++n) {
    const auto [damping, swing] = sine_cosine(n * std::numbers::pi / 180);
    const double limit = Wheel(swing * swing, damping).world.step_limit().time_step;
    border.row(limit * swing, limit * damping);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table path = notebook.table("attitude", {"rate", "time (s)", "about z (rad)"});
  for (const int rate : {10, 2}) {
    std::printf("%d steps per second\n", rate);
    const double angle = angle_left(rate, notebook, path);
    std::printf("  after 30 s it is off by %.2g rad\n", angle);
    support::expect((angle < 1e-4) == (rate == 10), "the loop holds where nothing was announced");
  }
  show_region(notebook);
}
