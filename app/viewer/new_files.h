/// \file new_files.h
/// Names for files that the viewer writes without being asked for a name.
#pragma once

#include <filesystem>
#include <string>

namespace cairn::viewer {

/// A name from the date and time: `cairn_2026-01-31_12-00-00`.
std::string name_of_now();
/// A path with that name in that folder; a number is added if the file exists.
std::filesystem::path unused_path(const std::filesystem::path& folder, const std::string& name,
                                  const std::string& extension);

/// The file that stores the positions of the viewer's windows: in `$XDG_CONFIG_HOME`, or `~/.config`. Creates its
/// folder. Empty if this machine has no such folder.
std::filesystem::path layout_file();

} // namespace cairn::viewer
