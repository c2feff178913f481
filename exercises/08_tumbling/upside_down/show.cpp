// The satellite turns over on one order, and back on another, as the student's functions make it.
// Here the masses take half a second for their way, as real ones would.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <support/player_page.hpp>
#include <support/recording.hpp>
#include <tumble/pose.hpp>
#include <upside_down.hpp>

namespace {

using namespace tumble;

/// The same satellite as someone sees it who calls its -x axis x: turned about y by half a turn.
Topd seen_from_the_other_side(Topd top) {
  top.angular_momentum_body.x() *= -1;
  top.angular_momentum_body.z() *= -1;
  return top;
}

}  // namespace

int main(int, char** arguments) {
  try {
    const Vec3d hull(3, 2.5, 1);
    const double mass = 0.4, longest = 1.06, shortest = 0.35, time_step = 1.0 / 120;
    const double spin = 4, seconds = 34, second_order = 17;
    const int steps_a_frame = 4;
    support::Recording recording("A satellite that turns itself over", time_step * steps_a_frame);
    const auto at_x = [](double x) {
      return Posed{.position = {x, 0, 0},
                   .orientation = quaternion_about(Vec3d(0, 1, 0), std::numbers::pi / 2)};
    };
    // A disc of a hull with two wings along z, the antenna on its x side.
    const int body =
        recording.add_body("satellite", {support::Part::cylinder(0.3, 0.3).at(at_x(0)),
                                         support::Part::box({0.04, 0.5, 2.4}),
                                         support::Part::cone(0.2, 0.3).at(at_x(0.25))});
    const int left = recording.add_body("mass on x", {support::Part::sphere(0.07)});
    const int right = recording.add_body("mass on -x", {support::Part::sphere(0.07)});
    recording.add_link({{0, 0, 0}, body}, {{0, 0, 0}, left});
    recording.add_link({{0, 0, 0}, body}, {{0, 0, 0}, right});

    Topd top;
    set_booms(top, hull, mass, 0.0);
    set_angular_velocity_body(top, Vec3d(spin, spin / 64, spin / 64));
    // x, and with it the spin, upright.
    top.orientation = quaternion_about(Vec3d(0, 1, 0), -std::numbers::pi / 2);
    double place = shortest;
    bool out = false;
    for (int n = 0; n * time_step <= seconds; ++n) {
      if (n % steps_a_frame == 0) {
        const auto mass_at = [&](double x) {
          return Posed{.position = rotate(top.orientation, Vec3d(x, 0, 0)),
                       .orientation = top.orientation};
        };
        recording.add_frame(std::array{mass_at(0), mass_at(place), mass_at(-place)});
      }
      const bool back = n * time_step > second_order;
      out = booms_out(back ? seen_from_the_other_side(top) : top, out);
      place = std::clamp(place + (out ? 1.4 : -1.4) * time_step, shortest, longest);
      // Where the masses are when they are in, the hull's moments count them already.
      set_booms(top, hull, mass, std::sqrt(place * place - shortest * shortest));
      turn_by_splitting(top, time_step);
    }
    support::write_player_page(arguments[1], recording.json());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
