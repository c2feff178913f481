// Three shots over a net, as the student's functions make them, and one with damping in place of
// drag.
#include <iostream>
#include <shuttlecock.hpp>
#include <support/player_page.hpp>
#include <support/recording.hpp>
#include <tumble/damping.hpp>
#include <tumble/pose.hpp>

namespace {

using namespace tumble;

/// The cork flies ahead of the feathers: what was z points along the velocity.
Posed flying(const Particled& shuttle) {
  const Vec3d ahead = shuttle.velocity.normalized(), up = Vec3d::UnitZ();
  const Vec3d axis = up.cross(ahead);
  const double sine = axis.norm(), angle = std::atan2(sine, up.dot(ahead));
  const Vec3d turn = sine > 0 ? Vec3d(axis * (angle / sine)) : Vec3d::Zero();
  return {.position = shuttle.position, .orientation = quaternion_of_rotation_vector(turn)};
}

}  // namespace

int main(int, char** arguments) {
  try {
    const int frames = 240, steps_per_frame = 20;
    const double between = 1.0 / 60, h = between / steps_per_frame, mass = 0.005, terminal = 6.75;
    const double coefficient = coefficient_of(mass, terminal);
    const Vec3d still = Vec3d::Zero();

    support::Recording recording("A smash, a clear and a drop", between);
    // The court, and shuttles eight times as large as life.
    recording.add_body("court",
                       {support::Part::box({13.4, 6.1, 0.02}).at(Posed{.position = {0, 0, -0.01}}),
                        support::Part::box({0.03, 6.1, 0.76}).at(Posed{.position = {0, 0, 1.17}})});
    const std::vector<support::Part> shuttle = {
        support::Part::sphere(0.13).at(Posed{.position = {0, 0, 0.26}}),
        support::Part::cone(0.26, 0.55)};
    for (const char* name : {"smash", "clear", "drop"}) recording.add_body(name, shuttle);
    recording.add_body("the clear, damped", {support::Part::sphere(0.13)});

    std::vector<Particled> flying_ones = {
        make_particle<double>(mass, {-4, -1.8, 2.7}, {96, 0, -22}),
        make_particle<double>(mass, {-5, 0, 2.2}, {23, 0, 27}),
        make_particle<double>(mass, {-3, 1.8, 2.5}, {7, 0, 4})};
    Particled damped = flying_ones[1];
    const double kept = fraction_kept(gravity<double> / terminal, h);

    const auto land = [](Particled& one) {
      if (one.position.z() >= 0.1) return;
      one.position.z() = 0.1;
      one.velocity = {0, 0, -1e-3};  // so that it stands on its cork
    };
    for (int frame = 0; frame <= frames; ++frame) {
      std::vector<Posed> poses = {Posed{}};
      for (const Particled& one : flying_ones) poses.push_back(flying(one));
      poses.push_back({.position = damped.position});
      recording.add_frame(poses);
      for (int n = 0; n < steps_per_frame; ++n) {
        for (Particled& one : flying_ones)
          if (one.position.z() > 0.1) {
            step_shuttle<double>(one, still, coefficient, h);
            land(one);
          }
        if (damped.position.z() > 0.1) {
          damped.velocity = kept * (damped.velocity - h * Vec3d(0, 0, gravity<double>));
          damped.position += h * damped.velocity;
          land(damped);
        }
      }
    }
    support::write_player_page(arguments[1], recording.json());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
