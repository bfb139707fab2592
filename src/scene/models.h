// Models of robots and scenes in formats other than glTF: selects the reader of a file.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace cairn::scene {

// Returns the scene of a file in URDF, MJCF, SDF or USD, which is recognized by its first bytes; nothing if it is none
// of them. `name` stands for the file in messages; without a `folder`, other files that it names are refused. Throws
// Error, also (unsupported) for every such file where the library is built without models (CAIRN_MODELS).
std::optional<Scene> load_model(std::span<const std::byte> bytes, const std::string& name,
                                const std::optional<std::filesystem::path>& folder, const LoadOptions& options);

} // namespace cairn::scene
