// URDF text, taken apart by urdfdom; and the files of meshes that it names.
#pragma once

#include <urdf_world/types.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace cairn::scene {

// Links and joints are those of the file, each link with one parent at most, and all of them below the root. `name`
// stands for the file in messages. Throws Error (invalid_file).
urdf::ModelInterfaceSharedPtr parse_urdf(std::span<const std::byte> bytes, const std::string& name);

// The file that a mesh's `filename` means: relative to the robot's folder, or package://NAME/PATH. A package is a
// folder above the robot's with a package.xml: the one of that name, else the nearest one. Without any, NAME is a
// folder beside the robot, or the robot's own. The file must lie in the package or, without one, in the robot's folder
// or below it. `place` stands for the element in messages. Throws Error: invalid_file if it leads out, io if there is
// none.
std::filesystem::path find_robot_mesh(const std::string& filename, const std::optional<std::filesystem::path>& folder,
                                      const std::string& place);

} // namespace cairn::scene
