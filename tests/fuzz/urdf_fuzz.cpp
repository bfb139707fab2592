// Any bytes as a URDF robot: it loads and makes a step, or is rejected with an Error. A robot that loads can be saved,
// and the saved file loads again. `./dev fuzz` runs it; its corpus also runs with the tests, without a fuzzer
// (corpus_main.cpp).
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

namespace {

// Number of bodies, small enough to be tried many times per second.
constexpr std::size_t max_bodies = 50;

} // namespace

// urdfdom leaks links that form a cycle, when it finds no root to return.
extern "C" const char* __lsan_default_suppressions() { return "leak:liburdfdom_model\n"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cairn;
    std::string text(1, '<'); // otherwise it is not XML
    text.append(reinterpret_cast<const char*>(data), size);
    std::string saved;
    try {
        scene::Scene robot = scene::load_from_memory(std::as_bytes(std::span(text.data(), text.size())), "fuzz.urdf");
        if (robot.world.bodies().size() > max_bodies) return 0;
        saved = scene::save_to_string(robot);
        robot.world.step(1.0f / 60.0f);
    } catch (const Error&) {
        return 0;
    }
    try {
        scene::load_from_memory(std::as_bytes(std::span(saved.data(), saved.size())), "saved");
    } catch (const Error& error) {
        std::fprintf(stderr, "what was saved is refused: %s\n%s\n", error.what(), saved.c_str());
        std::abort();
    }
    return 0;
}
