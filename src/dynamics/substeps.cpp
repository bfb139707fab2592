#include "dynamics/solver.h"

#include <algorithm>

namespace cairn {

int island_substeps(const State& state, const Island& island) {
    return std::max(state.settings.substeps, int(island.wanted_substeps));
}

} // namespace cairn
