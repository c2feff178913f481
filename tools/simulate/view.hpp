/// @file
/// A page that replays the motion.
#pragma once

#include <support/player_page.hpp>
#include <support/recording.hpp>

#include "trajectory.hpp"

namespace tumble::simulate {

/// How a solid is drawn. What has no thickness gets none or a little.
struct DrawSolid {
  using Part = support::Part;
  Part operator()(const Sphere<double>& s) const { return Part::sphere(s.radius); }
  Part operator()(const HollowSphere<double>& s) const { return Part::sphere(s.radius); }
  Part operator()(const SphericalShell<double>& s) const { return Part::sphere(s.outer_radius); }
  Part operator()(const Box<double>& s) const { return Part::box(s.size); }
  Part operator()(const Ellipsoid<double>& s) const { return Part::ellipsoid(s.semi_axes); }
  Part operator()(const Cylinder<double>& s) const { return Part::cylinder(s.radius, s.height); }
  Part operator()(const Cone<double>& s) const { return Part::cone(s.radius, s.height); }
  Part operator()(const Capsule<double>& s) const { return Part::capsule(s.radius, s.length); }
  Part operator()(const ThinRod<double>& s) const {
    return Part::cylinder(s.length / 100, s.length);
  }
  Part operator()(const ThinPlate<double>& s) const { return Part::box({s.width, s.height, 0}); }
  Part operator()(const Mesh<double>& s) const {
    std::vector<std::array<int, 3>> triangles;
    for (const auto& [a, b, c] : s.triangles)
      triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
    return Part::mesh(s.vertices, triangles);
  }
};

inline std::vector<support::Part> drawn_parts(const BodyModel& model) {
  std::vector<support::Part> parts;
  for (const ModelPart& part : model.parts)
    parts.push_back(std::visit(DrawSolid{}, part.solid).at(part.in_model));
  if (parts.empty()) parts.push_back(support::Part::point());
  return parts;
}

class View {
  static constexpr double most_poses = 2e6;  // the page then has about a hundred megabytes

 public:
  /// @throws FileError if the page would hold too much, or can't be written.
  template <class Real, class Keeping>
  View(const std::filesystem::path& path, const Scene<Real, Keeping>& scene, std::int64_t every,
       std::int64_t steps)
      : file_(path),
        recording_(scene.title,
                   time_step_of<double>(scene.world.step_length()) * static_cast<double>(every)) {
    const std::int64_t frames = steps / every + 1;
    const double poses =
        static_cast<double>(scene.world.body_count()) * static_cast<double>(frames);
    if (poses > most_poses)
      throw FileError(path, "it would hold " + text_of(poses) + " poses, and a page with over " +
                                text_of(most_poses) + " is slow; record fewer with --every");
    std::vector<int> numbers;
    for (const BodyModel& model : scene.models)
      for (std::size_t copy = 0; copy < model.count; ++copy)
        numbers.push_back(recording_.add_body(model.name, drawn_parts(model)));
    const auto end = [&](const DrawnEnd& drawn) {
      return support::LinkEnd{drawn.point, drawn.body ? numbers[*drawn.body] : -1};
    };
    for (const auto& [from, to] : scene.springs) recording_.add_link(end(from), end(to));
  }

  template <class Real, class Keeping>
  void record(const Scene<Real, Keeping>& scene) {
    std::vector<Posed> poses;
    for_each_body(scene, [&](const std::string&, const BodyRecord& body) {
      poses.push_back({body.position, body.orientation});
    });
    std::size_t i = 0;
    for (const BodyModel& model : scene.models) {
      const Vec3d origin_in_model = inverse(model.model_in_body).position;
      for (std::size_t copy = 0; copy < model.count; ++copy, ++i)
        poses[i].position -= rotate(poses[i].orientation, origin_in_model);
    }
    recording_.add_frame(poses);
  }

  void finish() {
    file_.write(support::player_page(recording_.json()));
    file_.finish();
  }
  OutputFile& file() { return file_; }

 private:
  OutputFile file_;
  support::Recording recording_;
};

}  // namespace tumble::simulate
