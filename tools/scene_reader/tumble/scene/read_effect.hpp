/// @file
/// Effects of a scene file.
#pragma once

#include <limits>
#include <set>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/reaction_wheel.hpp>
#include <tumble/scene/scene.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>

namespace tumble {

/// The bodies of one element of "bodies" that an effect is meant for.
struct Targets {
  std::size_t model = 0;
  std::vector<BodyHandle> bodies;
  std::vector<std::size_t> indices;  ///< of the same bodies in the world
};

/// Finds the bodies that a text names: one body, or all copies of one element.
template <class Real, class Backend>
Targets find_targets(const Value& name, const Scene<Real, Backend>& scene) {
  const std::string word = name.text();
  std::vector<std::string_view> known;
  for (std::size_t m = 0; m < scene.models.size(); ++m) {
    const BodyModel& model = scene.models[m];
    known.push_back(model.name);
    Targets targets{m, {}, {}};
    for (std::size_t i = model.first; i < model.first + model.count; ++i) {
      const BodyHandle body = scene.world.handle_at(static_cast<BodyIndex>(i));
      if (word == model.name || (word.size() > model.name.size() && word.starts_with(model.name) &&
                                 word == scene.world.name_of(body))) {
        targets.bodies.push_back(body);
        targets.indices.push_back(i);
      }
    }
    if (!targets.bodies.empty()) return targets;
  }
  name.reject("no body has that name" + did_you_mean(word, known));
}

/// What "bodies" names.
template <class Real, class Backend>
std::vector<Targets> read_targets(const Value& list, const Scene<Real, Backend>& scene) {
  list.list("names of bodies");
  std::vector<Targets> all;
  std::set<std::uint32_t> seen;
  for (std::size_t i = 0; i < list.size(); ++i) {
    all.push_back(find_targets(list.at(i), scene));
    for (const BodyHandle body : all.back().bodies)
      if (!seen.insert(body.slot).second)
        list.at(i).reject("'" + scene.world.name_of(body) + "' is in the list twice");
  }
  return all;
}

/// An effect that means the same to every body: for those that "bodies" names, or for all.
template <class Real, class Backend, class Effect>
void add_for_all(const Object& object, Scene<Real, Backend>& scene, const Effect& effect) {
  const std::string name = object.has("name") ? object["name"].text() : std::string(Effect::name);
  const Named<Effect> named{effect, name};
  std::vector<BodyHandle> bodies;
  if (object.has("bodies"))
    for (const Targets& targets : read_targets(object["bodies"], scene))
      bodies.insert(bodies.end(), targets.bodies.begin(), targets.bodies.end());
  object.value().guarded(
      [&] { return bodies.empty() ? scene.world.add(named) : scene.world.add(named, bodies); });
}

/// An effect that is fixed to a place of the body, which the file gives in the model's axes. Each
/// model has its own body axes, so each gets its own effect.
template <class Real, class Backend, class MakeEffect>
void add_for_each_model(const Object& object, Scene<Real, Backend>& scene,
                        const MakeEffect& effect_for) {
  for (const Targets& targets : read_targets(object["bodies"], scene)) {
    auto effect = effect_for(scene.models[targets.model].model_in_body);
    if (object.has("name")) effect.name = object["name"].text();
    object.value().guarded([&] { return scene.world.add(effect, targets.bodies); });
  }
}

template <class Real>
Spring<Real> read_spring(const Object& object) {
  return {.stiffness = static_cast<Real>(object["stiffness"].not_negative()),
          .damping = static_cast<Real>(object.not_negative("damping", 0)),
          .rest_length = static_cast<Real>(object.not_negative("rest_length", 0)),
          .only_pulls = object.boolean("only_pulls")};
}

/// A point of the model (m) in body axes. The centre of mass of a body without a model stays it, to
/// the bit: there a spring gives no torque.
template <class Real>
Vec3<Real> attachment_in_body(const Object& object, std::string_view key,
                              const Posed& model_in_body) {
  if (!object.has(key)) return Vec3<Real>::Zero();
  return point_outward(model_in_body, object[key].vector()).template cast<Real>();
}

/// The same point in model axes, to draw it.
inline DrawnEnd drawn_end(const Object& object, std::string_view key, const Posed& model_in_body,
                          std::size_t body) {
  return {object.vector(key, inverse(model_in_body).position), body};
}

template <class Real, class Backend>
void read_spring_between(const Object& object, Scene<Real, Backend>& scene) {
  const auto one_body = [&](std::string_view key) {
    Targets targets = find_targets(object[key], scene);
    if (targets.bodies.size() != 1)
      object[key].reject("it stands for " + std::to_string(targets.bodies.size()) +
                         " bodies; a spring has one at either end");
    return targets;
  };
  const Targets first = one_body("first"), second = one_body("second");
  SpringBetween<Real> effect{
      .spring = read_spring<Real>(object),
      .attachment_first = attachment_in_body<Real>(object, "attachment_first",
                                                   scene.models[first.model].model_in_body),
      .attachment_second = attachment_in_body<Real>(object, "attachment_second",
                                                    scene.models[second.model].model_in_body)};
  if (object.has("name")) effect.name = object["name"].text();
  object.value().guarded([&] {
    return scene.world.add(effect, {first.bodies[0], second.bodies[0]});
  });
  const auto end = [&](std::string_view key, const Targets& targets) {
    return drawn_end(object, key, scene.models[targets.model].model_in_body, targets.indices[0]);
  };
  scene.springs.push_back({end("attachment_first", first), end("attachment_second", second)});
}

template <class Real, class Backend>
void read_spring_to_point(const Object& object, Scene<Real, Backend>& scene) {
  const Spring<Real> spring = read_spring<Real>(object);
  const Vec3d anchor = object.vector("anchor");
  add_for_each_model(object, scene, [&](const Posed& model_in_body) {
    return SpringToPoint<Real>{
        .spring = spring,
        .anchor = anchor.cast<Real>(),
        .attachment = attachment_in_body<Real>(object, "attachment", model_in_body)};
  });
  for (const Targets& targets : read_targets(object["bodies"], scene))
    for (const std::size_t body : targets.indices)
      scene.springs.push_back(
          {drawn_end(object, "attachment", scene.models[targets.model].model_in_body, body),
           DrawnEnd{anchor}});
}

/// When something starts and stops, s.
inline std::pair<double, double> read_running(const Object& object) {
  const double from = object.not_negative("from", 0);
  const double forever = std::numeric_limits<double>::infinity();
  const double until = object.has("until") ? object["until"].number() : forever;
  if (until < from)
    object["until"].reject("it must not lie before the start, " + text_of(from) + " s");
  return {from, until};
}

template <class Real, class Backend>
void read_thruster(const Object& object, Scene<Real, Backend>& scene) {
  const auto running = read_running(object);
  const Vec3d force = object.vector("force"), point = object.vector("point");
  scene.switches.insert(scene.switches.end(), {running.first, running.second});
  add_for_each_model(object, scene, [&](const Posed& model_in_body) {
    return Thruster<Real>{
        .force_body = rotate(model_in_body.orientation, force).template cast<Real>(),
        .point = point_outward(model_in_body, point).template cast<Real>(),
        .from = static_cast<Real>(running.first),
        .until = static_cast<Real>(running.second)};
  });
}

template <class Real, class Backend>
void read_reaction_wheel(const Object& object, Scene<Real, Backend>& scene) {
  const auto running = read_running(object);
  const Vec3d direction = object["axis"].vector();
  if (direction == Vec3d::Zero()) object["axis"].reject("it needs a direction");
  // Scaled to about 1 first, so that no square over- or underflows.
  const Vec3d axis = (direction / direction.cwiseAbs().maxCoeff()).normalized();
  const double momentum = object.number("momentum", 0), torque = object.number("torque", 0);
  if (torque != 0) scene.switches.insert(scene.switches.end(), {running.first, running.second});
  add_for_each_model(object, scene, [&](const Posed& model_in_body) {
    return ReactionWheel<Real>{
        .axis = rotate(model_in_body.orientation, axis).template cast<Real>(),
        .momentum = static_cast<Real>(momentum),
        .torque = static_cast<Real>(torque),
        .from = static_cast<Real>(running.first),
        .until = static_cast<Real>(running.second)};
  });
}

/// Reads one element of "effects" and adds it to the world.
template <class Real, class Backend>
void read_effect(const Value& value, Scene<Real, Backend>& scene) {
  const Object object = object_of_kind(value, "effect", "kind", effect_kinds);
  const std::string_view kind = object.kind();
  if (object.has("name")) {
    const std::string name = object["name"].text();
    if (name.empty() || name.size() > longest_name)
      object["name"].reject("a name must have 1 to " + std::to_string(longest_name) + " bytes");
  }
  const auto vector = [&](std::string_view key) -> Vec3<Real> {
    return object.vector(key).template cast<Real>();
  };
  const auto not_negative = [&](std::string_view key, double otherwise = 0) {
    return static_cast<Real>(object.not_negative(key, otherwise));
  };
  const auto add = [&](const auto& effect) { add_for_all(object, scene, effect); };
  if (kind == "gravity") {
    add(Gravity<Real>{vector("acceleration")});
  } else if (kind == "gravity_as_acceleration") {
    add(GravityAsAcceleration<Real>{vector("acceleration")});
  } else if (kind == "point_gravity") {
    add(PointGravity<Real>{not_negative("strength"), vector("centre")});
  } else if (kind == "linear_damping") {
    add(LinearDamping<Real>{not_negative("rate")});
  } else if (kind == "angular_damping") {
    add(AngularDamping<Real>{not_negative("rate")});
  } else if (kind == "quadratic_drag") {
    add(QuadraticDrag<Real>{not_negative("coefficient"), vector("wind")});
  } else if (kind == "magnus") {
    add(Magnus<Real>{static_cast<Real>(object["strength"].number()), vector("wind")});
  } else if (kind == "buoyancy") {
    add(Buoyancy<Real>{not_negative("density"), not_negative("radius"),
                       static_cast<Real>(object.number("surface", 0)),
                       not_negative("gravity", 9.81)});
  } else if (kind == "spring") {
    read_spring_to_point(object, scene);
  } else if (kind == "spring_between") {
    read_spring_between(object, scene);
  } else if (kind == "thruster") {
    read_thruster(object, scene);
  } else {
    read_reaction_wheel(object, scene);
  }
}

}  // namespace tumble
