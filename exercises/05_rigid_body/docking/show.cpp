// A shuttle docks at a station, off its centre, and the pair tumbles on; the student's functions
// say how.
#include <array>
#include <docking.hpp>
#include <iostream>
#include <support/player_page.hpp>
#include <support/recording.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>
#include <tumble/tumbling.hpp>

namespace {

using namespace tumble;

/// A cylinder along x, for solids and pictures that stand along z.
const Quaterniond along_x = quaternion_about(Vec3d(0, 1, 0), std::numbers::pi / 2);

/// What holds the two parts together after docking: mass properties in the world's axes.
MassProperties<double> in_world(const Bodyd& body) {
  return {mass_of(body.centre), body.centre.position, world_inertia(body.top)};
}

/// The body `part` as seen from `whole`, for as long as the two hold each other.
Posed seen_from(const Bodyd& whole, const Posed& part) {
  return composed(inverse(pose_of(whole)), part);
}

}  // namespace

int main(int, char** arguments) {
  try {
    const double approach = 5, seconds = 24, time_step = 1.0 / 240;
    const int steps_per_frame = 12;
    // Both touch at the time 0; until then each flies straight on.
    const auto hull = mass_properties(Cylinder<double>{.radius = 0.5, .height = 4}, 900);
    const auto capsule = mass_properties(Cylinder<double>{.radius = 0.4, .height = 1.4}, 300);
    const auto station =
        make_rigid_body<double>("station", hull, {.position = {0, 0, 0}, .orientation = along_x});
    const Quaterniond along_y = quaternion_about(Vec3d(1, 0, 0), std::numbers::pi / 2);
    const auto shuttle = make_rigid_body<double>(
        "shuttle", capsule, {.position = {1.6, 1.2, 0}, .orientation = along_y}, {0, -0.6, 0},
        {0, 0.8, 0});

    support::Recording recording("Docking", time_step * steps_per_frame);
    recording.add_body("station",
                       {support::Part::cylinder(0.5, 4),
                        support::Part::box({3.2, 0.05, 0.9}).at(Posed{.position = {0, 0, -1.2}}),
                        support::Part::sphere(0.5).at(Posed{.position = {0, 0, 2}})});
    recording.add_body("shuttle",
                       {support::Part::cylinder(0.4, 1.0),
                        support::Part::cone(0.4, 0.5).at(Posed{.position = {0, 0, 0.75}}),
                        support::Part::box({1.8, 0.05, 0.5}).at(Posed{.position = {0, 0, -0.2}})});
    for (double time = -approach; time < 0; time += time_step * steps_per_frame) {
      Bodyd coming = shuttle.body;
      drift(coming.centre, time);
      turn_steadily(coming.top, time);  // about its own axis: exact
      recording.add_frame(std::array{drawn_pose(station.body, station.model_in_body),
                                     drawn_pose(coming, shuttle.model_in_body)});
    }
    const Vec3d velocity = common_velocity(station.body, shuttle.body),
                spin = common_spin(station.body, shuttle.body);
    auto both = combined<double>({in_world(station.body), in_world(shuttle.body)});
    both.centre_of_mass = common_centre(station.body, shuttle.body);
    Bodyd pair = make_rigid_body<double>("pair", both, {}, velocity, spin).body;
    const Posed first = seen_from(pair, drawn_pose(station.body, station.model_in_body));
    const Posed second = seen_from(pair, drawn_pose(shuttle.body, shuttle.model_in_body));
    for (int n = 0; n * time_step <= seconds - approach; ++n) {
      if (n % steps_per_frame == 0)
        recording.add_frame(std::array{drawn_pose(pair, first), drawn_pose(pair, second)});
      drift(pair, time_step);
    }
    support::write_player_page(arguments[1], recording.json());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
