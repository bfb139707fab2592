// Benchmark scenes as files that the viewer opens.
#pragma once

#include "bench/scenes.h"

#include <filesystem>

namespace cairn::bench {

// Writes the scene as `folder`/NAME.gltf, with a camera that sees everything, and returns that path. Makes the folder
// if it is not there. Walls are one-sided rectangles there, which one looks through from behind (Part::inner_face).
// Throws cairn::Error.
std::filesystem::path save_scene(const Scene& scene, const std::filesystem::path& folder);

} // namespace cairn::bench
