/// @file
/// Worlds that nobody would think of, and what happens to them.
#pragma once

#include <cmath>
#include <support/random_generator.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

namespace tumble::support {

/// A torque that is the same for all bodies and at all times.
template <class Real>
struct SteadyTorque {
  static constexpr std::string_view name = "steady torque";
  static constexpr Quantities reads = quantity::none;
  Vec3<Real> steady = Vec3<Real>::Zero();  ///< N m, world axes
  Vec3<Real> torque(const Top<Real>&, Real) const { return steady; }
  template <class Wide>
  SteadyTorque<Wide> broadcast() const {
    return {steady.template cast<Wide>()};
  }
};

/// A body of any kind: point, box, ball, rod, static; at rest or not.
template <class Real, class Backend>
BodyHandle add_random_body(World<Real, Backend>& world, RandomGenerator& dice,
                           const std::string& name) {
  const Vec3<Real> place = 3 * dice.vector<Real>();
  const Vec3<Real> velocity = dice.one_in(2) ? dice.vector<Real>() : Vec3<Real>(0, 0, 0);
  const Vec3<Real> spin =
      dice.one_in(2) ? Vec3<Real>(5 * dice.vector<Real>()) : Vec3<Real>(0, 0, 0);
  const Vec3<Real> size = Vec3<Real>(2, 2, 2) + dice.vector<Real>();
  const Quaternion<Real> turn = quaternion_of_rotation_vector<Real>(3 * dice.vector<Real>());
  switch (dice.below(6)) {
    case 0:
      return world.add(name, make_particle<Real>(Real(1.5), place, velocity));
    case 1:
      return world.add(name, make_static_particle(place));
    case 2:
      return world.add(name, make_static_body<Real>(name, {place, turn}));
    case 3:
      return world.add(name, make_rigid_body<Real>(name, mass_properties(Sphere<Real>{size.x()}, 2),
                                                   {place, turn}, velocity, spin)
                                 .body);
    case 4:
      return world.add(
          name, make_rigid_body<Real>(name, mass_properties(Box<Real>{size}, 2), {place, turn},
                                      velocity, Vec3<Real>::Zero(), Turning::locked)
                    .body);
    default:
      return world.add(name, make_rigid_body<Real>(name, mass_properties(Box<Real>{size}, 2),
                                                   {place, turn}, velocity, spin)
                                 .body);
  }
}

/// Adds one effect of any kind to all or to some; sometimes one that does nothing.
template <class Real, class Backend>
void add_random_effect(World<Real, Backend>& world, RandomGenerator& dice,
                       const std::vector<BodyHandle>& bodies) {
  const Real amount = dice.one_in(4) ? 0 : Real(0.5) + dice.real<Real>() / 4;
  const Vec3<Real> direction = dice.one_in(3) ? Vec3<Real>(0, 0, 0) : dice.vector<Real>();
  const std::vector<BodyHandle> some = {bodies[dice.below(bodies.size())]};
  const bool has_top = !world.is_point(some[0]);
  const Vec3<Real> place = has_top ? direction : Vec3<Real>(0, 0, 0);
  const auto add = [&](const auto& effect) {
    if (dice.one_in(2))
      world.add(effect);
    else
      world.add(effect, some);
  };
  switch (dice.below(11)) {
    case 0:
      return add(Gravity<Real>{.gravity = direction});
    case 1:
      return add(GravityAsAcceleration<Real>{.gravity = direction});
    case 2:
      return add(PointGravity<Real>{.strength = amount, .centre = {9, 9, 9}});
    case 3:
      return add(LinearDamping<Real>{.rate = amount});
    case 4:
      if (!has_top) return;
      return add(AngularDamping<Real>{.rate = amount});
    case 9:
      if (!has_top) return;
      return add(SteadyTorque<Real>{amount * direction});
    case 5:
      return add(QuadraticDrag<Real>{.coefficient = amount / 8, .wind = direction});
    case 6:
      return add(Magnus<Real>{.strength = amount / 8, .wind = direction});
    case 7:
      return add(Buoyancy<Real>{.density = amount, .radius = Real(0.5)});
    case 8:
      world.add(SpringToPoint<Real>{.spring = {.stiffness = 9 * amount, .damping = amount},
                                    .anchor = direction,
                                    .attachment = place},
                some);
      return;
    default:
      if (has_top)
        world.add(Thruster<Real>{.force_body = direction, .point = {0, 0, amount}}, some);
      if (bodies.size() > 1 && bodies[0] != some[0])
        world.add(SpringBetween<Real>{.spring = {.stiffness = 9 * amount, .rest_length = 1},
                                      .attachment_first = place},
                  {some[0], bodies[0]});
  }
}

inline Scheme random_scheme(RandomGenerator& dice) {
  return Scheme(dice.below(scheme_names.size()));
}

template <class Real, class Backend = OneByOne<Real>>
World<Real, Backend> random_world(RandomGenerator& dice, std::size_t most_bodies = 5) {
  using Rules = TurningRules<Splitting, SplittingWithoutSine, AxisByAxis, CarryingMomentum, Steady,
                             ImplicitNewton>;
  World<Real, Backend> world(steps_per_second(60));
  Rules::choose(world, dice.below(6));
  world.step_by(random_scheme(dice));
  std::vector<BodyHandle> bodies;
  for (std::size_t n = 0, count = 1 + dice.below(most_bodies); n < count; ++n)
    bodies.push_back(add_random_body(world, dice, "body " + std::to_string(n)));
  for (std::size_t n = 0, count = dice.below(6); n < count; ++n)
    add_random_effect(world, dice, bodies);
  return world;
}

/// Does something to a world while it runs. Two worlds with equal dice fare alike.
template <class Real, class Backend>
void meddle(World<Real, Backend>& world, RandomGenerator& dice, int number) {
  if (world.body_count() == 0) return;
  const BodyHandle body = world.handle_at(static_cast<BodyIndex>(dice.below(world.body_count())));
  const bool has_top = !world.is_point(body);
  switch (dice.below(8)) {
    case 7:
      return world.step_by(random_scheme(dice));
    case 0:
      return world.set_velocity(body, dice.vector<Real>());
    case 1:
      return world.apply_impulse_at(body, dice.vector<Real>(), dice.vector<Real>());
    case 2:
      if (has_top) world.set_orientation(body, Quaternion<Real>{});
      return;
    case 3:
      return world.remove(body);
    case 4:
      add_random_body(world, dice, "new " + std::to_string(number));
      return;
    case 5:
      return add_random_effect(world, dice, {body});
    default:
      if (!world.effects().empty())
        world.remove(world.effects()[dice.below(world.effects().size())].handle);
  }
}

/// True when both numbers have the same bits; none of them is NaN here.
template <class Real>
bool same_number(Real x, Real y) {
  return x == y && std::signbit(x) == std::signbit(y);
}

template <class Real>
bool same_vector(const Vec3<Real>& x, const Vec3<Real>& y) {
  return same_number(x.x(), y.x()) && same_number(x.y(), y.y()) && same_number(x.z(), y.z());
}

/// True when every number of the bodies' motion has the same bits.
template <class Real>
bool same_motion(const Bodies<Real>& a, const Bodies<Real>& b) {
  if (a.centres.size() != b.centres.size() || a.tops.size() != b.tops.size()) return false;
  for (std::size_t i = 0; i < a.centres.size(); ++i)
    if (!same_vector(a.centres[i].position, b.centres[i].position) ||
        !same_vector(a.centres[i].velocity, b.centres[i].velocity))
      return false;
  for (std::size_t i = 0; i < a.tops.size(); ++i)
    if (!same_vector(a.tops[i].angular_momentum_body, b.tops[i].angular_momentum_body) ||
        !same_vector(a.tops[i].orientation.imaginary, b.tops[i].orientation.imaginary) ||
        !same_number(a.tops[i].orientation.real, b.tops[i].orientation.real))
      return false;
  return true;
}

}  // namespace tumble::support

#ifdef TUMBLE_COMPILED_RANDOM_WORLDS
// Every kind of body and effect: they are compiled once for all checks, see support/random_worlds.
namespace tumble {
extern template World<float> support::random_world(support::RandomGenerator&, std::size_t);
extern template World<double> support::random_world(support::RandomGenerator&, std::size_t);
extern template void support::meddle(World<float>&, support::RandomGenerator&, int);
extern template void support::meddle(World<double>&, support::RandomGenerator&, int);
extern template BodyHandle support::add_random_body(World<float>&, support::RandomGenerator&,
                                                    const std::string&);
extern template BodyHandle support::add_random_body(World<double>&, support::RandomGenerator&,
                                                    const std::string&);
extern template void support::add_random_effect(World<float>&, support::RandomGenerator&,
                                                const std::vector<BodyHandle>&);
extern template void support::add_random_effect(World<double>&, support::RandomGenerator&,
                                                const std::vector<BodyHandle>&);
}  // namespace tumble
#endif
