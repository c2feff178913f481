/// @file
/// Solids of a scene file: what they weigh, and what of them is drawn.
#pragma once

#include <tumble/scene/object.hpp>
#include <tumble/scene/solid.hpp>

namespace tumble {

/// A model with what it means to the motion. Solids are worked out in double, whatever the
/// precision of the world: they are rounded to it once, at the end.
struct ReadSolid {
  std::vector<ModelPart> parts;
  MassProperties<double> properties;
};

/// Four numbers, the real part first, or an axis and an angle.
inline Quaternion<double> read_orientation(const Value& value) {
  if (value.is_object()) {
    const Object turn = object_called(value, "axis_angle");
    return value.guarded(
        [&] { return quaternion_about(turn["axis"].vector(), turn["angle"].number()); });
  }
  if (!value.is_array() || value.size() != 4)
    value.reject(
        "it must be a quaternion, four numbers with the real part first, or an object "
        "with axis and angle");
  const Quaternion<double> q{value.at(0).number(),
                             {value.at(1).number(), value.at(2).number(), value.at(3).number()}};
  return value.guarded([&] { return checked_orientation(q, "it"); });
}

inline Posed read_pose(const Object& object) {
  Posed pose{.position = object.vector("position")};
  if (object.has("orientation")) pose.orientation = read_orientation(object["orientation"]);
  return pose;
}

inline Mesh<double> read_mesh(const Object& object) {
  Mesh<double> mesh;
  const Value corners = object["corners"], triangles = object["triangles"];
  corners.list("corners");
  triangles.list("triangles");
  for (std::size_t i = 0; i < corners.size(); ++i) mesh.vertices.push_back(corners.at(i).vector());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Value triangle = triangles.at(i);
    if (!triangle.is_array() || triangle.size() != 3)
      triangle.reject("it must be a list of three numbers of corners, counted from 0");
    std::array<std::size_t, 3> numbers{};
    for (std::size_t k = 0; k < 3; ++k)
      numbers[k] = static_cast<std::size_t>(
          triangle.at(k).whole(0, static_cast<std::int64_t>(corners.size()) - 1));
    mesh.triangles.push_back(numbers);
  }
  return mesh;
}

/// A solid that is no compound.
inline Solid read_simple_solid(const Object& object) {
  const auto length = [&](std::string_view key) { return object[key].positive(); };
  const auto lengths = [&](std::string_view key) {
    const Value value = object[key];
    const Vec3d all = value.vector();
    for (std::size_t i = 0; i < 3; ++i) value.at(i).positive();
    return all;
  };
  const std::string_view shape = object.kind();
  if (shape == "sphere") return Sphere<double>{length("radius")};
  if (shape == "hollow_sphere") return HollowSphere<double>{length("radius")};
  if (shape == "spherical_shell")
    return SphericalShell<double>{object["inner_radius"].not_negative(), length("outer_radius")};
  if (shape == "box") return Box<double>{lengths("size")};
  if (shape == "ellipsoid") return Ellipsoid<double>{lengths("semi_axes")};
  if (shape == "cylinder") return Cylinder<double>{length("radius"), length("height")};
  if (shape == "cone") return Cone<double>{length("radius"), length("height")};
  if (shape == "capsule") return Capsule<double>{length("radius"), object["length"].not_negative()};
  if (shape == "thin_rod") return ThinRod<double>{length("length")};
  if (shape == "thin_plate") return ThinPlate<double>{length("width"), length("height")};
  return read_mesh(object);
}

/// What a solid weighs, by the mass or the density that `owner` gives.
inline MassProperties<double> read_mass(const Object& owner, const Object& shape,
                                        const Solid& solid) {
  const Value amount = owner.one_of("mass", "density");
  const double number = amount.positive();
  if (owner.has("mass"))
    return shape.value().guarded([&] {
      return std::visit([&](const auto& s) { return mass_properties(s, number); }, solid);
    });
  return shape.value().guarded([&] {
    return std::visit(
        [&](const auto& s) {
          if constexpr (requires { volume(s); })
            return mass_properties(s, number * volume(s));
          else
            amount.reject("a " + std::string(shape.kind()) + " has no volume: give its mass");
          return MassProperties<double>{};
        },
        solid);
  });
}

inline Object solid_object(const Value& value) {
  return object_of_kind(value, "solid", "shape", solid_kinds);
}

/// One part of a compound, in the axes of the whole.
inline void read_part(const Object& part, ReadSolid& whole,
                      std::vector<MassProperties<double>>& masses) {
  const Object shape = solid_object(part["solid"]);
  if (shape.kind() == "compound") shape["shape"].reject("a part can't have parts of its own");
  const Solid solid = read_simple_solid(shape);
  const Posed pose = read_pose(part);
  const MassProperties<double> mass = read_mass(part, shape, solid);
  masses.push_back(part.value().guarded(
      [&] { return moved<double>(mass, matrix_of(pose.orientation), pose.position); }));
  whole.parts.push_back({solid, pose});
}

/// The solid of `owner`, a body.
inline ReadSolid read_solid(const Object& owner) {
  const Object shape = solid_object(owner["solid"]);
  ReadSolid read;
  if (shape.kind() != "compound") {
    read.parts.push_back({read_simple_solid(shape), {}});
    if (!owner.boolean("static")) read.properties = read_mass(owner, shape, read.parts[0].solid);
    return read;
  }
  owner.forbid({"mass", "density"}, "each part of a compound has its own");
  const Value parts = shape["parts"];
  parts.list("parts");
  std::vector<MassProperties<double>> masses;
  for (std::size_t i = 0; i < parts.size(); ++i)
    read_part(object_called(parts.at(i), "part"), read, masses);
  read.properties = shape.value().guarded([&] { return combined(masses); });
  return read;
}

/// A tensor, as nine numbers or as three moments.
inline Mat3d read_inertia(const Value& value) {
  const std::string rule =
      "it must be a list of three moments, or of three rows of three numbers, in kg m^2";
  if (!value.is_array() || value.size() != 3) value.reject(rule);
  if (!value.at(0).is_array()) return value.vector().asDiagonal();
  Mat3d inertia;
  for (std::size_t row = 0; row < 3; ++row)
    inertia.row(static_cast<Eigen::Index>(row)) = value.at(row).vector();
  return inertia;
}

}  // namespace tumble
