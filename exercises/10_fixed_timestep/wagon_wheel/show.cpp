// Two wheels that speed up together: as it is, and as the student's functions say that a film shows
// it.
#include <iostream>
#include <support/player_page.hpp>
#include <support/recording.hpp>
#include <tumble/pose.hpp>
#include <wagon_wheel.hpp>

namespace {

using namespace tumble;

const int spokes = 8;

Posed turned(double angle, const Vec3d& position) {
  return {.position = position, .orientation = quaternion_of_rotation_vector(Vec3d(0, angle, 0))};
}

std::vector<support::Part> wheel() {
  std::vector<support::Part> parts = {support::Part::cylinder(0.12, 0.2).at(
      Posed{.orientation = quaternion_of_rotation_vector(Vec3d(std::numbers::pi / 2, 0, 0))})};
  const int beads = 96;  // of the rim
  for (int i = 0; i < beads; ++i) {
    const double angle = 2 * std::numbers::pi * i / beads;
    parts.push_back(support::Part::box({0.05, 0.1, 0.06})
                        .at(turned(angle, {std::sin(angle), 0, std::cos(angle)})));
  }
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2 * std::numbers::pi * i / spokes;
    parts.push_back(support::Part::cylinder(0.03, 0.9).at(
        turned(angle, {0.55 * std::sin(angle), 0, 0.55 * std::cos(angle)})));
  }
  return parts;
}

}  // namespace

int main(int, char** arguments) {
  try {
    const double between = 1.0 / 60, seconds = 24, pictures = 16;
    const int frames = static_cast<int>(seconds / between);
    const double fastest = 1.75 * standing_rate(spokes, pictures);
    support::Recording recording("Above: the film. Below: the wheel.", between);
    recording.add_body("in the film", wheel());
    recording.add_body("as it is", wheel());
    double angle = 0, seen = 0;
    for (int frame = 0; frame <= frames; ++frame) {
      recording.add_frame(std::vector{turned(seen, {0, 0, 1.2}), turned(angle, {0, 0, -1.2})});
      const double rate = fastest * frame / frames;
      angle += between * rate;
      seen += between * seen_rate(rate, spokes, pictures);
    }
    support::write_player_page(arguments[1], recording.json());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
