// What a world does that can't go on: a force that is no number, and a spring that is too stiff.
#include <support/record.hpp>
#include <tumble/gravity.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

/// Each part of a long sentence on a line of its own.
std::string in_lines(std::string sentence) {
  for (std::size_t at = 0; (at = sentence.find_first_of(":;", at)) != std::string::npos; ++at)
    if (at + 1 < sentence.size()) sentence.replace(at + 1, 1, "\n  ");
  return sentence;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [singular]
  World<double> sky;
  const BodyHandle comet = sky.add("comet", make_particle<double>(1e9, {1, 0, 0}));
  sky.add("planet", make_particle<double>(1, {5, 0, 0}, {0, 1, 0}));
  sky.add(PointGravity<double>{.strength = 10, .centre = {0, 0, 0}});
  sky.set_position(comet, {0, 0, 0});
  try {
    sky.step();
  } catch (const SimulationError& error) {
    std::printf("%s\n\n", in_lines(error.what()).c_str());
  }
  //! [singular]
  support::expect(sky.ticks() == 0, "the step was not taken");
  support::expect(sky.position(sky.find("planet")) == Vec3d(5, 0, 0), "and nobody has moved");

  //! [stiff]
  World<double> dock(steps_per_second(60));
  const BodyHandle ship = dock.add("ship", make_particle<double>(1e6));
  const BodyHandle buoy = dock.add("buoy", make_particle<double>(1e-3, {1.001, 0, 0}));
  dock.add(SpringBetween<double>{.spring = {.stiffness = 1000, .rest_length = 1}}, {ship, buoy});
  dock.on_warning(
      [](const std::string& warning) { std::printf("%s\n", in_lines(warning).c_str()); });
  for (int n = 0; n <= 6; ++n) {
    dock.step();
    std::printf("  step %d: the buoy is at %.3g m\n", n + 1, dock.position(buoy).x());
  }
  //! [stiff]
  support::expect(dock.warnings().size() == 1, "the world warns of a mass ratio of 1e9");
  support::expect(dock.position(buoy).norm() > 1e3, "and it is right");
}
