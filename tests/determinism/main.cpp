// Runs the tests, or with `--print-golden-hashes` prints the lines of golden_hashes.h.
#include "scenes.h"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <cstring>

int main(int argc, char** argv) {
    using namespace cairn_test;
    if (argc == 2 && std::strcmp(argv[1], "--print-golden-hashes") == 0) {
        for (const NamedScene& scene : scenes())
            std::printf("inline constexpr std::uint64_t %s = 0x%016" PRIx64 ";\n", scene.name,
                        hash_after(scene.make(), golden_steps));
        return 0;
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
