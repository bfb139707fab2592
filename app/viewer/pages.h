/// \file pages.h
/// Pages of the documentation, opened from the window.
#pragma once

#include <filesystem>
#include <string>

namespace cairn::viewer {

/// Opens a documentation page in `folder` with the desktop's program for such files, and returns a message that says
/// so; without such a page or program, a message that says where the page is.
std::string open_page(const std::filesystem::path& folder, const std::string& page);

} // namespace cairn::viewer
