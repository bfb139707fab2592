/// \file pages.h
/// Pages of the documentation, opened from the window.
#pragma once

#include <filesystem>
#include <string>

namespace cairn::viewer {

/// Opens a page of the documentation in `folder` with the program that the desktop has for such files, and returns a
/// line that says so; where there is no such page or no such program, one that says where the page is.
std::string open_page(const std::filesystem::path& folder, const std::string& page);

} // namespace cairn::viewer
