// cairn_hashes: runs the scenes and prints the state hash of each. It depends on the engine alone, so that it can be
// built for any machine: ./dev determinism compares its output on all of them.
#include "scenes.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

constexpr const char* usage = R"(usage: cairn_hashes [--threads N] [--steps N] [--every N] [SCENE...]
Prints the instruction set, then for each scene (all of them unless some are named) a line with its name, the number of
steps and the hash of the state after them.
  --threads N   of each world, 1 to 256 (1)
  --steps N     from the start (600)
  --every N     also after every N steps, to find where two machines part
The environment variable CAIRN_ISA chooses the instruction set.
)";

// Exits with a message unless the text is an integer from 1 to `most`.
int number(const char* option, const char* text, int most) {
    char* end = nullptr;
    const long value = text ? std::strtol(text, &end, 10) : 0;
    if (text && end != text && *end == '\0' && value >= 1 && value <= most) return int(value);
    std::fprintf(stderr, "cairn_hashes: %s %s: must be a whole number from 1 to %d\n", option, text ? text : "", most);
    std::exit(2);
}

void print(const char* name, const cairn::World& world) {
    std::printf("%s %" PRIu64 " %016" PRIx64 "\n", name, world.step_count(), world.state_hash());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    using namespace cairn_test;
    int threads = 1, steps = golden_steps, every = 0;
    std::vector<const NamedScene*> chosen;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const char* const value = argv[i + 1]; // argv ends with a null pointer
        if (word == "--help" || word == "-h") {
            std::fputs(usage, stdout);
            return 0;
        }
        if (word == "--threads") {
            threads = number(argv[i++], value, 256);
        } else if (word == "--steps") {
            steps = number(argv[i++], value, 1 << 30);
        } else if (word == "--every") {
            every = number(argv[i++], value, 1 << 30);
        } else if (const NamedScene* scene = find_scene(word)) {
            chosen.push_back(scene);
        } else {
            std::fprintf(stderr, "cairn_hashes: no option or scene %s\n%s", argv[i], usage);
            return 2;
        }
    }
    if (chosen.empty())
        for (const NamedScene& scene : scenes()) chosen.push_back(&scene);
    std::printf("%s\n", std::string(cairn::instruction_set()).c_str());
    for (const NamedScene* named : chosen) {
        Scene& scene = named->make();
        cairn::World world{scene.settings()};
        world.set_threads(threads);
        scene.build(world);
        for (int i = 1; i <= steps; ++i) {
            scene.step(world);
            if (every > 0 && i < steps && i % every == 0) print(named->name, world);
        }
        print(named->name, world);
    }
    return 0;
}
