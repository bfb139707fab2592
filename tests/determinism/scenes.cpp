#include "scenes.h"

#include "golden_hashes.h"
#include "scene_tools.h"

namespace cairn_test {

namespace {

constexpr NamedScene all_scenes[] = {
    {"mixed_pile", mixed_pile, golden::mixed_pile},
    {"pyramid", pyramid, golden::pyramid},
    {"dominoes", dominoes, golden::dominoes},
    {"materials", materials, golden::materials},
    {"tumbler", tumbler, golden::tumbler},
    {"sleep_and_wake", sleep_and_wake, golden::sleep_and_wake},
    {"compounds", compounds, golden::compounds},
    {"free_tops", free_tops, golden::free_tops},
    {"explicit_euler", explicit_euler, golden::explicit_euler},
    {"whirl", whirl, golden::whirl},
    {"changes", changes, golden::changes},
    {"all_shapes", all_shapes, golden::all_shapes},
    {"rounded_shapes", rounded_shapes, golden::rounded_shapes},
    {"surfaces", surfaces, golden::surfaces},
    {"all_joints", all_joints, golden::all_joints},
    {"chains", chains, golden::chains},
    {"robots", robots, golden::robots},
};

} // namespace

std::span<const NamedScene> scenes() { return all_scenes; }

const NamedScene* find_scene(std::string_view name) {
    for (const NamedScene& scene : all_scenes)
        if (name == scene.name) return &scene;
    return nullptr;
}

std::uint64_t hash_after(Scene& scene, int steps, int threads) {
    cairn::World world{scene.settings()};
    world.set_threads(threads);
    scene.build(world);
    for (int i = 0; i < steps; ++i) scene.step(world);
    return world.state_hash();
}

} // namespace cairn_test
