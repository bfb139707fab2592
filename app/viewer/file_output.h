/// \file file_output.h
/// Writing files whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace cairn::viewer {

/// Where a file is written before it takes its final name: beside it, so that renaming cannot cross a file system.
std::filesystem::path temporary_beside(const std::filesystem::path& path);
/// Makes the folder that `path` lies in, if it is missing. Throws `Error` (io).
void make_parent_folder(const std::filesystem::path& path);
/// Gives a finished temporary file its final name. Throws `Error` (io).
void take_final_name(const std::filesystem::path& temporary, const std::filesystem::path& path);
/// Writes a whole file: to a temporary first, which then takes the name. Throws `Error` (io) naming the path.
void write_file(const std::filesystem::path& path, std::string_view content);

} // namespace cairn::viewer
