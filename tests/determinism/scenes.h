// Scenes whose state after some steps must be the same, bit for bit, everywhere.
#pragma once

#include <cairn/cairn.h>

#include <cstdint>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

namespace cairn_test {

// A world with a scene in it. What a scene does from outside (turning, pushing, waking) depends on the number of
// steps taken alone, so that a restored world can go on from where the snapshot was taken.
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
    std::uint64_t golden_hash; // of the state after `golden_steps` steps
};

inline void PrintTo(const NamedScene& scene, std::ostream* out) { *out << scene.name; } // for the test's reports

inline constexpr int golden_steps = 600;

std::span<const NamedScene> scenes();
const NamedScene* find_scene(std::string_view name);

// The hash after so many steps from the start.
std::uint64_t hash_after(Scene& scene, int steps, int threads = 1);

} // namespace cairn_test
