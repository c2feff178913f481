/// @file
/// A body in numbers, as every file and page shows it.
#pragma once

#include <tumble/scene/scene.hpp>

namespace tumble::simulate {

/// A body as the file shows it: the centre of mass, and the orientation of the model, not that of
/// the principal axes, which nobody sees. World axes.
struct BodyRecord {
  Vec3d position, velocity, angular_velocity;
  Quaternion<double> orientation;
};

template <class Real>
BodyRecord record_of(const RigidBody<Real>& body, const Posed& model_in_body) {
  const Quaternion<double> q{static_cast<double>(body.top.orientation.real),
                             body.top.orientation.imaginary.template cast<double>()};
  return {body.centre.position.template cast<double>(),
          body.centre.velocity.template cast<double>(),
          angular_velocity_world(body.top).template cast<double>(), q * model_in_body.orientation};
}

/// Calls `visit` with each body's name and record.
template <class Real, class Backend, class Visit>
void for_each_body(const Scene<Real, Backend>& scene, const Visit& visit) {
  for (const BodyModel& model : scene.models)
    for (std::size_t i = model.first; i < model.first + model.count; ++i) {
      const BodyHandle handle = scene.world.handle_at(static_cast<BodyIndex>(i));
      visit(scene.world.name_of(handle), record_of(scene.world.body(handle), model.model_in_body));
    }
}

inline std::array<double, 13> state_of(const BodyRecord& body) {
  const auto& [x, v, w, q] = body;
  return {x.x(),           x.y(),           x.z(), q.real, q.imaginary.x(),
          q.imaginary.y(), q.imaginary.z(), v.x(), v.y(),  v.z(),
          w.x(),           w.y(),           w.z()};
}

}  // namespace tumble::simulate
