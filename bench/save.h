// Saves benchmark scenes as files for the viewer.
#pragma once

#include "bench/scenes.h"

#include <filesystem>

namespace cairn::bench {

// Writes the scene as `folder`/NAME.gltf, with a camera that sees everything, and returns that path. Creates the folder
// if it does not exist. Walls become one-sided rectangles, which are transparent from behind (Part::inner_face). Throws
// cairn::Error.
std::filesystem::path save_scene(const Scene& scene, const std::filesystem::path& folder);

} // namespace cairn::bench
