/// @file
/// A hammer, modelled from the free end of its handle: the body that this chapter's pictures show.
#pragma once

#include <array>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

namespace tumble::support {

/// Metres. The handle runs along x, the head stands across its end along y.
struct Hammer {
  static constexpr double handle_length = 0.30, handle_width = 0.03;
  static constexpr double head_length = 0.11, head_width = 0.045;
};

/// A handle of ash and a head of steel, in model axes.
inline MassProperties<double> hammer() {
  const Mat3<double> unturned = Mat3<double>::Identity();
  const auto handle = mass_properties_of_density(
      Box<double>{{Hammer::handle_length, Hammer::handle_width, 0.025}}, 700);
  const auto head = mass_properties_of_density(
      Box<double>{{Hammer::head_width, Hammer::head_length, Hammer::head_width}}, 7850);
  return combined<double>(
      {moved<double>(handle, unturned, {Hammer::handle_length / 2, 0, 0}),
       moved<double>(head, unturned, {Hammer::handle_length + Hammer::head_width / 2, 0, 0})});
}

/// The corners of the drawn hammer, m, model axes, once around.
inline std::array<Vec3<double>, 9> hammer_outline() {
  const double w = Hammer::handle_width / 2, l = Hammer::handle_length;
  const double far_side = l + Hammer::head_width, h = Hammer::head_length / 2;
  return {Vec3d(0, -w, 0),        Vec3d(l, -w, 0),       Vec3d(l, -h, 0),
          Vec3d(far_side, -h, 0), Vec3d(far_side, h, 0), Vec3d(l, h, 0),
          Vec3d(l, w, 0),         Vec3d(0, w, 0),        Vec3d(0, -w, 0)};
}

}  // namespace tumble::support
