// Reads models in MJCF, the format of MuJoCo. docs/mjcf.md says how each element is converted.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace cairn::scene {

// `name` stands for the file in messages; without a `folder`, other files are refused. Throws Error.
Scene load_mjcf(std::span<const std::byte> bytes, const std::string& name,
                const std::optional<std::filesystem::path>& folder, const LoadOptions& options);

} // namespace cairn::scene
