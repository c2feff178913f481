/// @file
/// The solids that a scene file knows, and how a body is made of them.
#pragma once

#include <tumble/make_rigid_body.hpp>
#include <tumble/mesh_mass_properties.hpp>
#include <tumble/spheres.hpp>
#include <variant>

namespace tumble {

/// A solid of chapter 3 with uniform density.
using Solid = std::variant<Sphere<double>, HollowSphere<double>, SphericalShell<double>,
                           Box<double>, Ellipsoid<double>, Cylinder<double>, Cone<double>,
                           Capsule<double>, ThinRod<double>, ThinPlate<double>, Mesh<double>>;

/// A solid and where it is in the model's axes, which is how it is drawn.
struct ModelPart {
  Solid solid;
  Posed in_model;
};

}  // namespace tumble
