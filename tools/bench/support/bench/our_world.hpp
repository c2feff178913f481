/// @file
/// The one place where the benchmark knows our own world: what it is, and how it is asked to step.
#pragma once

#include <support/bench/bare_body.hpp>
#include <support/random_world.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/in_packs.hpp>

namespace tumble::support::bench {

/// Our world in one of the scenes, by default with its bodies in packs.
template <class Real, class Backend = InPacks<Real>>
class OurWorld {
 public:
  static constexpr int most_threads = 2;
  static constexpr std::size_t most_bodies = 1 << 20;  ///< what 1.5 GB hold

  /// Of the rules that keep |L|, and with it every number, within bounds whatever the step: the one
  /// that takes the least time.
  static constexpr SplittingWithoutSine cheapest_stable = {};

  template <class Rule = Splitting>
  explicit OurWorld(const Setting& setting, const Rule& rule = {})
      : world_(steps_per_second(setting.rate), rule) {
    if (!setting.gyroscopic) world_.turn_by(Steady{});
    for (std::size_t n = 0; n < setting.count; ++n) {
      const RigidBody<Real> body = box_number<Real>(n);
      if (has_tops(setting.scene))
        world_.add(body);
      else
        world_.add(body.centre);
    }
    add_effects(setting.scene, vector_of<Real>(torque));
    if constexpr (requires { world_.use_threads(1); }) world_.use_threads(setting.threads);
  }

  void run(int steps) {
    for (int step = 0; step < steps; ++step) world_.step();
  }

  Motion motion(std::size_t n) const {
    const RigidBody<Real> body = world_.body(world_.handle_at(static_cast<BodyIndex>(n)));
    return {triple_of(body.centre.position), triple_of(body.centre.velocity),
            triple_of(angular_velocity_world(body.top))};
  }

  /// The bytes that a step of one body reads and writes where each is touched once: beyond those
  /// of bytes_of_step(), the inverse mass and the sums of forces and torques both ways.
  static constexpr double bytes_of_step(Scene scene) {
    int numbers = has_gravity(scene) || has_damping(scene) ? 12 : 9;
    if (has_gravity(scene) || has_torque(scene)) numbers += 2 * 3 + 1;
    if (has_tops(scene)) numbers += 2 * 7 + 3;
    if (has_torque(scene)) numbers += 2 * 3;
    return numbers * static_cast<double>(sizeof(Real));
  }

 private:
  void add_effects(Scene scene, const Vec3<Real>& on_each) {
    const auto rate = static_cast<Real>(damping_rate);
    if (has_gravity(scene)) world_.add(Gravity<Real>{{0, 0, static_cast<Real>(gravity)}});
    if (has_torque(scene)) world_.add(SteadyTorque<Real>{on_each});
    if (!has_damping(scene)) return;
    world_.add(LinearDamping<Real>{.rate = rate});
    if (has_tops(scene)) world_.add(AngularDamping<Real>{.rate = rate});
  }

  World<Real, Backend> world_;
};

}  // namespace tumble::support::bench
