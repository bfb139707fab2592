// What the validation cases measured, as a page with plots.
#pragma once

#include "cli/validation_text.h"

#include <filesystem>
#include <vector>

namespace cairn::cli {

// Throws Error (io) if files cannot be written into that folder; makes it if it is missing.
void check_report_folder(const std::filesystem::path& folder);

// Writes index.html, which needs no other file, table.md, and every plot as a picture of its own (CASE_1.svg, ...).
// Each file is whole or absent. Throws Error (io).
void write_report(const std::filesystem::path& folder, const std::vector<Measured>& cases);

} // namespace cairn::cli
