#include <ode/ode.h>

#include <memory>
#include <peers/world_axes.hpp>

namespace peers {
namespace {

/// A world with one body and nothing else.
struct World {
  explicit World(const TopProblem& problem) {
    dInitODE2(0);
    world = dWorldCreate();
    body = dBodyCreate(world);
    const auto& i = problem.inverse_moments;
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, 1 / i[0], 1 / i[1], 1 / i[2], 0, 0, 0);
    dBodySetMass(body, &mass);
    dBodySetAutoDisableFlag(body, 0);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() {
    dWorldDestroy(world);
    dCloseODE();
  }
  dWorldID world;
  dBodyID body;
};

//! [ode]
TopState run(const World& own, const TopProblem& problem, long steps) {
  const double h = problem.seconds / static_cast<double>(steps);
  for (long n = 0; n < steps; ++n) {
    if (problem.torque != Torque::none) {
      const dReal* R = dBodyGetRotation(own.body);  // three rows of four numbers
      const Triple torque = torque_on(problem, {R[2], R[6], R[10]}, static_cast<double>(n) * h);
      dBodyAddTorque(own.body, torque[0], torque[1], torque[2]);
    }
    dWorldQuickStep(own.world, h);
  }
  //! [ode]
  const dReal *q = dBodyGetQuaternion(own.body), *velocity = dBodyGetAngularVel(own.body);
  return state_of(problem, {q[0], q[1], q[2], q[3]}, {velocity[0], velocity[1], velocity[2]});
}

}  // namespace

std::vector<Peer<TopState>> ode_on_top(const TopProblem& problem) {
  const auto own = std::make_shared<const World>(problem);
  const auto peer = [=](const char* name, int finite_rotation) -> Peer<TopState> {
    return {name, false, [=](double knob) {
              const auto q = orientation_of(problem.start);
              const Triple velocity = angular_velocity_of(problem);
              dBodySetFiniteRotationMode(own->body, finite_rotation);
              dBodySetQuaternion(own->body, q.data());
              dBodySetAngularVel(own->body, velocity[0], velocity[1], velocity[2]);
              return run(*own, problem, static_cast<long>(knob));
            }};
  };
  return {peer("QuickStep", 0), peer("QuickStep, finite rotation", 1)};
}

}  // namespace peers
