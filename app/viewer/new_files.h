/// \file new_files.h
/// Names for files that the viewer writes without being asked for a name.
#pragma once

#include <filesystem>
#include <string>

namespace cairn::viewer {

/// By the time of day: `cairn_2026-01-31_12-00-00`.
std::string name_of_now();
/// That name in that folder; where a file has it already, with a number.
std::filesystem::path unused_path(const std::filesystem::path& folder, const std::string& name,
                                  const std::string& extension);

/// The file in which the places of the viewer's windows are kept: in `$XDG_CONFIG_HOME`, or `~/.config`. Its folder is
/// made. Empty if this machine has no such place.
std::filesystem::path layout_file();

} // namespace cairn::viewer
