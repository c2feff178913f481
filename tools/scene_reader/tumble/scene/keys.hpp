/// @file
/// Every key that a scene file can have, with its unit: what scene.schema.json publishes.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace tumble {

/// A key of an object in a scene file.
struct Key {
  std::string_view name;
  std::string_view unit = {};
  bool required = false;
};

/// The keys of one kind of object, called as in the schema's $defs.
struct ObjectKeys {
  std::string_view name;
  std::span<const Key> keys;
};

/// Helps to write the tables below.
template <std::size_t count>
consteval std::array<Key, count> keys(const Key (&list)[count]) {
  return std::to_array(list);
}

// --- The scene, its bodies, and where they are ---------------------------------------------------

inline constexpr auto scene_keys = keys({{"$schema"},
                                         {"title"},
                                         {"description"},
                                         {"step"},
                                         {"duration", "s", true},
                                         {"turning_method"},
                                         {"scheme"},
                                         {"bodies", "", true},
                                         {"effects"}});
inline constexpr auto step_keys = keys({{"per_second", "1/s"}, {"nanoseconds", "ns"}});
inline constexpr auto body_keys = keys({{"name", "", true},
                                        {"mass", "kg"},
                                        {"density", "kg/m^3"},
                                        {"solid"},
                                        {"inertia", "kg m^2"},
                                        {"centre_of_mass", "m"},
                                        {"position", "m"},
                                        {"orientation"},
                                        {"velocity", "m/s"},
                                        {"angular_velocity", "rad/s"},
                                        {"static"},
                                        {"turning"},
                                        {"many"}});
inline constexpr auto axis_angle_keys = keys({{"axis", "", true}, {"angle", "rad", true}});
inline constexpr auto many_keys = keys({{"count", "", true},
                                        {"seed", "", true},
                                        {"position_between", "m"},
                                        {"velocity_between", "m/s"},
                                        {"angular_velocity_between", "rad/s"},
                                        {"orientation_random"}});
inline constexpr auto part_keys = keys({{"solid", "", true},
                                        {"mass", "kg"},
                                        {"density", "kg/m^3"},
                                        {"position", "m"},
                                        {"orientation"}});

inline constexpr std::array<ObjectKeys, 6> object_kinds = {{{"scene", scene_keys},
                                                            {"step", step_keys},
                                                            {"body", body_keys},
                                                            {"axis_angle", axis_angle_keys},
                                                            {"many", many_keys},
                                                            {"part", part_keys}}};

// --- Solids, told apart by "shape" ---------------------------------------------------------------

inline constexpr Key shape_key{"shape", "", true};
inline constexpr auto radius_keys = keys({shape_key, {"radius", "m", true}});
inline constexpr auto box_keys = keys({shape_key, {"size", "m", true}});
inline constexpr auto ellipsoid_keys = keys({shape_key, {"semi_axes", "m", true}});
inline constexpr auto upright_keys =
    keys({shape_key, {"radius", "m", true}, {"height", "m", true}});
inline constexpr auto capsule_keys =
    keys({shape_key, {"radius", "m", true}, {"length", "m", true}});
inline constexpr auto thin_rod_keys = keys({shape_key, {"length", "m", true}});
inline constexpr auto thin_plate_keys =
    keys({shape_key, {"width", "m", true}, {"height", "m", true}});
inline constexpr auto shell_keys =
    keys({shape_key, {"inner_radius", "m", true}, {"outer_radius", "m", true}});
inline constexpr auto mesh_keys =
    keys({shape_key, {"corners", "m", true}, {"triangles", "", true}});
inline constexpr auto compound_keys = keys({shape_key, {"parts", "", true}});

inline constexpr std::array<ObjectKeys, 12> solid_kinds = {{{"sphere", radius_keys},
                                                            {"hollow_sphere", radius_keys},
                                                            {"spherical_shell", shell_keys},
                                                            {"box", box_keys},
                                                            {"ellipsoid", ellipsoid_keys},
                                                            {"cylinder", upright_keys},
                                                            {"cone", upright_keys},
                                                            {"capsule", capsule_keys},
                                                            {"thin_rod", thin_rod_keys},
                                                            {"thin_plate", thin_plate_keys},
                                                            {"mesh", mesh_keys},
                                                            {"compound", compound_keys}}};

// --- Effects, told apart by "kind" ---------------------------------------------------------------

inline constexpr Key kind_key{"kind", "", true}, name_key{"name"}, bodies_key{"bodies"};
inline constexpr Key fixed_bodies_key{"bodies", "", true}, wind_key{"wind", "m/s"};
inline constexpr Key stiffness_key{"stiffness", "N/m", true}, damping_key{"damping", "N s/m"};
inline constexpr Key rest_length_key{"rest_length", "m"}, only_pulls_key{"only_pulls"};

inline constexpr auto gravity_keys =
    keys({kind_key, name_key, bodies_key, {"acceleration", "m/s^2", true}});
inline constexpr auto point_gravity_keys =
    keys({kind_key, name_key, bodies_key, {"strength", "m^3/s^2", true}, {"centre", "m"}});
inline constexpr auto damping_keys = keys({kind_key, name_key, bodies_key, {"rate", "1/s", true}});
inline constexpr auto drag_keys =
    keys({kind_key, name_key, bodies_key, {"coefficient", "kg/m", true}, wind_key});
inline constexpr auto magnus_keys =
    keys({kind_key, name_key, bodies_key, {"strength", "kg", true}, wind_key});
inline constexpr auto buoyancy_keys = keys({kind_key,
                                            name_key,
                                            bodies_key,
                                            {"density", "kg/m^3", true},
                                            {"radius", "m", true},
                                            {"surface", "m"},
                                            {"gravity", "m/s^2"}});
inline constexpr auto spring_keys = keys({kind_key,
                                          name_key,
                                          fixed_bodies_key,
                                          stiffness_key,
                                          damping_key,
                                          rest_length_key,
                                          only_pulls_key,
                                          {"anchor", "m", true},
                                          {"attachment", "m"}});
inline constexpr auto spring_between_keys = keys({kind_key,
                                                  name_key,
                                                  {"first", "", true},
                                                  {"second", "", true},
                                                  stiffness_key,
                                                  damping_key,
                                                  rest_length_key,
                                                  only_pulls_key,
                                                  {"attachment_first", "m"},
                                                  {"attachment_second", "m"}});
inline constexpr auto thruster_keys = keys({kind_key,
                                            name_key,
                                            fixed_bodies_key,
                                            {"force", "N", true},
                                            {"point", "m"},
                                            {"from", "s"},
                                            {"until", "s"}});
inline constexpr auto reaction_wheel_keys = keys({kind_key,
                                                  name_key,
                                                  fixed_bodies_key,
                                                  {"axis", "", true},
                                                  {"momentum", "kg m^2/s"},
                                                  {"torque", "N m"},
                                                  {"from", "s"},
                                                  {"until", "s"}});

inline constexpr std::array<ObjectKeys, 12> effect_kinds = {
    {{"gravity", gravity_keys},
     {"gravity_as_acceleration", gravity_keys},
     {"point_gravity", point_gravity_keys},
     {"linear_damping", damping_keys},
     {"angular_damping", damping_keys},
     {"quadratic_drag", drag_keys},
     {"magnus", magnus_keys},
     {"buoyancy", buoyancy_keys},
     {"spring", spring_keys},
     {"spring_between", spring_between_keys},
     {"thruster", thruster_keys},
     {"reaction_wheel", reaction_wheel_keys}}};

}  // namespace tumble
