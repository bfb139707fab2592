// Scenes whose state after a given number of steps must be the same, bit for bit, everywhere.
#pragma once

#include <cairn/cairn.h>

#include <cstdint>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

namespace cairn_test {

// A world with a scene in it. External actions of a scene (rotating, pushing, waking) depend on the step count alone,
// so that a restored world can continue from its snapshot.
class Scene {
  public:
    virtual ~Scene() = default;
    virtual cairn::WorldDef settings() const { return {}; }
    virtual void build(cairn::World& world) = 0;
    virtual void before_step(cairn::World&) {}

    void step(cairn::World& world) {
        before_step(world);
        world.step(1.0f / 60);
    }
};

struct NamedScene {
    const char* name;
    Scene& (*make)();
    std::uint64_t golden_hash; // state hash after `golden_steps` steps
};

inline void PrintTo(const NamedScene& scene, std::ostream* out) { *out << scene.name; } // for test reports

inline constexpr int golden_steps = 600;

std::span<const NamedScene> scenes();
const NamedScene* find_scene(std::string_view name);

// The state hash after `steps` steps from the start.
std::uint64_t hash_after(Scene& scene, int steps, int threads = 1);

} // namespace cairn_test
