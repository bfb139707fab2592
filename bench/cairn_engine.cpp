#include "bench/engine.h"

#include <cairn/cairn.h>

namespace cairn::bench {

namespace {

class CairnEngine final : public Engine {
  public:
    void build(const Scene& scene, const EngineSettings& settings) override {
        WorldDef def;
        def.gravity = scene.gravity;
        def.enable_sleep = false;
        if (settings.substeps > 0) def.substeps = settings.substeps;
        world_.set_settings(def);
        world_.set_threads(settings.threads);
        bodies_.reserve(scene.bodies.size());
        for (const SceneBody& body : scene.bodies) add_body(scene, body);
    }

    void step(float time_step) override { world_.step(time_step); }

    void read(std::vector<BodyState>& states) const override {
        states.resize(bodies_.size());
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Body body = world_.body(bodies_[i]);
            states[i] = {body.position(), body.rotation(), body.linear_velocity(), body.angular_velocity()};
        }
    }

    StepCounts counts() const override {
        const Statistics s = world_.statistics();
        return {s.contacts, s.contact_points, s.candidate_pairs, s.max_substeps};
    }

    std::vector<StageTime> stages() const override {
        const StageTimes t = world_.statistics().times;
        return {{"broad_phase", t.broad_phase},
                {"narrow_phase", t.narrow_phase},
                {"islands", t.islands},
                {"prepare", t.prepare},
                {"solve", t.solve},
                {"finalize", t.finalize}};
    }

  private:
    void add_body(const Scene& scene, const SceneBody& body) {
        BodyDef def;
        def.type = body.motion == Motion::dynamic ? BodyType::dynamic
                   : body.motion == Motion::fixed ? BodyType::static_
                                                  : BodyType::kinematic;
        def.position = Position(body.position);
        def.rotation = body.rotation;
        def.linear_velocity = body.linear_velocity;
        def.angular_velocity = body.angular_velocity;
        const BodyId id = world_.create_body(def);
        bodies_.push_back(id);
        for (std::size_t i = 0; i < body.part_count; ++i) {
            const Part& part = scene.parts[body.first_part + i];
            ShapeDef shape;
            shape.position = part.position;
            shape.rotation = part.rotation;
            shape.density = body.density;
            shape.material.static_friction = shape.material.dynamic_friction = scene.friction;
            shape.material.restitution = scene.restitution;
            if (part.shape == PartShape::sphere)
                world_.add_shape(id, Sphere{part.radius}, shape);
            else
                world_.add_shape(id, Box{part.half_extents}, shape);
        }
    }

    World world_;
    std::vector<BodyId> bodies_;
};

} // namespace

EngineKind cairn_engine() {
    return {"cairn", version_string, [] { return std::unique_ptr<Engine>(std::make_unique<CairnEngine>()); }, true};
}

} // namespace cairn::bench
