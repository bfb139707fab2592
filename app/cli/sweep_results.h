// The results of a sweep, from the rows in its folder.
#pragma once

#include "sweep/summary.h"

#include <filesystem>
#include <string>

namespace cairn::cli {

// Writes rows.csv and rows.npy into the folder, and gives what they say together. Throws Error (io).
sweep::Summary write_rows(const sweep::Plan& plan, const sweep::Store& store, const std::filesystem::path& folder);

// Why rows failed, one line each: they are run again.
std::vector<std::string> failure_lines(const sweep::Plan& plan, const sweep::Start& start,
                                       const sweep::Summary& summary);

// So many measures have charts and indices of sensitivity: a page of thousands would open nowhere.
inline constexpr std::size_t most_measures_shown = 50;

std::string sweep_json(const sweep::Plan& plan, const sweep::Summary& summary,
                       const std::vector<std::string>& failures);
std::string sweep_text(const sweep::Plan& plan, const sweep::Summary& summary, const std::vector<std::string>& failures,
                       const std::filesystem::path& folder);

// One page, with all that it shows in it.
std::string sweep_report(const sweep::Plan& plan, const sweep::Summary& summary,
                         const std::vector<std::string>& failures);

} // namespace cairn::cli
