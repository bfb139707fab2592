// ODE with QuickStep, its iterative solver, at its default settings.
#include "bench/engine.h"
#include "bench/rotate.h"

#include <ode/ode.h>

#include <cmath>

namespace cairn::bench {

namespace {

// Initializes the library while any engine uses it.
class Library {
  public:
    Library() {
        dInitODE2(0);
        dAllocateODEDataForThread(dAllocateMaskAll);
    }
    ~Library() { dCloseODE(); }
};

Vec3 from_ode(const dReal* v) { return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])}; }

struct Rotation {
    explicit Rotation(const Quat& r) : q{r.w, r.x, r.y, r.z} {}
    dQuaternion q;
};

class OdeEngine final : public Engine {
  public:
    OdeEngine() { dWorldSetAutoDisableFlag(world_, 0); }
    ~OdeEngine() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_); // including all geometries in it
        dWorldDestroy(world_);
    }
    OdeEngine(const OdeEngine&) = delete;
    OdeEngine& operator=(const OdeEngine&) = delete;

    void build(const Scene& scene, const EngineSettings& settings) override {
        substeps_ = settings.substeps > 0 ? settings.substeps : 1;
        friction_ = scene.friction;
        restitution_ = scene.restitution;
        dWorldSetGravity(world_, scene.gravity.x, scene.gravity.y, scene.gravity.z);
        for (const ConvexHull& hull : scene.hulls) hulls_.emplace_back(hull);
        for (const SurfaceMesh& mesh : scene.meshes) meshes_.push_back(std::make_unique<Surface>(mesh));
        for (const SceneBody& body : scene.bodies) add_body(scene, body);
        for (const SceneJoint& joint : scene.joints) add_joint(scene, joint);
    }

    void step(float time_step) override {
        for (int i = 0; i < substeps_; ++i) {
            counts_ = {};
            dSpaceCollide(space_, this,
                          [](void* engine, dGeomID a, dGeomID b) { static_cast<OdeEngine*>(engine)->collide(a, b); });
            dWorldQuickStep(world_, time_step / static_cast<float>(substeps_));
            dJointGroupEmpty(contacts_);
        }
        counts_.substeps = substeps_;
    }

    void read(std::vector<BodyState>& states) const override {
        states = states_at_start_; // static bodies keep their initial states
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!bodies_[i]) continue;
            const dReal *p = dBodyGetPosition(bodies_[i]), *q = dBodyGetQuaternion(bodies_[i]);
            states[i].rotation = Quat(static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]),
                                      static_cast<float>(q[3]));
            states[i].position = Position(p[0], p[1], p[2]) - rotate(states[i].rotation, Position(centers_of_mass_[i]));
            states[i].linear_velocity = from_ode(dBodyGetLinearVel(bodies_[i]));
            states[i].angular_velocity = from_ode(dBodyGetAngularVel(bodies_[i]));
        }
    }

    StepCounts counts() const override { return counts_; }

  private:
    // A hull in the form that ODE reads; ODE keeps references to these arrays.
    struct Polyhedron {
        explicit Polyhedron(const ConvexHull& hull) {
            for (const Vec3& point : hull.points)
                for (int i = 0; i < 3; ++i) points.push_back(point[i]);
            for (const auto& [a, b, c] : hull.triangles) {
                const Position origin(hull.points[a]);
                const Position normal =
                    glm::normalize(glm::cross(Position(hull.points[b]) - origin, Position(hull.points[c]) - origin));
                for (const double value : {normal.x, normal.y, normal.z, glm::dot(normal, origin)})
                    planes.push_back(static_cast<dReal>(value));
                polygons.insert(polygons.end(), {3, a, b, c});
            }
        }
        std::vector<dReal> points, planes;
        std::vector<unsigned> polygons;
    };

    // A mesh in the form that ODE reads, with references to these arrays as well.
    struct Surface {
        explicit Surface(const SurfaceMesh& mesh) : indices(mesh.indices.begin(), mesh.indices.end()) {
            dGeomTriMeshDataBuildSingle(data, mesh.vertices.data(), sizeof(Vec3),
                                        static_cast<int>(mesh.vertices.size()), indices.data(),
                                        static_cast<int>(indices.size()), 3 * sizeof(dTriIndex));
        }
        ~Surface() { dGeomTriMeshDataDestroy(data); }
        Surface(const Surface&) = delete;
        Surface& operator=(const Surface&) = delete;
        std::vector<dTriIndex> indices;
        dTriMeshDataID data = dGeomTriMeshDataCreate();
    };

    void collide(dGeomID a, dGeomID b) {
        const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
        if (has_joints_ && body_a && body_b && dAreConnectedExcluding(body_a, body_b, dJointTypeContact)) return;
        constexpr int max_points = 8;
        dContact found[max_points];
        const int count = dCollide(a, b, max_points, &found[0].geom, sizeof(dContact));
        counts_.contacts += count > 0;
        counts_.points += static_cast<std::size_t>(count);
        for (int i = 0; i < count; ++i) {
            found[i].surface = {};
            found[i].surface.mode = dContactApprox1 | dContactBounce; // friction proportional to the normal force
            found[i].surface.mu = friction_;
            found[i].surface.bounce = restitution_;
            dJointAttach(dJointCreateContact(world_, contacts_, &found[i]), body_a, body_b);
        }
    }

    dGeomID make_shape(const Part& part) {
        const Vec3 size = 2.0f * part.half_extents;
        switch (part.shape) {
        case PartShape::sphere:
            return dCreateSphere(space_, part.radius);
        case PartShape::box:
            break;
        case PartShape::capsule:
            return dCreateCapsule(space_, part.radius, 2 * part.half_height);
        case PartShape::cylinder:
            return dCreateCylinder(space_, part.radius, 2 * part.half_height);
        case PartShape::hull: {
            const Polyhedron& hull = hulls_[part.index];
            return dCreateConvex(space_, hull.planes.data(), static_cast<unsigned>(hull.planes.size() / 4),
                                 hull.points.data(), static_cast<unsigned>(hull.points.size() / 3),
                                 hull.polygons.data());
        }
        case PartShape::mesh:
            return dCreateTriMesh(space_, meshes_[part.index]->data, nullptr, nullptr, nullptr);
        }
        return dCreateBox(space_, size.x, size.y, size.z);
    }

    // Static geometries belong to no body, and collide only with those of bodies.
    void add_part(const Scene& scene, const Part& part, const SceneBody& body, dBodyID made) {
        const dGeomID shape = make_shape(part);
        constexpr unsigned long moving = 1, fixed = 2;
        dGeomSetCategoryBits(shape, made ? moving : fixed);
        dGeomSetCollideBits(shape, !scene.collides ? 0 : made ? moving | fixed : moving);
        Quat rotation = part.rotation;
        if (part.shape == PartShape::capsule || part.shape == PartShape::cylinder) {
            // ODE's capsules and cylinders have z as their axis: a quarter turn maps it to y.
            const float half = std::sqrt(0.5f);
            rotation = rotation * Quat(half, -half, 0.0f, 0.0f);
        }
        if (made) {
            const Vec3 at = part.position - body.center_of_mass; // the center of mass is the origin of ODE's body
            dGeomSetBody(shape, made);
            dGeomSetOffsetPosition(shape, at.x, at.y, at.z);
            dGeomSetOffsetQuaternion(shape, Rotation(rotation).q);
        } else {
            const Vec3 at = Vec3(body.position) + body.rotation * part.position;
            dGeomSetPosition(shape, at.x, at.y, at.z);
            dGeomSetQuaternion(shape, Rotation(body.rotation * rotation).q);
        }
    }

    void add_body(const Scene& scene, const SceneBody& body) {
        states_at_start_.push_back(
            {Position(body.position), body.rotation, body.linear_velocity, body.angular_velocity});
        dBodyID made = nullptr;
        if (body.motion != Motion::fixed) {
            made = dBodyCreate(world_);
            const Vec3 at = body.position + body.rotation * body.center_of_mass;
            dBodySetPosition(made, at.x, at.y, at.z);
            dBodySetQuaternion(made, Rotation(body.rotation).q);
            dBodySetLinearVel(made, body.linear_velocity.x, body.linear_velocity.y, body.linear_velocity.z);
            dBodySetAngularVel(made, body.angular_velocity.x, body.angular_velocity.y, body.angular_velocity.z);
        }
        if (body.motion == Motion::dynamic) {
            const Mat3& i = body.inertia; // symmetric
            dMass mass;
            dMassSetParameters(&mass, body.mass, 0, 0, 0, i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]);
            dBodySetMass(made, &mass);
        }
        bodies_.push_back(made);
        centers_of_mass_.push_back(body.center_of_mass);
        for (std::size_t i = 0; i < body.part_count; ++i) add_part(scene, scene.parts[body.first_part + i], body, made);
        if (body.motion == Motion::kinematic) dBodySetKinematic(made);
    }

    // ODE measures the angle of its first body relative to the second: B comes first.
    void add_joint(const Scene& scene, const SceneJoint& joint) {
        has_joints_ = true;
        const SceneBody& of_b = scene.bodies[joint.body_b];
        const Vec3 at = of_b.position + of_b.rotation * joint.anchor_b;
        const auto axis_of = [&](Vec3 axis) { return of_b.rotation * (joint.axes_b * axis); };
        const Vec3 x = axis_of({1, 0, 0}), y = axis_of({0, 1, 0});
        const dBodyID a = bodies_[joint.body_a], b = bodies_[joint.body_b];
        if (joint.kind == JointKind::hinge) {
            const dJointID hinge = dJointCreateHinge(world_, nullptr);
            dJointAttach(hinge, b, a);
            dJointSetHingeAnchor(hinge, at.x, at.y, at.z);
            dJointSetHingeAxis(hinge, x.x, x.y, x.z);
            if (!joint.angle) return;
            dJointSetHingeParam(hinge, dParamLoStop, joint.angle->lower);
            dJointSetHingeParam(hinge, dParamHiStop, joint.angle->upper);
            return;
        }
        const dJointID ball = dJointCreateBall(world_, nullptr);
        dJointAttach(ball, b, a);
        dJointSetBallAnchor(ball, at.x, at.y, at.z);
        if (joint.reach) limit_turn(b, a, *joint.reach, x, y);
    }

    // ODE's ball joints have no limits; an unpowered motor beside them limits three Euler angles: the twist about B's
    // axis, and two swings, whose range is therefore a square instead of a cone.
    void limit_turn(dBodyID b, dBodyID a, const SwingTwist& reach, Vec3 x, Vec3 y) {
        const dJointID stops = dJointCreateAMotor(world_, nullptr);
        dJointAttach(stops, b, a);
        dJointSetAMotorMode(stops, dAMotorEuler);
        constexpr int of_first_body = 1, of_second_body = 2;
        dJointSetAMotorAxis(stops, 0, of_first_body, x.x, x.y, x.z);
        dJointSetAMotorAxis(stops, 2, of_second_body, y.x, y.y, y.z);
        const auto set_range = [&](int low, int high, float greatest) {
            dJointSetAMotorParam(stops, low, -greatest);
            dJointSetAMotorParam(stops, high, greatest);
        };
        set_range(dParamLoStop1, dParamHiStop1, reach.twist);
        set_range(dParamLoStop2, dParamHiStop2, reach.swing);
        set_range(dParamLoStop3, dParamHiStop3, reach.swing);
    }

    Library library_;
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    dJointGroupID contacts_ = dJointGroupCreate(0);
    std::vector<dBodyID> bodies_;       // null for static bodies
    std::vector<Vec3> centers_of_mass_; // in the frames of the bodies
    std::vector<Polyhedron> hulls_;
    std::vector<std::unique_ptr<Surface>> meshes_;
    std::vector<BodyState> states_at_start_;
    dReal friction_ = 0, restitution_ = 0;
    bool has_joints_ = false;
    int substeps_ = 1;
    StepCounts counts_;
};

} // namespace

EngineKind ode_engine() {
    return {"ode", CAIRN_BENCH_ODE, [] { return std::unique_ptr<Engine>(std::make_unique<OdeEngine>()); }};
}

} // namespace cairn::bench
