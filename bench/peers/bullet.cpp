#include "bench/engine.h"

#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace cairn::bench {

namespace {

btVector3 to_bullet(const Vec3& v) { return btVector3(v.x, v.y, v.z); }
btQuaternion to_bullet(const Quat& q) { return btQuaternion(q.x, q.y, q.z, q.w); }
Vec3 from_bullet(const btVector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

class BulletEngine final : public Engine {
  public:
    ~BulletEngine() override {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }

    void build(const Scene& scene, const EngineSettings& settings) override {
        substeps_ = settings.substeps > 0 ? settings.substeps : 1;
        world_.setGravity(to_bullet(scene.gravity));
        bodies_.reserve(scene.bodies.size());
        for (const SceneBody& body : scene.bodies) add_body(scene, body);
    }

    void step(float time_step) override {
        const float h = time_step / static_cast<float>(substeps_);
        for (int i = 0; i < substeps_; ++i) {
            for (const Driven& driven : driven_) drive(driven, h);
            world_.stepSimulation(h, 0); // 0: one step of h, not of a fixed length
        }
    }

    void read(std::vector<BodyState>& states) const override {
        states.resize(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const btRigidBody& body = *bodies_[i];
            const btTransform& pose = body.getCenterOfMassTransform();
            const btQuaternion q = pose.getRotation();
            states[i].position = Position(pose.getOrigin().x(), pose.getOrigin().y(), pose.getOrigin().z());
            states[i].rotation = Quat(static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
                                      static_cast<float>(q.z()));
            states[i].linear_velocity = from_bullet(body.getLinearVelocity());
            states[i].angular_velocity = from_bullet(body.getAngularVelocity());
        }
    }

    StepCounts counts() const override {
        StepCounts counts;
        const int manifolds = dispatcher_.getNumManifolds();
        counts.candidates = static_cast<std::size_t>(pairs_.getOverlappingPairCache()->getNumOverlappingPairs());
        counts.substeps = substeps_;
        for (int i = 0; i < manifolds; ++i) {
            const int points = dispatcher_.getManifoldByIndexInternal(i)->getNumContacts();
            counts.contacts += points > 0;
            counts.points += static_cast<std::size_t>(points);
        }
        return counts;
    }

  private:
    // A kinematic body, moved by the caller.
    struct Driven {
        btRigidBody* body;
        btVector3 linear_velocity, angular_velocity;
    };

    static void drive(const Driven& driven, float h) {
        btTransform pose;
        driven.body->getMotionState()->getWorldTransform(pose);
        pose.setOrigin(pose.getOrigin() + h * driven.linear_velocity);
        const btScalar speed = driven.angular_velocity.length();
        if (speed > 0) {
            const btQuaternion turn(driven.angular_velocity / speed, speed * h);
            pose.setRotation((turn * pose.getRotation()).normalized());
        }
        driven.body->getMotionState()->setWorldTransform(pose);
    }

    btCollisionShape* make_shape(const Part& part) {
        if (part.shape == PartShape::sphere)
            shapes_.push_back(std::make_unique<btSphereShape>(part.radius));
        else
            shapes_.push_back(std::make_unique<btBoxShape>(to_bullet(part.half_extents)));
        return shapes_.back().get();
    }

    btCollisionShape* make_shapes(const Scene& scene, const SceneBody& body) {
        if (body.part_count == 1) return make_shape(scene.parts[body.first_part]);
        auto compound = std::make_unique<btCompoundShape>();
        for (std::size_t i = 0; i < body.part_count; ++i) {
            const Part& part = scene.parts[body.first_part + i];
            compound->addChildShape(btTransform(to_bullet(part.rotation), to_bullet(part.position)), make_shape(part));
        }
        shapes_.push_back(std::move(compound));
        return shapes_.back().get();
    }

    void add_body(const Scene& scene, const SceneBody& body) {
        btCollisionShape* shape = make_shapes(scene, body);
        btVector3 inertia(0, 0, 0);
        if (body.motion == Motion::dynamic) shape->calculateLocalInertia(body.mass, inertia);
        motions_.push_back(
            std::make_unique<btDefaultMotionState>(btTransform(to_bullet(body.rotation), to_bullet(body.position))));
        btRigidBody::btRigidBodyConstructionInfo info(body.mass, motions_.back().get(), shape, inertia);
        info.m_friction = std::sqrt(scene.friction); // Bullet multiplies the coefficients of a pair
        info.m_restitution = std::sqrt(scene.restitution);
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody* made = bodies_.back().get();
        made->setActivationState(DISABLE_DEACTIVATION);
        made->setLinearVelocity(to_bullet(body.linear_velocity));
        made->setAngularVelocity(to_bullet(body.angular_velocity));
        if (body.motion == Motion::kinematic) {
            made->setCollisionFlags(made->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
            driven_.push_back({made, to_bullet(body.linear_velocity), to_bullet(body.angular_velocity)});
        }
        world_.addRigidBody(made); // in Bullet's own groups, so that what is static does not meet what is static
    }

    int substeps_ = 1;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btDefaultMotionState>> motions_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<Driven> driven_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase pairs_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &pairs_, &solver_, &configuration_};
};

} // namespace

EngineKind bullet_engine() {
    return {"bullet", CAIRN_BENCH_BULLET, [] { return std::unique_ptr<Engine>(std::make_unique<BulletEngine>()); }};
}

} // namespace cairn::bench
