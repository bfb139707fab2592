#include "bench/cairn_world.h"
#include "bench/engine.h"

#include <cairn/cairn.h>

namespace cairn::bench {

namespace {

class CairnEngine final : public Engine {
  public:
    void build(const Scene& scene, const EngineSettings& settings) override {
        WorldDef def = world_settings(scene);
        if (settings.substeps > 0) def.substeps = settings.substeps;
        world_.set_settings(def);
        world_.set_threads(settings.threads);
        bodies_ = add_bodies(scene, world_, Walls::boxes);
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
    World world_;
    std::vector<BodyId> bodies_;
};

} // namespace

EngineKind cairn_engine() {
    return {"cairn", version_string, [] { return std::unique_ptr<Engine>(std::make_unique<CairnEngine>()); }, true};
}

} // namespace cairn::bench
