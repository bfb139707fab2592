// What a physics engine has to offer to be measured. Each engine runs at its own default settings, except that
// nothing falls asleep.
#pragma once

#include "bench/scenes.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::bench {

// Where a body of a scene is and how it moves. Its frame is the one that its parts are placed in; the center of mass is
// elsewhere where SceneBody::center_of_mass says so.
struct BodyState {
    Position position{0.0, 0.0, 0.0};       // of the origin of the body's frame
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  // of the body's frame
    Vec3 linear_velocity{0.0f, 0.0f, 0.0f}; // of the center of mass
    Vec3 angular_velocity{0.0f, 0.0f, 0.0f};
};

struct EngineSettings {
    int substeps = 0; // in which a step is solved; 0: the engine's default
    int threads = 1;  // only for engines with EngineKind::has_threads
};

// What an engine says of its last step. Absent: it does not say.
struct StepCounts {
    std::size_t contacts = 0; // pairs that have contact points
    std::size_t points = 0;
    std::optional<std::size_t> candidates; // pairs whose bounds overlap
    std::optional<int> substeps;           // the most that any body took
};

// Wall-clock time of one stage of the last step, ms.
struct StageTime {
    std::string_view name;
    double milliseconds = 0;
};

class Engine {
  public:
    virtual ~Engine() = default;
    virtual void build(const Scene& scene, const EngineSettings& settings) = 0; // once, before all else
    virtual void step(float time_step) = 0;
    virtual void read(std::vector<BodyState>& states) const = 0; // by index in Scene::bodies
    virtual StepCounts counts() const = 0;
    virtual std::vector<StageTime> stages() const { return {}; } // always the same ones; none if it does not say
};

struct EngineKind {
    std::string_view name; // for --engines
    std::string_view version;
    std::unique_ptr<Engine> (*make)();
    bool has_threads = false; // can step on more than one
    // Why it cannot do a scene; empty if it can. Absent: it can do all.
    std::string (*refusal)(const Scene& scene) = nullptr;
};

EngineKind cairn_engine();
#ifdef CAIRN_BENCH_BULLET
EngineKind bullet_engine();
#endif
#ifdef CAIRN_BENCH_ODE
EngineKind ode_engine();
#endif

} // namespace cairn::bench
