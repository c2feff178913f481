/// @file
/// What makes and checks bodies, compiled once for all checks and programs of the course: see
/// support/bodies and tumble_compile_once in cmake/TumbleCourse.cmake. Users have the headers
/// alone.
#pragma once

// NOLINTBEGIN(bugprone-macro-parentheses): a kind of declaration and a type can stand in none
#define TUMBLE_BODIES(how, Real)                                                                   \
  how template std::string text_of(Real);                                                          \
  how template std::string text_of(const Vec3<Real>&);                                             \
  how template void reject(std::string_view, const Real&, std::string_view, std::string_view);     \
  how template void reject(std::string_view, const Vec3<Real>&, std::string_view,                  \
                           std::string_view);                                                      \
  how template void require_between(std::string_view, Real, std::string_view, Real, Real);         \
  how template void require_finite(std::string_view, const Vec3<Real>&, std::string_view);         \
  how template Particle<Real> make_particle(Real, const Vec3<Real>&, const Vec3<Real>&);           \
  how template PrincipalAxes<Real> principal_axes(const Mat3<Real>&, std::string_view);            \
  how template PrincipalAxes<Real> require_possible_inertia(std::string_view, const Mat3<Real>&,   \
                                                            Real);                                 \
  how template PrincipalAxes<Real> require_invertible_inertia(std::string_view, const Mat3<Real>&, \
                                                              Real);                               \
  how template PrincipalAxes<Real> require_possible(std::string_view,                              \
                                                    const MassProperties<Real>&);                  \
  how template Quaternion<Real> checked_orientation(const Quaternion<Real>&, std::string_view);    \
  how template Quaternion<Real> quaternion_of(const Mat3<Real>&, std::string_view);                \
  how template void set_checked_angular_velocity(std::string_view, Top<Real>&, const Vec3<Real>&); \
  how template RigidBody<Real> make_static_body(std::string_view, const Pose<Real>&);              \
  how template ModelledBody<Real> make_rigid_body(std::string_view, const MassProperties<Real>&,   \
                                                  const Pose<Real>&, const Vec3<Real>&,            \
                                                  const Vec3<Real>&, Turning);
// NOLINTEND(bugprone-macro-parentheses)

namespace tumble {
TUMBLE_BODIES(extern, float)
TUMBLE_BODIES(extern, double)
}  // namespace tumble
