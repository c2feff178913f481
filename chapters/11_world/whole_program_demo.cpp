// A whole program around a world: frames that come as they come, pictures between two steps, a
// saved game, and an input that no body survives.
#include <support/record.hpp>

//! [whole_program]
#include <cstdio>
#include <sstream>
#include <tumble/drawing.hpp>
#include <tumble/gravity.hpp>
#include <tumble/snapshot_file.hpp>
#include <tumble/solids.hpp>

using namespace tumble;

/// What a game has: a world, the clock that says how many steps are due, and what is drawn of it.
struct Game {
  World<double> world{steps_per_second(120)};
  StepClock clock = make_step_clock(steps_per_second(120));
  Drawing<double> drawing;
  BodyHandle brick;

  Game() {
    const auto solid = mass_properties(Box<double>{{0.1, 0.2, 0.3}}, 2.0);  // edges, m; kg
    const Pose<double> start{{0, 0, 1}};
    const Vec3d velocity(3, 0, 4), angular_velocity(1, 5, 0);  // m/s, rad/s
    const auto made = make_rigid_body<double>("brick", solid, start, velocity, angular_velocity);
    brick = world.add("brick", made.body);
    world.add(Gravity<double>{});
    drawing.set_model(brick, made.model_in_body);
    drawing.note(world);
    world.on_warning([](const std::string& text) { std::printf("warning: %s\n", text.c_str()); });
  }

  //! [frame]
  /// A frame of so many seconds: the steps that are due, and where the brick is drawn then.
  Pose<double> frame(double seconds) {
    const std::int64_t due = steps_due(clock, nanoseconds_of(seconds));
    for (std::int64_t n = 0; n < due; ++n) {
      world.step();
      drawing.note(world);
    }
    return drawing.pose(brick, fraction_of_step<double>(clock));
  }
  //! [frame]
};

void play() {
  Game game;
  std::ostringstream saved;  // a file, in a game
  for (int frame = 0; frame < 30; ++frame) {
    const Pose<double> drawn = game.frame(frame % 3 == 0 ? 0.021 : 0.0165);  // s, as frames come
    if (frame % 10 == 9)
      std::printf("frame %2d, step %2lld: drawn at %s m\n", frame + 1,
                  static_cast<long long>(game.world.ticks()), text_of(drawn.position).c_str());
    if (frame == 9) write_snapshot(saved, game.world.save());
  }
  //! [input]
  try {  // a player's input that can't be
    const Vec3d centre = game.world.position(game.brick);
    game.world.push_at(game.brick, {1e308, 0, 0}, centre);
    game.world.push_at(game.brick, {1e308, 0, 0}, centre);
    game.frame(0.02);
  } catch (const SimulationError& error) {
    std::printf("%s\n", error.what());
  }
  //! [input]
  //! [back]
  std::istringstream file(saved.str());
  game.world.restore(read_snapshot<double>(file));
  game.drawing.cut(game.brick);  // it is not drawn on the way back
  std::printf("back to step %lld\n", static_cast<long long>(game.world.ticks()));
  //! [back]
}
//! [whole_program]

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  play();
}
