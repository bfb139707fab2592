// The table of impacts: named rows, each of which measures something with the cells and states how it is judged.
#pragma once

#include "validation/validation.h"

#include <span>
#include <vector>

namespace cairn_test {

struct ImpactRow {
    const char* name;
    const char* about; // description in one line
    // Runs the row. `shots`: the number of worlds per cell; 0: the default of the row.
    std::vector<cairn::validation::Row> (*measure)(int shots);
};

std::span<const ImpactRow> impact_rows();

} // namespace cairn_test
