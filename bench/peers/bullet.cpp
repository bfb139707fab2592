#include "bench/engine.h"

#include <LinearMath/btConvexHullComputer.h>
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
        for (const auto& joint : joints_) world_.removeConstraint(joint.get());
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }

    void build(const Scene& scene, const EngineSettings& settings) override {
        substeps_ = settings.substeps > 0 ? settings.substeps : 1;
        world_.setGravity(to_bullet(scene.gravity));
        bodies_.reserve(scene.bodies.size());
        for (const ConvexHull& hull : scene.hulls) hulls_.push_back(make_hull(hull));
        for (const SurfaceMesh& mesh : scene.meshes) meshes_.push_back(std::make_unique<Surface>(mesh));
        for (const SceneBody& body : scene.bodies) add_body(scene, body);
        for (const SceneJoint& joint : scene.joints) add_joint(joint);
    }

    void step(float time_step) override {
        const float h = time_step / static_cast<float>(substeps_);
        for (int i = 0; i < substeps_; ++i) {
            for (const Driven& driven : driven_) drive(driven, h);
            world_.stepSimulation(h, 0); // 0: one step of length h, not of a fixed length
        }
    }

    void read(std::vector<BodyState>& states) const override {
        states.resize(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const btRigidBody& body = *bodies_[i];
            const btTransform pose = body.getCenterOfMassTransform() * to_origin_[i];
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
    // A kinematic body, which the caller must move.
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

    // A shape that refers to the scene's own arrays.
    struct Surface {
        explicit Surface(const SurfaceMesh& mesh)
            : arrays(static_cast<int>(mesh.indices.size() / 3), indices_of(mesh), 3 * sizeof(std::uint32_t),
                     static_cast<int>(mesh.vertices.size()), coordinates_of(mesh), sizeof(Vec3)),
              shape(&arrays, true) {
            shape.setMargin(0); // no margin for the triangles; bodies keep theirs
        }
        // Bullet's interface takes pointers to non-const data, but does not modify them.
        static int* indices_of(const SurfaceMesh& mesh) {
            return reinterpret_cast<int*>(const_cast<std::uint32_t*>(mesh.indices.data()));
        }
        static btScalar* coordinates_of(const SurfaceMesh& mesh) {
            static_assert(sizeof(btScalar) == sizeof(float));
            return const_cast<float*>(&mesh.vertices[0].x);
        }
        btTriangleIndexVertexArray arrays;
        btBvhTriangleMeshShape shape;
    };

    // Bullet adds its margin around the points of a hull. The faces are therefore moved inwards by the margin first, so
    // that they end up at the right positions; the edges become rounded.
    static std::unique_ptr<btConvexHullShape> make_hull(const ConvexHull& hull) {
        btConvexHullComputer inset;
        inset.compute(&hull.points[0].x, int{sizeof(Vec3)}, static_cast<int>(hull.points.size()),
                      CONVEX_DISTANCE_MARGIN, 0);
        auto shape = std::make_unique<btConvexHullShape>();
        for (int i = 0; i < inset.vertices.size(); ++i) shape->addPoint(inset.vertices[i], false);
        shape->recalcLocalAabb();
        return shape;
    }

    btCollisionShape* make_shape(const Part& part) {
        switch (part.shape) {
        case PartShape::sphere:
            shapes_.push_back(std::make_unique<btSphereShape>(part.radius));
            break;
        case PartShape::box:
            shapes_.push_back(std::make_unique<btBoxShape>(to_bullet(part.half_extents)));
            break;
        case PartShape::capsule:
            shapes_.push_back(std::make_unique<btCapsuleShape>(part.radius, 2 * part.half_height));
            break;
        case PartShape::cylinder:
            shapes_.push_back(std::make_unique<btCylinderShape>(btVector3(part.radius, part.half_height, part.radius)));
            break;
        case PartShape::hull:
            return hulls_[part.index].get();
        case PartShape::mesh:
            return &meshes_[part.index]->shape;
        }
        return shapes_.back().get();
    }

    // `to_origin`: the transform from Bullet's frame of the body (center of mass, principal axes) to the scene's body
    // frame.
    btCollisionShape* make_shapes(const Scene& scene, const SceneBody& body, const btTransform& to_origin) {
        const Part& first = scene.parts[body.first_part];
        const btTransform first_at = to_origin * btTransform(to_bullet(first.rotation), to_bullet(first.position));
        if (body.part_count == 1 && first_at == btTransform::getIdentity()) return make_shape(first);
        auto compound = std::make_unique<btCompoundShape>();
        for (std::size_t i = 0; i < body.part_count; ++i) {
            const Part& part = scene.parts[body.first_part + i];
            compound->addChildShape(to_origin * btTransform(to_bullet(part.rotation), to_bullet(part.position)),
                                    make_shape(part));
        }
        shapes_.push_back(std::move(compound));
        return shapes_.back().get();
    }

    void add_body(const Scene& scene, const SceneBody& body) {
        btVector3 inertia(0, 0, 0);
        btTransform principal = btTransform::getIdentity();
        if (body.motion == Motion::dynamic) {
            const Mat3& i = body.inertia; // symmetric
            btMatrix3x3 tensor(i[0][0], i[0][1], i[0][2], i[1][0], i[1][1], i[1][2], i[2][0], i[2][1], i[2][2]);
            tensor.diagonalize(principal.getBasis(), btScalar(1e-6), 50);
            principal.setOrigin(to_bullet(body.center_of_mass));
            inertia = btVector3(tensor[0][0], tensor[1][1], tensor[2][2]);
        }
        to_origin_.push_back(principal.inverse());
        btCollisionShape* shape = make_shapes(scene, body, to_origin_.back());
        motions_.push_back(std::make_unique<btDefaultMotionState>(
            btTransform(to_bullet(body.rotation), to_bullet(body.position)) * principal));
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
        if (scene.collides)
            world_.addRigidBody(made); // with Bullet's default groups, static bodies do not collide with each other
        else
            world_.addRigidBody(made, btBroadphaseProxy::DefaultFilter, 0);
    }

    // Bullet's hinges rotate about their z axis, and have the opposite sign of the angle.
    std::unique_ptr<btTypedConstraint> make_hinge(const SceneJoint& joint, const btTransform& at_a,
                                                  const btTransform& at_b) {
        const btTransform z_to_x(btQuaternion(btVector3(0, 1, 0), SIMD_HALF_PI));
        auto hinge = std::make_unique<btHingeConstraint>(*bodies_[joint.body_a], *bodies_[joint.body_b], at_a * z_to_x,
                                                         at_b * z_to_x);
        if (joint.angle) hinge->setLimit(-joint.angle->upper, -joint.angle->lower);
        return hinge;
    }

    void add_joint(const SceneJoint& joint) {
        const btTransform at_a =
            to_origin_[joint.body_a] * btTransform(to_bullet(joint.axes_a), to_bullet(joint.anchor_a));
        const btTransform at_b =
            to_origin_[joint.body_b] * btTransform(to_bullet(joint.axes_b), to_bullet(joint.anchor_b));
        btRigidBody &a = *bodies_[joint.body_a], &b = *bodies_[joint.body_b];
        if (joint.kind == JointKind::hinge) {
            joints_.push_back(make_hinge(joint, at_a, at_b));
        } else if (joint.reach) {
            auto ball = std::make_unique<btConeTwistConstraint>(a, b, at_a, at_b);
            ball->setLimit(joint.reach->swing, joint.reach->swing, joint.reach->twist);
            joints_.push_back(std::move(ball));
        } else {
            joints_.push_back(std::make_unique<btPoint2PointConstraint>(a, b, at_a.getOrigin(), at_b.getOrigin()));
        }
        world_.addConstraint(joints_.back().get(), true); // the two bodies do not collide with each other
    }

    int substeps_ = 1;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btDefaultMotionState>> motions_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
    std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
    std::vector<std::unique_ptr<Surface>> meshes_;
    std::vector<btTransform> to_origin_; // one for every body
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
