#include <Simbody.h>

#include <limits>
#include <memory>
#include <peers/world_axes.hpp>

namespace peers {
namespace {

/// The problem's torque, as a force element of one's own.
class TorqueOnBody : public SimTK::Force::Custom::Implementation {
 public:
  TorqueOnBody(const TopProblem& problem, const SimTK::MobilizedBody& body)
      : problem_(problem), body_(body) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const override {
    const SimTK::UnitVec3& axis = body_.getBodyRotation(state).z();
    const Triple torque = torque_on(problem_, {axis[0], axis[1], axis[2]}, state.getTime());
    body_.applyBodyTorque(state, {torque[0], torque[1], torque[2]}, body_forces);
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }
  bool dependsOnlyOnPositions() const override { return problem_.torque != Torque::drive; }

 private:
  TopProblem problem_;
  SimTK::MobilizedBody body_;
};

/// One body on a ball joint, which leaves it all turns and no place to go.
struct System {
  explicit System(const TopProblem& problem) : matter(system), forces(system) {
    const auto& i = problem.inverse_moments;
    const SimTK::Body::Rigid top(
        SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(1 / i[0], 1 / i[1], 1 / i[2])));
    body = SimTK::MobilizedBody::Ball(matter.Ground(), top);
    if (problem.torque != Torque::none)
      SimTK::Force::Custom(forces, new TorqueOnBody(problem, body));  // which takes it over
    start = system.realizeTopology();
    const auto [w, x, y, z] = orientation_of(problem.start);
    const Triple velocity = angular_velocity_of(problem);
    body.setQToFitRotation(start, SimTK::Rotation(SimTK::Quaternion(w, x, y, z)));
    body.setUToFitAngularVelocity(start, {velocity[0], velocity[1], velocity[2]});
  }
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  SimTK::MobilizedBody::Ball body;
  SimTK::State start;
};

/// To the end, which is a step's end too. NaN where Simbody gives up: its steps find no tolerance,
/// or have led to what is no state.
//! [simbody]
TopState run(SimTK::Integrator& integrator, const System& own, const TopProblem& problem) {
  try {
    integrator.setFinalTime(problem.seconds);
    SimTK::TimeStepper stepper(own.system, integrator);
    stepper.initialize(own.start);
    stepper.stepTo(problem.seconds);
    const SimTK::State& end = integrator.getState();
    own.system.realize(end, SimTK::Stage::Velocity);
    const SimTK::Quaternion q = own.body.getBodyRotation(end).convertRotationToQuaternion();
    const SimTK::Vec3 velocity = own.body.getBodyAngularVelocity(end);
    return state_of(problem, {q[0], q[1], q[2], q[3]}, {velocity[0], velocity[1], velocity[2]});
  } catch (const std::exception&) {
    TopState state;
    state.fill(std::numeric_limits<double>::quiet_NaN());
    return state;
  }
}
//! [simbody]

template <class Integrator>
Peer<TopState> fixed(const char* name, const std::shared_ptr<const System>& own,
                     const TopProblem& problem) {
  return {name, false, [=](double knob) {
            Integrator integrator(own->system);
            integrator.setFixedStepSize(problem.seconds / knob);
            return run(integrator, *own, problem);
          }};
}

template <class Integrator>
Peer<TopState> controlled(const char* name, const std::shared_ptr<const System>& own,
                          const TopProblem& problem) {
  return {name, true, [=](double knob) {
            Integrator integrator(own->system);
            integrator.setAccuracy(knob);
            return run(integrator, *own, problem);
          }};
}

}  // namespace

std::vector<Peer<TopState>> simbody_on_top(const TopProblem& problem) {
  using namespace SimTK;
  const auto own = std::make_shared<const System>(problem);
  return {fixed<VerletIntegrator>("Verlet", own, problem),
          fixed<RungeKuttaMersonIntegrator>("Merson", own, problem),
          controlled<VerletIntegrator>("Verlet, controlled", own, problem),
          controlled<RungeKuttaMersonIntegrator>("Merson, controlled", own, problem),
          controlled<RungeKuttaFeldbergIntegrator>("Fehlberg, controlled", own, problem),
          controlled<CPodesIntegrator>("CPodes", own, problem)};
}

}  // namespace peers
