#include "joints/joint_loads.h"

#include "islands/substeps.h"
#include <algorithm>
#include <cmath>

namespace cairn {

void note_joint_loads(State& s, const Bin& bin, const BinScratch& scratch) {
    std::size_t k = 0; // they lie in the order of the islands
    for (std::int32_t i = 0; i < bin.island_count; ++i) {
        Island& island = s.islands[std::size_t(s.solver.bin_islands[std::size_t(bin.first_island + i)])];
        if (island.joint_count == 0) continue;
        bool any_direct = false; // what they bear says nothing about the others
        double sum = 0;
        for (const std::size_t end = k + std::size_t(island.joint_count); k < end; ++k) {
            const double demand = double(scratch.joint_demands[k]);
            any_direct |= demand == unknown_demand;
            sum += demand * demand;
        }
        const float now = any_direct ? unknown_demand : float(std::sqrt(sum / island.joint_count));
        if (island.joint_demand == unknown_demand)
            island.joint_demand = std::min(now, unknown_demand);
        else
            island.joint_demand += load_gain * (std::min(now, unknown_demand) - island.joint_demand);
    }
}

} // namespace cairn
