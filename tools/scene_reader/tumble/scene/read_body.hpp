/// @file
/// Bodies of a scene file, one by one and by the thousand.
#pragma once

#include <tumble/scene/portable_random.hpp>
#include <tumble/scene/read_solid.hpp>
#include <tumble/scene/scene.hpp>

namespace tumble {

/// What tells the copies of a body from each other.
struct ManyCopies {
  std::size_t count = 1;
  std::uint64_t seed = 0;
  std::optional<std::array<Vec3d, 2>> positions, velocities, angular_velocities;
  bool any_orientation = false;
};

inline ManyCopies read_many(const Object& object) {
  ManyCopies many;
  many.count = static_cast<std::size_t>(object["count"].whole(1, most_bodies));
  many.seed = static_cast<std::uint64_t>(object["seed"].whole(0, std::int64_t{1} << 53));
  const auto corners = [&](std::string_view key, std::optional<std::array<Vec3d, 2>>& box) {
    if (!object.has(key)) return;
    const Value value = object[key];
    if (!value.is_array() || value.size() != 2)
      value.reject("it must be a list of two corners, the smaller and the larger numbers");
    box = {value.at(0).vector(), value.at(1).vector()};
  };
  corners("position_between", many.positions);
  corners("velocity_between", many.velocities);
  corners("angular_velocity_between", many.angular_velocities);
  many.any_orientation = object.boolean("orientation_random");
  return many;
}

/// One body, or the pattern of many.
struct BodyPattern {
  std::string name;
  bool is_static = false, is_point = false;
  MassProperties<double> properties;
  Posed pose;
  Vec3d velocity = Vec3d::Zero(), angular_velocity = Vec3d::Zero();
  Turning turning = Turning::free;
};

/// Reads the keys that depend on what kind of body it is, and refuses those that don't belong to
/// it.
inline void read_matter(const Object& object, BodyPattern& body, BodyModel& model) {
  if (object.has("solid")) {
    object.forbid({"inertia", "centre_of_mass"}, "the solid says it already");
    const ReadSolid read = read_solid(object);
    model.parts = read.parts;
    body.properties = read.properties;
  } else if (object.has("inertia")) {
    object.forbid({"density"}, "without a solid there is no volume: give the mass");
    if (!object.has("mass")) object.value().fail("needs the key mass, in kg");
    body.properties = {object["mass"].positive(), object.vector("centre_of_mass"),
                       read_inertia(object["inertia"])};
  } else if (!body.is_static) {
    const std::string why = "a point has none; give the body a solid or an inertia";
    object.forbid({"density", "centre_of_mass", "orientation", "angular_velocity", "turning"}, why);
    if (!object.has("mass")) object.value().fail("needs the key mass, in kg");
    body.is_point = true;
    body.properties.mass = object["mass"].positive();
  }
}

inline BodyPattern read_pattern(const Object& object, BodyModel& model) {
  constexpr std::array<std::string_view, 3> turnings = {"free", "locked_where_thin", "locked"};
  BodyPattern body;
  body.name = object["name"].text();
  if (body.name.empty() || body.name.size() > longest_name)
    object["name"].reject("a name must have 1 to " + std::to_string(longest_name) + " bytes");
  body.is_static = object.boolean("static");
  if (body.is_static)
    object.forbid(
        {"mass", "density", "inertia", "centre_of_mass", "velocity", "angular_velocity", "turning"},
        "nothing can move a static body, so it has none");
  read_matter(object, body, model);
  body.pose = read_pose(object);
  body.velocity = object.vector("velocity");
  body.angular_velocity = object.vector("angular_velocity");
  if (object.has("turning"))
    body.turning = static_cast<Turning>(object["turning"].one_of("way of turning", turnings));
  return body;
}

/// The body rounded to the precision of its world.
template <class Real>
RigidBody<Real> rounded(const RigidBody<double>& body) {
  RigidBody<Real> result;
  result.centre.position = body.centre.position.cast<Real>();
  result.centre.velocity = body.centre.velocity.cast<Real>();
  result.centre.inverse_mass = static_cast<Real>(body.centre.inverse_mass);
  const Quaternion<double>& q = body.top.orientation;
  result.top.orientation =
      renormalized<Real>({static_cast<Real>(q.real), q.imaginary.cast<Real>()});
  result.top.angular_momentum_body = body.top.angular_momentum_body.cast<Real>();
  result.top.inverse_moments = body.top.inverse_moments.cast<Real>();
  return result;
}

/// Throws unless the rounding left no mass infinite, and made nothing immovable that can move.
template <class Real>
void require_rounded(const RigidBody<double>& body, const RigidBody<Real>& rounded) {
  const auto kept = [](double exact, Real rounding) {
    return std::isfinite(rounding) &&
           (exact == 0) == (std::abs(rounding) < range_of<Real>().smallest);
  };
  bool all = kept(body.centre.inverse_mass, rounded.centre.inverse_mass);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    all &= kept(body.top.inverse_moments[axis], rounded.top.inverse_moments[axis]) &&
           std::isfinite(rounded.top.angular_momentum_body[axis]);
  if (!all)
    throw std::invalid_argument("its mass, moments of inertia or angular momentum do not fit a " +
                                std::string(range_of<Real>().precision));
}

/// Adds one body of the pattern. @return the pose of its model in it
template <class Real, class Backend>
Posed add_body(World<Real, Backend>& world, const std::string& name, const BodyPattern& pattern) {
  if (pattern.is_point) {
    RigidBody<double> point;
    point.centre = make_particle(pattern.properties.mass, pattern.pose.position, pattern.velocity);
    const RigidBody<Real> result = rounded<Real>(point);
    require_rounded(point, result);
    world.add(name, result.centre);
    return {};
  }
  ModelledBody<double> made;
  if (pattern.is_static)
    made.body = make_static_body(name, pattern.pose);
  else
    made = make_rigid_body(name, pattern.properties, pattern.pose, pattern.velocity,
                           pattern.angular_velocity, pattern.turning);
  const RigidBody<Real> result = rounded<Real>(made.body);
  require_rounded(made.body, result);
  world.add(name, result);
  return made.model_in_body;
}

/// Reads one element of "bodies" and adds what it stands for.
template <class Real, class Backend>
void read_body(const Object& object, Scene<Real, Backend>& scene, const SceneChanges& changes) {
  BodyModel model;
  BodyPattern pattern = read_pattern(object, model);
  model.name = pattern.name;
  model.first = scene.world.body_count();
  ManyCopies many;
  if (object.has("many")) {
    const Object copies = object_called(object["many"], "many");
    many = read_many(copies);
    const auto refuse_twice = [&](bool given, std::string_view key) {
      if (given) object.forbid({key}, "many says already what it is between");
    };
    refuse_twice(many.positions.has_value(), "position");
    refuse_twice(many.velocities.has_value(), "velocity");
    refuse_twice(many.angular_velocities.has_value(), "angular_velocity");
    refuse_twice(many.any_orientation, "orientation");
    if (pattern.is_static)
      copies.forbid({"velocity_between", "angular_velocity_between"},
                    "nothing can move a static body");
    if (pattern.is_point)
      copies.forbid({"angular_velocity_between", "orientation_random"}, "a point has none");
  }
  model.count = std::min(many.count, changes.most_copies);
  if (model.first + model.count > static_cast<std::size_t>(most_bodies))
    object.value().fail("brings more than " + std::to_string(most_bodies) +
                        " bodies into the scene; at most that many are allowed");
  PortableRandom random(many.seed + changes.seed);
  for (std::size_t copy = 1; copy <= model.count; ++copy) {
    if (many.positions) pattern.pose.position = random.between(*many.positions);
    if (many.velocities) pattern.velocity = random.between(*many.velocities);
    if (many.angular_velocities)
      pattern.angular_velocity = random.between(*many.angular_velocities);
    if (many.any_orientation) pattern.pose.orientation = random.orientation();
    const std::string name =
        object.has("many") ? pattern.name + " " + std::to_string(copy) : pattern.name;
    model.model_in_body =
        object.value().guarded([&] { return add_body(scene.world, name, pattern); });
  }
  scene.models.push_back(std::move(model));
}

}  // namespace tumble
