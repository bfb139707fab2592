// Reads worlds in text layers of USD with UsdPhysics. docs/usd.md says how each schema is converted.
#pragma once

#include "scene/scene.h"
#include "scene/usd_text.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace cairn::scene {

// `name` stands for the file in messages. `folder` is that of the file; pictures must lie in it or below it. Without a
// folder, other files are not read. Throws Error: `unsupported` for binary files and packages.
Scene load_usd(std::span<const std::byte> bytes, const std::string& name,
               const std::optional<std::filesystem::path>& folder, const LoadOptions& options);

} // namespace cairn::scene
