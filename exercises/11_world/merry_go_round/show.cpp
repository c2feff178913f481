// A throw across a merry-go-round, in a world with the student's effect; and the same flight, seen
// from the ground.
#include <iostream>
#include <merry_go_round.hpp>
#include <support/player_page.hpp>
#include <support/recording.hpp>
#include <tumble/world.hpp>

namespace {

using namespace tumble;

const double rate = 0.7;         // rad/s
const Vec3d aside(2.7, 2.7, 0);  // how far the two pictures are apart
const int steps_in_a_frame = 16;

/// A round floor with a thrower at the one end and a catcher at the other, and where the ball went.
std::vector<support::Part> floor_with(const std::vector<Vec3d>& path) {
  std::vector<support::Part> parts = {
      support::Part::cylinder(3.2, 0.1).at(Posed{.position = {0, 0, -0.05}}),
      support::Part::capsule(0.2, 0.9).at(Posed{.position = {-2.9, 0, 0.65}}),
      support::Part::capsule(0.2, 0.9).at(Posed{.position = {2.9, 0, 0.65}})};
  for (const Vec3d& place : path)
    parts.push_back(support::Part::sphere(0.05).at(Posed{.position = place}));
  return parts;
}

/// Where a place on board is as seen from the ground, and the floor with it.
Posed turned(double time) {
  return {.orientation = quaternion_of_rotation_vector(Vec3d(0, 0, rate * time))};
}

}  // namespace

int main(int, char** arguments) {
  try {
    World<double> world(steps_per_second(60 * steps_in_a_frame));
    const BodyHandle ball =
        world.add("ball", make_particle<double>(0.4, {-2.6, 0, 1}, {4.5, 0, 0}));
    world.add(MerryGoRound<double>{{0, 0, rate}});

    const int frames = 90;
    std::vector<Vec3d> on_board;
    for (int frame = 0; frame <= frames; ++frame) {
      on_board.push_back(world.position(ball));
      for (int n = 0; n < steps_in_a_frame; ++n) world.step();
    }

    const double between = 1.0 / 60;
    std::vector<Vec3d> path;
    std::vector<support::Part> path_on_ground;
    for (std::size_t n = 0; n < on_board.size(); n += 3) {
      path.push_back(on_board[n]);
      const Vec3d seen = point_outward(turned(double(n) * between), on_board[n]);
      path_on_ground.push_back(support::Part::sphere(0.05).at(Posed{.position = seen}));
    }
    support::Recording recording("On board, and from the ground", between);
    recording.add_body("seen on board", floor_with(path));
    recording.add_body("seen from the ground", floor_with({}));
    recording.add_body("where it flew, from the ground", path_on_ground);
    recording.add_body("ball", {support::Part::sphere(0.15)});
    recording.add_body("ball, from the ground", {support::Part::sphere(0.15)});
    for (std::size_t n = 0; n < on_board.size(); ++n) {
      const Posed floor = turned(double(n) * between);
      recording.add_frame(
          std::vector<Posed>{{.position = -aside},
                             {.position = aside, .orientation = floor.orientation},
                             {.position = aside},
                             {.position = on_board[n] - aside},
                             {.position = point_outward(floor, on_board[n]) + aside}});
    }
    support::write_player_page(arguments[1], recording.json());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
