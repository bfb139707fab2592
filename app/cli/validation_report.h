// The results of the validation cases, as a page with plots.
#pragma once

#include "cli/validation_text.h"

#include <filesystem>
#include <vector>

namespace cairn::cli {

// Creates the folder if it is missing. Throws Error (io) if files cannot be written into it.
void check_report_folder(const std::filesystem::path& folder);

// Writes index.html, which is self-contained, table.md, and every plot as a picture (CASE_1.svg, ...). Each file is
// complete or absent. Throws Error (io).
void write_report(const std::filesystem::path& folder, const std::vector<Measured>& cases);

} // namespace cairn::cli
