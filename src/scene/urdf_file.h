// Parses URDF text with urdfdom, and resolves the mesh files that it names.
#pragma once

#include "scene/mesh_store.h"

#include <urdf_world/types.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace cairn::scene {

// Returns the links and joints of the file; each link has at most one parent, and all are below the root. `name` stands
// for the file in messages. Throws Error (invalid_file).
urdf::ModelInterfaceSharedPtr parse_urdf(std::span<const std::byte> bytes, const std::string& name);

// Returns a `filename` without superfluous slashes before the name of a package, as in "package:///NAME/PATH".
std::string without_spare_slashes(const std::string& filename);

// Returns the file that a `filename` of a mesh or a texture refers to: relative to the robot's folder, or
// package://NAME/PATH. A package is a folder above the robot's with a package.xml: the one of that name, else the
// nearest one. Without any, NAME is a folder beside the robot, or the robot's own. The file must lie in the package or,
// without one, in the robot's folder or below it. `place` stands for the element in messages. Throws Error: io if the
// file is missing or leads out of the folder; the message does not tell these apart.
NamedFile find_robot_file(const std::string& filename, const std::optional<std::filesystem::path>& folder,
                          const std::string& place);

} // namespace cairn::scene
