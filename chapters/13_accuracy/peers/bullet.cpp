#include <btBulletDynamicsCommon.h>

#include <memory>
#include <peers/world_axes.hpp>

namespace peers {
namespace {

btVector3 vector_of(const Triple& v) {
  return {v[0], v[1], v[2]};
}

/// A body needs a shape, though it touches nothing.
struct Body {
  explicit Body(const Triple& i)
      : body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape,
                                                      {1 / i[0], 1 / i[1], 1 / i[2]})) {}
  btSphereShape shape{1};
  btRigidBody body;
};

/// Its integration functions, called in the order in which its world calls them.
//! [bullet]
void step(btRigidBody& body, const TopProblem& problem, double time, double time_step) {
  if (problem.torque != Torque::none) {
    const btVector3 axis = body.getWorldTransform().getBasis().getColumn(2);
    body.applyTorque(vector_of(torque_on(problem, {axis.x(), axis.y(), axis.z()}, time)));
  }
  const btVector3 change = body.computeGyroscopicImpulseImplicit_Body(time_step);
  body.integrateVelocities(time_step);
  body.setAngularVelocity(body.getAngularVelocity() + change);
  btTransform there;
  body.predictIntegratedTransform(time_step, there);
  body.proceedToTransform(there);
  body.clearForces();
}
//! [bullet]

}  // namespace

std::vector<Peer<TopState>> bullet_on_top(const TopProblem& problem) {
  const auto own = std::make_shared<Body>(problem.inverse_moments);
  return {{"functions", false, [=](double knob) {
             btRigidBody& body = own->body;
             const auto [w, x, y, z] = orientation_of(problem.start);
             body.setCenterOfMassTransform(btTransform(btQuaternion(x, y, z, w)));
             body.setAngularVelocity(vector_of(angular_velocity_of(problem)));
             const double h = problem.seconds / knob;
             for (long n = 0; n < static_cast<long>(knob); ++n)
               step(body, problem, static_cast<double>(n) * h, h);
             const btQuaternion q = body.getOrientation();
             const btVector3& velocity = body.getAngularVelocity();
             return state_of(problem, {q.w(), q.x(), q.y(), q.z()},
                             {velocity.x(), velocity.y(), velocity.z()});
           }}};
}

}  // namespace peers
