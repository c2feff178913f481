/// @file
/// The scenes in ODE, the Open Dynamics Engine: bodies without geometry.
#pragma once

#include <ode/ode.h>

#include <cmath>
#include <support/bench/setting.hpp>
#include <vector>

namespace tumble::support::bench {

/// ODE's bodies in one of the scenes that have tops, stepped by its QuickStep.
class OdeWorld {
 public:
  explicit OdeWorld(const Setting& setting)
      : time_step_(real(setting.time_step())), has_torque_(has_torque(setting.scene)) {
    dInitODE2(0);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, has_gravity(setting.scene) ? real(gravity) : 0);
    if (has_damping(setting.scene)) {  // the part of a speed that each step takes, however long
      const dReal lost = real(1 - std::exp(-damping_rate * setting.time_step()));
      dWorldSetDamping(world_, lost, lost);
      dWorldSetLinearDampingThreshold(world_, 0);
      dWorldSetAngularDampingThreshold(world_, 0);
    }
    dMass inertia;
    dMassSetParameters(&inertia, real(mass), 0, 0, 0, real(moments[0]), real(moments[1]),
                       real(moments[2]), 0, 0, 0);
    for (std::size_t n = 0; n < setting.count; ++n) {
      const Start start = start_of(n);
      const dBodyID body = dBodyCreate(world_);
      dBodySetMass(body, &inertia);
      set(body, dBodySetPosition, start.position);
      set(body, dBodySetLinearVel, start.velocity);
      set(body, dBodySetAngularVel, start.angular_velocity);
      dBodySetGyroscopicMode(body, setting.gyroscopic);
      dBodySetAutoDisableFlag(body, 0);
      bodies_.push_back(body);
    }
  }
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;
  ~OdeWorld() {
    dWorldDestroy(world_);
    dCloseODE();
  }

  void run(int steps) {
    for (int step = 0; step < steps; ++step) {
      if (has_torque_)
        for (const dBodyID body : bodies_) set(body, dBodyAddTorque, torque);
      dWorldQuickStep(world_, time_step_);
    }
  }

  Motion motion(std::size_t n) const {
    return {triple_of(dBodyGetPosition(bodies_[n])), triple_of(dBodyGetLinearVel(bodies_[n])),
            triple_of(dBodyGetAngularVel(bodies_[n]))};
  }

 private:
  static constexpr dReal real(double x) { return static_cast<dReal>(x); }
  /// Gives a body three numbers by one of ODE's functions.
  template <class Function>
  static void set(dBodyID body, Function function, const Triple& v) {
    function(body, real(v[0]), real(v[1]), real(v[2]));
  }

  dReal time_step_;
  bool has_torque_;
  dWorldID world_;
  std::vector<dBodyID> bodies_;
};

}  // namespace tumble::support::bench
