// The table of impacts: rows by name, each of which measures something with the cells and says how it is judged.
#pragma once

#include "validation/validation.h"

#include <span>
#include <vector>

namespace cairn_test {

struct ImpactRow {
    const char* name;
    const char* about; // what is done, in a line
    // Runs it. `shots` is the number of worlds of each cell; 0: the row's own.
    std::vector<cairn::validation::Row> (*measure)(int shots);
};

std::span<const ImpactRow> impact_rows();

} // namespace cairn_test
