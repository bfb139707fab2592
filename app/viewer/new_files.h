/// \file new_files.h
/// Names for files that the viewer writes unasked for a name.
#pragma once

#include <filesystem>
#include <string>

namespace cairn::viewer {

/// By the time of day: `cairn_2026-01-31_12-00-00`.
std::string name_of_now();
/// That name in that folder; where a file has it already, with a number.
std::filesystem::path unused_path(const std::filesystem::path& folder, const std::string& name,
                                  const std::string& extension);

} // namespace cairn::viewer
