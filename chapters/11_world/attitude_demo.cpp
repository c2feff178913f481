// A controller that holds a satellite's attitude, in steps that it bears and in steps that it
// doesn't.
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
      path.row(double(rate), orbit.time(),
               rotation_vector_of(orbit.body(satellite).top.orientation).z());
    orbit.step();
  }
  if (rate == 10) notebook.value("limit", support::number("%.2f s", orbit.step_limit().time_step));
  return rotation_vector_of(orbit.body(satellite).top.orientation).norm();
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
}
