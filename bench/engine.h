// The interface through which a physics engine is measured. Each engine runs with its own default settings, except that
// bodies never sleep.
#pragma once

#include "bench/scenes.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::bench {

// The pose and velocity of a body. The frame of a body is the one in which its parts are placed; the center of mass is
// at SceneBody::center_of_mass in it.
struct BodyState {
    Position position{0.0, 0.0, 0.0};       // of the origin of the body's frame
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  // of the body's frame
    Vec3 linear_velocity{0.0f, 0.0f, 0.0f}; // of the center of mass
    Vec3 angular_velocity{0.0f, 0.0f, 0.0f};
};

struct EngineSettings {
    int substeps = 0; // number per step; 0: the engine's default
    int threads = 1;  // only for engines with EngineKind::has_threads
};

// Counts of the last step, where the engine reports them.
struct StepCounts {
    std::size_t contacts = 0; // pairs that have contact points
    std::size_t points = 0;
    std::optional<std::size_t> candidates; // pairs whose bounds overlap
    std::optional<int> substeps;           // maximum over all bodies
};

// Wall-clock time of one stage of the last step, ms.
struct StageTime {
    std::string_view name;
    double milliseconds = 0;
};

class Engine {
  public:
    virtual ~Engine() = default;
    // Called once, before all other functions.
    virtual void build(const Scene& scene, const EngineSettings& settings) = 0;
    virtual void step(float time_step) = 0;
    virtual void read(std::vector<BodyState>& states) const = 0; // by index in Scene::bodies
    virtual StepCounts counts() const = 0;
    // The same stages in every step; empty if the engine does not report them.
    virtual std::vector<StageTime> stages() const { return {}; }
};

struct EngineKind {
    std::string_view name; // for --engines
    std::string_view version;
    std::unique_ptr<Engine> (*make)();
    bool has_threads = false; // can step on several threads
    // The reason why the engine cannot simulate a scene; empty if it can. A null pointer: it can simulate all scenes.
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
