// ODE with QuickStep, its iterative solver, at its default settings.
#include "bench/engine.h"

#include <ode/ode.h>

namespace cairn::bench {

namespace {

// The library itself, open as long as anyone uses it.
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
        dSpaceDestroy(space_); // and all geometry in it
        dWorldDestroy(world_);
    }
    OdeEngine(const OdeEngine&) = delete;
    OdeEngine& operator=(const OdeEngine&) = delete;

    void build(const Scene& scene, const EngineSettings& settings) override {
        substeps_ = settings.substeps > 0 ? settings.substeps : 1;
        friction_ = scene.friction;
        restitution_ = scene.restitution;
        dWorldSetGravity(world_, scene.gravity.x, scene.gravity.y, scene.gravity.z);
        for (const SceneBody& body : scene.bodies) add_body(scene, body);
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
        states = states_at_start_; // what is fixed stays there
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!bodies_[i]) continue;
            const dReal *p = dBodyGetPosition(bodies_[i]), *q = dBodyGetQuaternion(bodies_[i]);
            states[i].position = Position(p[0], p[1], p[2]);
            states[i].rotation = Quat(static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]),
                                      static_cast<float>(q[3]));
            states[i].linear_velocity = from_ode(dBodyGetLinearVel(bodies_[i]));
            states[i].angular_velocity = from_ode(dBodyGetAngularVel(bodies_[i]));
        }
    }

    StepCounts counts() const override { return counts_; }

  private:
    void collide(dGeomID a, dGeomID b) {
        constexpr int most_points = 8;
        dContact found[most_points];
        const int count = dCollide(a, b, most_points, &found[0].geom, sizeof(dContact));
        counts_.contacts += count > 0;
        counts_.points += static_cast<std::size_t>(count);
        for (int i = 0; i < count; ++i) {
            found[i].surface = {};
            found[i].surface.mode = dContactApprox1 | dContactBounce; // friction by the normal force
            found[i].surface.mu = friction_;
            found[i].surface.bounce = restitution_;
            dJointAttach(dJointCreateContact(world_, contacts_, &found[i]), dGeomGetBody(a), dGeomGetBody(b));
        }
    }

    // Fixed geometry belongs to no body and meets only what belongs to one.
    void add_part(const Part& part, const SceneBody& body, dBodyID made) {
        const Vec3 size = 2.0f * part.half_extents;
        const dGeomID shape = part.shape == PartShape::sphere ? dCreateSphere(space_, part.radius)
                                                              : dCreateBox(space_, size.x, size.y, size.z);
        constexpr unsigned long moving = 1, fixed = 2;
        dGeomSetCategoryBits(shape, made ? moving : fixed);
        dGeomSetCollideBits(shape, made ? moving | fixed : moving);
        if (made) {
            dGeomSetBody(shape, made);
            dGeomSetOffsetPosition(shape, part.position.x, part.position.y, part.position.z);
            dGeomSetOffsetQuaternion(shape, Rotation(part.rotation).q);
        } else {
            const Vec3 at = Vec3(body.position) + body.rotation * part.position;
            dGeomSetPosition(shape, at.x, at.y, at.z);
            dGeomSetQuaternion(shape, Rotation(body.rotation * part.rotation).q);
        }
        if (body.motion != Motion::dynamic) return;
        dMass mass; // dynamic bodies have one part
        if (part.shape == PartShape::sphere)
            dMassSetSphereTotal(&mass, body.mass, part.radius);
        else
            dMassSetBoxTotal(&mass, body.mass, size.x, size.y, size.z);
        dBodySetMass(made, &mass);
    }

    void add_body(const Scene& scene, const SceneBody& body) {
        states_at_start_.push_back(
            {Position(body.position), body.rotation, body.linear_velocity, body.angular_velocity});
        dBodyID made = nullptr;
        if (body.motion != Motion::fixed) {
            made = dBodyCreate(world_);
            dBodySetPosition(made, body.position.x, body.position.y, body.position.z);
            dBodySetQuaternion(made, Rotation(body.rotation).q);
            dBodySetLinearVel(made, body.linear_velocity.x, body.linear_velocity.y, body.linear_velocity.z);
            dBodySetAngularVel(made, body.angular_velocity.x, body.angular_velocity.y, body.angular_velocity.z);
        }
        bodies_.push_back(made);
        for (std::size_t i = 0; i < body.part_count; ++i) add_part(scene.parts[body.first_part + i], body, made);
        if (body.motion == Motion::kinematic) dBodySetKinematic(made);
    }

    Library library_;
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    dJointGroupID contacts_ = dJointGroupCreate(0);
    std::vector<dBodyID> bodies_; // none where fixed
    std::vector<BodyState> states_at_start_;
    dReal friction_ = 0, restitution_ = 0;
    int substeps_ = 1;
    StepCounts counts_;
};

} // namespace

EngineKind ode_engine() {
    return {"ode", CAIRN_BENCH_ODE, [] { return std::unique_ptr<Engine>(std::make_unique<OdeEngine>()); }};
}

} // namespace cairn::bench
