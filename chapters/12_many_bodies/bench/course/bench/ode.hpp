/// @file
/// The scenes in ODE, the Open Dynamics Engine: bodies without geometry.
#pragma once

#include <ode/ode.h>

#include <cmath>
#include <course/bench/setting.hpp>
#include <vector>

namespace tumble::course::bench {

/// ODE's bodies in one of the scenes that have tops, stepped by its QuickStep.
class OdeWorld {
 public:
  explicit OdeWorld(const Setting& setting)
      : time_step_(setting.time_step()), has_torque_(has_torque(setting.scene)) {
    dInitODE2(0);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, has_gravity(setting.scene) ? gravity : 0);
    if (has_damping(setting.scene)) {  // the part of a speed that each step takes, however long
      const double lost = 1 - std::exp(-damping_rate * time_step_);
      dWorldSetDamping(world_, lost, lost);
      dWorldSetLinearDampingThreshold(world_, 0);
      dWorldSetAngularDampingThreshold(world_, 0);
    }
    dMass inertia;
    dMassSetParameters(&inertia, mass, 0, 0, 0, moments[0], moments[1], moments[2], 0, 0, 0);
    for (std::size_t n = 0; n < setting.count; ++n) {
      const Start start = start_of(n);
      const dBodyID body = dBodyCreate(world_);
      dBodySetMass(body, &inertia);
      dBodySetPosition(body, start.position[0], start.position[1], start.position[2]);
      dBodySetLinearVel(body, start.velocity[0], start.velocity[1], start.velocity[2]);
      const Triple& spin = start.angular_velocity;
      dBodySetAngularVel(body, spin[0], spin[1], spin[2]);
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

  //! [ode]
  void run(int steps) {
    for (int step = 0; step < steps; ++step) {
      if (has_torque_)
        for (const dBodyID body : bodies_) dBodyAddTorque(body, torque[0], torque[1], torque[2]);
      dWorldQuickStep(world_, time_step_);
    }
  }
  //! [ode]

  Motion motion(std::size_t n) const {
    return {triple_of(dBodyGetPosition(bodies_[n])), triple_of(dBodyGetLinearVel(bodies_[n])),
            triple_of(dBodyGetAngularVel(bodies_[n]))};
  }

 private:
  double time_step_;
  bool has_torque_;
  dWorldID world_;
  std::vector<dBodyID> bodies_;
};

}  // namespace tumble::course::bench
