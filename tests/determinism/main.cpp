// The tests, and two more uses of the same program: `--hash SCENE` prints the instruction set and the state hash of
// a scene (the tests start the program so, once per instruction set), `--print-golden-hashes` renews golden_hashes.h.
#include "own_program.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <cstring>

namespace cairn_test {
std::string own_program;
}

int main(int argc, char** argv) {
    using namespace cairn_test;
    if (argc == 3 && std::strcmp(argv[1], "--hash") == 0) {
        const NamedScene* scene = find_scene(argv[2]);
        if (!scene) {
            std::fprintf(stderr, "no scene %s\n", argv[2]);
            return 2;
        }
        const std::string isa(cairn::instruction_set());
        std::printf("%s %016" PRIx64 "\n", isa.c_str(), hash_after(scene->make(), golden_steps));
        return 0;
    }
    if (argc == 2 && std::strcmp(argv[1], "--print-golden-hashes") == 0) {
        for (const NamedScene& scene : scenes())
            std::printf("inline constexpr std::uint64_t %s = 0x%016" PRIx64 ";\n", scene.name,
                        hash_after(scene.make(), golden_steps));
        return 0;
    }
    own_program = argv[0];
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
