// A slinky is let go beside a stone, as the student's functions make it fall; ten times slower.
#include "a_slinky.hpp"

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <slinky.hpp>
#include <support/player_page.hpp>
#include <support/recording.hpp>
#include <tumble/pose.hpp>

namespace {

using namespace tumble;

/// A flat ring of wire around z.
support::Part ring(double radius, double wire) {
  const int corners_around = 20;
  std::vector<Vec3d> corners;
  std::vector<std::array<int, 3>> triangles;
  for (int n = 0; n < corners_around; ++n) {
    const double angle = 2 * std::numbers::pi * n / corners_around;
    const Vec3d outward(std::cos(angle), std::sin(angle), 0), up(0, 0, 1);
    for (const auto& [out, high] : {std::pair{1, -1}, {1, 1}, {-1, 1}, {-1, -1}})
      corners.push_back((radius + out * wire) * outward + high * wire * up);
    const int here = 4 * n, there = 4 * ((n + 1) % corners_around);
    for (int side = 0; side < 4; ++side) {
      const int next = (side + 1) % 4;
      triangles.push_back({here + side, there + side, there + next});
      triangles.push_back({here + side, there + next, here + next});
    }
  }
  return support::Part::mesh(corners, triangles);
}

}  // namespace

int main(int, char** arguments) {
  using support::Slinky;
  try {
    const int steps_a_frame = 2, frames = 200, frames_before = 30;
    const double time_step = 1.0 / 960, slower = 10;
    support::Recording recording("A slinky and a stone, ten times slower",
                                 time_step * steps_a_frame * slower);
    const double radius = 0.06;
    auto beads = hung_up<double>(Slinky::beads, Slinky::mass, Slinky::stiffness, Slinky::closed,
                                 Slinky::gravity);
    for (int i = 0; i < Slinky::beads; ++i)
      recording.add_body("coil " + std::to_string(i + 1), {ring(radius, 0.0012)});
    for (int i = 0; i + 1 < Slinky::beads; ++i) {
      const double side = i % 2 == 0 ? radius : -radius;
      recording.add_link({{side, 0, 0}, i}, {{-side, 0, 0}, i + 1});
    }
    recording.add_body("stone", {support::Part::sphere(0.03)});

    double centre = 0;
    for (const Particled& bead : beads) centre += bead.position.z() / Slinky::beads;
    auto stone = make_particle(Slinky::mass, Vec3d(0, 0.25, centre));
    const Vec3d floor(0, 0, 2);  // so far below the hand
    for (int frame = -frames_before; frame < frames; ++frame) {
      std::vector<Posed> poses;
      for (const Particled& bead : beads) poses.push_back({.position = bead.position + floor});
      poses.push_back({.position = stone.position + floor});
      recording.add_frame(poses);
      if (frame < 0) continue;
      beads = dropped(beads, Slinky::stiffness, Slinky::closed, Slinky::gravity, time_step,
                      steps_a_frame);
      for (int n = 0; n < steps_a_frame; ++n) {
        accelerate(stone, Vec3d(0, 0, -Slinky::gravity), time_step);
        drift(stone, time_step);
      }
    }
    support::write_player_page(arguments[1], recording.json());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
