// Shared by the fuzz targets of model formats.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

namespace cairn::fuzz {

inline int try_model(const char* beginning, const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t max_bodies = 50; // small enough to be tried many times per second
    std::string text(beginning);           // otherwise the format is not recognized
    text.append(reinterpret_cast<const char*>(data), size);
    std::string saved;
    try {
        scene::Scene model = scene::load_from_memory(std::as_bytes(std::span(text.data(), text.size())), "fuzz");
        if (model.world.bodies().size() > max_bodies) return 0;
        saved = scene::save_to_string(model);
        model.world.step(1.0f / 60.0f);
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

} // namespace cairn::fuzz
