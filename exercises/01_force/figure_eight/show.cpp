// Two rounds of the figure of eight, as the student's functions make it.
#include "three_suns.hpp"

#include <figure_eight.hpp>
#include <iostream>
#include <support/player_page.hpp>
#include <support/recording.hpp>
#include <tumble/pose.hpp>

int main(int, char** arguments) {
  using namespace tumble;
  try {
    const int frames = 240, steps_per_frame = 16;
    const double seconds = 2 * support::period_of_the_eight, between = seconds / frames;
    support::Recording recording("Three suns on a figure of eight", between);
    for (const char* name : {"first", "second", "third"})
      recording.add_body(name, {support::Part::sphere(0.08)});
    // The curve itself, as beads where the first sun will be.
    std::vector<support::Part> beads;
    auto suns = support::three_suns<double>();
    for (int n = 0; n < 96; ++n) {
      beads.push_back(support::Part::sphere(0.012).at(Posed{.position = suns[0].position}));
      suns = flown(suns, support::period_of_the_eight / 96 / 32, 32);
    }
    recording.add_body("the curve", beads);
    suns = support::three_suns<double>();
    for (int frame = 0; frame <= frames; ++frame) {
      std::vector<Posed> poses;
      for (const Particled& sun : suns) poses.push_back({.position = sun.position});
      poses.emplace_back();  // of the curve, which stays
      recording.add_frame(poses);
      suns = flown(suns, between / steps_per_frame, steps_per_frame);
    }
    support::write_player_page(arguments[1], recording.json());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
