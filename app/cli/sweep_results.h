// The results of a sweep, computed from the rows in its folder.
#pragma once

#include "sweep/summary.h"

#include <filesystem>
#include <string>

namespace cairn::cli {

// Writes rows.csv and rows.npy into the folder, and returns their summary. Throws Error (io).
sweep::Summary write_rows(const sweep::Plan& plan, const sweep::Store& store, const std::filesystem::path& folder);

// The reasons why rows failed, one line each; found by running these rows again.
std::vector<std::string> failure_lines(const sweep::Plan& plan, const sweep::Start& start,
                                       const sweep::Summary& summary);

// Greatest number of measures that get charts and sensitivity indices: a page with thousands could not be opened.
inline constexpr std::size_t most_measures_shown = 50;

std::string sweep_json(const sweep::Plan& plan, const sweep::Summary& summary,
                       const std::vector<std::string>& failures);
std::string sweep_text(const sweep::Plan& plan, const sweep::Summary& summary, const std::vector<std::string>& failures,
                       const std::filesystem::path& folder);

// A self-contained page.
std::string sweep_report(const sweep::Plan& plan, const sweep::Summary& summary,
                         const std::vector<std::string>& failures);

} // namespace cairn::cli
