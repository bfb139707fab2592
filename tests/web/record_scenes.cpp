// cairn_record_scenes FOLDER: runs the scenes of tests/determinism, and writes for each a JavaScript module that makes
// the same calls of the npm package: NAME.mjs, with `settings`, `run` (a generator that yields after each step) and
// `hashes` of the state after the given steps.
//
// For this program the scenes are compiled again, with RecordedWorld in place of World.
#include "scenes_of_bodies.cpp"
#include "scenes_of_changes.cpp"
#include "scenes_of_joints.cpp"
#include "scenes_of_shapes.cpp"

#include <fstream>
#include <iostream>

namespace {

struct Recorded {
    const char* name;
    cairn_test::Scene& (*make)();
};

} // namespace

int main(int argc, char** argv) {
    using namespace cairn_test;
    if (argc != 2) {
        std::cerr << "usage: cairn_record_scenes FOLDER\n";
        return 2;
    }
    constexpr Recorded scenes[] = {
        {"mixed_pile", mixed_pile}, {"pyramid", pyramid},
        {"dominoes", dominoes},     {"materials", materials},
        {"tumbler", tumbler},       {"sleep_and_wake", sleep_and_wake},
        {"compounds", compounds},   {"free_tops", free_tops},
        {"whirl", whirl},           {"explicit_euler", explicit_euler},
        {"changes", changes},       {"all_shapes", all_shapes},
        {"surfaces", surfaces},     {"rounded_shapes", rounded_shapes},
        {"chains", chains},         {"all_joints", all_joints},
        {"robots", robots},
    };
    for (const Recorded& recorded : scenes) {
        Scene& scene = recorded.make();
        cairn::RecordedWorld world(scene.settings());
        scene.build(world);
        std::string hashes;
        for (int i = 1; i <= golden_steps; ++i) {
            scene.step(world);
            if (i == 1 || i == 60 || i == golden_steps)
                hashes += "    " + std::to_string(i) + ": " + cairn::js(world.state_hash()) + ",\n";
        }
        std::ofstream file(std::string(argv[1]) + "/" + recorded.name + ".mjs");
        file << "export const settings = " << cairn::js(scene.settings()) << ";\nexport const hashes = {\n"
             << hashes << "};\nexport function* run(world, { keep, at, Geometry }) {\n"
             << world.program() << "}\n";
        if (!file.flush()) {
            std::cerr << "cairn_record_scenes: " << argv[1] << "/" << recorded.name << ".mjs cannot be written\n";
            return 1;
        }
    }
    return 0;
}
