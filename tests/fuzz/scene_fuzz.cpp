// Any bytes as a scene file: it loads and makes a step, or is rejected with an Error. A scene that loads can be saved,
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

std::span<const std::byte> as_bytes(const std::string& text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cairn;
    std::string saved;
    try {
        scene::Scene scene = scene::load_from_memory(std::as_bytes(std::span(data, size)), "fuzz.glb");
        if (scene.world.bodies().size() > max_bodies) return 0;
        saved = scene::save_to_string(scene);
        scene.world.step(1.0f / 60.0f);
    } catch (const Error&) {
        return 0;
    }
    try {
        if (scene::save_to_string(scene::load_from_memory(as_bytes(saved), "saved")).empty()) std::abort();
    } catch (const Error& error) {
        std::fprintf(stderr, "what was saved is refused: %s\n%s\n", error.what(), saved.c_str());
        std::abort();
    }
    return 0;
}
