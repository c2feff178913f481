/// @file
/// How a scene is drawn: its bodies and springs for a recording, and where the bodies are now.
#pragma once

#include <support/recording.hpp>

#include "body_record.hpp"

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

/// Adds the scene's bodies and springs to a recording that has none.
template <class Real, class Backend>
void draw(const Scene<Real, Backend>& scene, support::Recording& recording) {
  std::vector<int> numbers;
  for (const BodyModel& model : scene.models)
    for (std::size_t copy = 0; copy < model.count; ++copy)
      numbers.push_back(recording.add_body(model.name, drawn_parts(model)));
  const auto end = [&](const DrawnEnd& drawn) {
    return support::LinkEnd{drawn.point, drawn.body ? numbers[*drawn.body] : -1};
  };
  for (const auto& [from, to] : scene.springs) recording.add_link(end(from), end(to));
}

/// Where the models of all bodies are now, m, world axes; in the order in which draw() adds them.
template <class Real, class Backend>
std::vector<Posed> drawn_poses(const Scene<Real, Backend>& scene) {
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
  return poses;
}

}  // namespace tumble::simulate
