// Writes FOLDER/every_part.html, a replay with every kind of part, a link, a path and awkward
// names; and following.html, the same with a camera that follows the path.
#include <numbers>
#include <support/player_page.hpp>
#include <support/recording.hpp>
#include <tumble/pose.hpp>

using namespace tumble;
using support::Part;

int main(int argument_count, char** arguments) {
  const std::filesystem::path folder = argument_count > 1 ? arguments[1] : ".";
  support::Recording recording("Every part, <b>bold</b> & </script> \"quoted\"", 0.1);
  const std::vector<Vec3d> corners = {
      {0.6, 0, -0.3}, {-0.3, 0.5, -0.3}, {-0.3, -0.5, -0.3}, {0, 0, 0.6}};
  const std::vector<Part> parts = {
      Part::box({1, 0.7, 0.5}),
      Part::sphere(0.5),
      Part::cylinder(0.5, 0.25),
      Part::capsule(0.3, 0.6),
      Part::cone(0.5, 0.9),
      Part::ellipsoid({0.6, 0.4, 0.3}),
      Part::mesh(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
      Part::point(),
  };
  for (const Part& part : parts) recording.add_body("A </script> body", {part});
  const int thrown = recording.add_body("thrown", {Part::sphere(0.2)});
  recording.add_link({.point = {0, 0, 0.25}, .body = 0}, {.point = {0, 0, 2}});
  recording.add_link({.point = {0, 0, 0}, .body = thrown}, {.point = {0, 0, 0}, .body = 7});

  std::vector<Posed> poses(parts.size() + 1);
  for (int frame = 0; frame <= 60; ++frame) {
    const double time = 0.1 * frame;
    for (std::size_t n = 0; n < parts.size(); ++n) {
      const double half_angle = time * 2 * std::numbers::pi / 6 / 2;
      poses[n].position = {1.5 * double(n % 4) - 2.25, n < 4 ? 0.8 : -0.8, 0};
      poses[n].orientation = {std::cos(half_angle),
                              {0, 0.6 * std::sin(half_angle), 0.8 * std::sin(half_angle)}};
    }
    poses.back().position = {-3 + time, -2, time * (6 - time) / 5};
    recording.add_frame(poses);
  }
  support::write_player_page(folder / "every_part.html", recording.json());
  recording.follow(thrown);
  support::write_player_page(folder / "following.html", recording.json());
}
