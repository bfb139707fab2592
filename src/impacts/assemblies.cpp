#include "impacts/assemblies.h"

#include "state/joint_links.h"

namespace cairn {

Assemblies::Assemblies(const Bodies& bodies, const Joints& joints, SweepScratch& scratch)
    : bodies_(bodies), joints_(joints), scratch_(scratch) {
    if (scratch.assembly_of.size() < bodies.links.size()) scratch.assembly_of.resize(bodies.links.size(), none);
    scratch.members.clear();
    scratch.assemblies.clear();
}
Assemblies::~Assemblies() {
    for (const std::int32_t b : scratch_.members) scratch_.assembly_of[b] = none;
}

void Assemblies::take(std::int32_t body, std::int32_t assembly) {
    scratch_.assembly_of[body] = assembly;
    scratch_.members.push_back(body);
}

std::int32_t Assemblies::of(std::int32_t body) {
    if (bodies_.links[body].joint_count == 0 || !bodies_.is_dynamic(body)) return none;
    if (scratch_.assembly_of[body] != none) return scratch_.assembly_of[body];
    const auto assembly = std::int32_t(scratch_.assemblies.size());
    const auto begin = std::int32_t(scratch_.members.size());
    take(body, assembly);
    double mass = 0;
    bool is_held = false;
    for (std::size_t k = std::size_t(begin); k < scratch_.members.size(); ++k) {
        mass += 1 / double(bodies_.mass[scratch_.members[k]].inverse_mass);
        for_each_joint(bodies_, joints_, scratch_.members[k], [&](std::uint32_t joint, int side) {
            if (joint_owner(bodies_, joints_.info[joint]) == none) return; // it is not solved
            const std::int32_t other = other_body(joints_.info[joint], side);
            if (other == none || !bodies_.is_dynamic(other))
                is_held = true;
            else if (scratch_.assembly_of[other] == none)
                take(other, assembly);
        });
    }
    scratch_.assemblies.push_back({begin, std::int32_t(scratch_.members.size()), is_held ? 0 : 1 / mass});
    return assembly;
}

} // namespace cairn
