/// @file
/// The scenes in Bullet, in the two ways in which one can have it step bodies that touch nothing.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <memory>
#include <support/bench/setting.hpp>
#include <vector>

namespace tumble::support::bench {

inline btVector3 bullet_vector(const Triple& v) {
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}

/// Bullet's bodies in one of the scenes that have tops.
class BulletBodies {
 public:
  explicit BulletBodies(const Setting& setting)
      : time_step_(static_cast<btScalar>(setting.time_step())),
        torque_on_each_(has_torque(setting.scene) ? bullet_vector(torque) : btVector3(0, 0, 0)),
        gyroscopic_(setting.gyroscopic) {
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, &shape_,
                                                  bullet_vector(moments));
    // What Bullet calls damping is the part of the speed that is lost in a second.
    if (has_damping(setting.scene))
      info.m_linearDamping = info.m_angularDamping =
          static_cast<btScalar>(1 - std::exp(-damping_rate));
    for (std::size_t n = 0; n < setting.count; ++n) {
      const Start start = start_of(n);
      info.m_startWorldTransform =
          btTransform(btQuaternion::getIdentity(), bullet_vector(start.position));
      auto body = std::make_unique<btRigidBody>(info);
      body->setLinearVelocity(bullet_vector(start.velocity));
      body->setAngularVelocity(bullet_vector(start.angular_velocity));
      body->setActivationState(DISABLE_DEACTIVATION);
      body->setFlags(BT_DISABLE_WORLD_GRAVITY |
                     (gyroscopic_ ? BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY : 0));
      if (has_gravity(setting.scene)) body->setGravity({0, 0, static_cast<btScalar>(gravity)});
      bodies_.push_back(std::move(body));
    }
  }

  Motion motion(std::size_t n) const {
    const btRigidBody& body = *bodies_[n];
    return {triple_of(body.getCenterOfMassPosition()), triple_of(body.getLinearVelocity()),
            triple_of(body.getAngularVelocity())};
  }

 protected:
  btScalar time_step_;
  btVector3 torque_on_each_;
  bool gyroscopic_;
  btSphereShape shape_{1};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

/// Its integration functions, called for each body in the order in which its world calls them. The
/// gyroscopic function answers with the change of the angular velocity.
class BulletFunctions : public BulletBodies {
 public:
  using BulletBodies::BulletBodies;

  void run(int steps) {
    for (int step = 0; step < steps; ++step)
      for (const auto& body : bodies_) this->step(*body);
  }

 private:
  void step(btRigidBody& body) const {
    body.applyGravity();
    body.applyTorque(torque_on_each_);
    body.applyDamping(time_step_);
    if (gyroscopic_) {
      const btVector3 change = body.computeGyroscopicImpulseImplicit_Body(time_step_);
      body.integrateVelocities(time_step_);
      body.setAngularVelocity(body.getAngularVelocity() + change);
    } else {
      body.integrateVelocities(time_step_);
    }
    btTransform there;
    body.predictIntegratedTransform(time_step_, there);
    body.proceedToTransform(there);
    body.clearForces();
  }
};

/// Its whole world, without the search for collisions.
class BulletWorld : public BulletBodies {
 public:
  explicit BulletWorld(const Setting& setting) : BulletBodies(setting) {
    for (const auto& body : bodies_) world_.addRigidBody(body.get(), 0, 0);
  }

  void run(int steps) {
    for (int step = 0; step < steps; ++step) {
      for (const auto& body : bodies_) body->applyTorque(torque_on_each_);
      world_.stepSimulation(time_step_, 0);  // 0: one step, of just this length
    }
  }

 private:
  class WithoutCollisions : public btDiscreteDynamicsWorld {
   public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
    void performDiscreteCollisionDetection() override {}
  };

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  WithoutCollisions world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

}  // namespace tumble::support::bench
