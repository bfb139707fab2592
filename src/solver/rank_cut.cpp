// Which rank solves what.
#include "solver/rank_cut.h"

#include "core/order.h"
#include "math/vec.h"
#include "solver/batch_rows.h"

#include <algorithm>
#include <numeric>

namespace cairn {

namespace {

// Batches with fewer contacts are not worth being cut: what their ranks would tell each other takes longer.
constexpr std::int32_t min_cut_contacts = 512;

// To which of `ranks` equal parts of the whole something belongs that lies at this place of it.
std::int32_t part_at(double place, double whole, int ranks) {
    return std::clamp(std::int32_t(double(ranks) * place / whole), 0, ranks - 1);
}

// A place in the unit cube on the curve of Morton, 21 bits an axis: what is near on the curve is mostly near in space.
std::uint64_t morton_key(math::DVec3 p) {
    const auto spread = [](double x) {
        auto v = std::uint64_t(std::clamp(x, 0.0, 1.0) * double((1 << 21) - 1));
        v = (v | v << 32) & 0x1f00000000ffffULL;
        v = (v | v << 16) & 0x1f0000ff0000ffULL;
        v = (v | v << 8) & 0x100f00f00f00f00fULL;
        v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
        return (v | v << 2) & 0x1249249249249249ULL;
    };
    return spread(p.x) | spread(p.y) << 1 | spread(p.z) << 2;
}

// Gives the bodies to the ranks, each the same share of their contacts, along the curve.
void cut_along_curve(const Bodies& bodies, const std::vector<std::int32_t>& members, RankCut& cut) {
    math::DVec3 low = bodies.motion[members[0]].x, high = low;
    for (const std::int32_t b : members) {
        const math::DVec3 x = bodies.motion[b].x;
        low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
        high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
    const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-6});
    cut.keys.clear();
    double whole = 0;
    for (const std::int32_t b : members) {
        cut.keys.push_back(morton_key((1 / size) * (bodies.motion[b].x - low)));
        whole += 1.0 + bodies.links[b].contact_count;
    }
    double place = 0;
    for (const std::uint32_t k : order_by(cut.keys)) {
        const std::int32_t b = members[k];
        const double weight = 1.0 + bodies.links[b].contact_count;
        cut.owner[b] = part_at(place + 0.5 * weight, whole, cut.size);
        place += weight;
    }
}

// Which batches are cut; the others go to the ranks in their order, so that each has the same share of the work.
void share_out_whole(const std::vector<IslandBatch>& batches, RankCut& cut) {
    std::int32_t contacts = 0;
    for (const IslandBatch& batch : batches) contacts += batch.contact_count;
    const std::int32_t limit = std::max(min_cut_contacts, contacts / cut.size);
    cut.owner_of_batch.assign(batches.size(), every_rank);
    cut.weights.assign(batches.size(), 0);
    double whole = 0;
    for (std::size_t i = 0; i < batches.size(); ++i) {
        const IslandBatch& batch = batches[i];
        if (batch.joint_count > 0) continue;
        cut.owner_of_batch[i] = cut_by_body;
        if (batch.contact_count > limit) continue;
        cut.owner_of_batch[i] = 0;
        whole += cut.weights[i] = double(batch.body_count) + double(batch.substeps) * double(batch.contact_count);
    }
    double place = 0;
    for (std::size_t i = 0; i < batches.size(); ++i) {
        if (cut.owner_of_batch[i] < 0) continue;
        cut.owner_of_batch[i] = part_at(place + 0.5 * cut.weights[i], whole, cut.size);
        place += cut.weights[i];
    }
}

} // namespace

void cut_batches(const Bodies& bodies, Islands& islands, const WorldDef& settings, const Communicator& ranks,
                 SolverScratch& solver) {
    RankCut& cut = solver.cut;
    BatchScratch& scratch = solver.at_work[0];
    cut.rank = ranks.rank(), cut.size = ranks.size();
    share_out_whole(solver.batches, cut);
    cut.owner.resize(bodies.links.size());
    cut.parts.resize(std::size_t(cut.size));
    cut.free_bodies.clear();
    for (RankPart& part : cut.parts) part.bodies.clear(), part.contacts.clear();
    for (std::size_t i = 0; i < solver.batches.size(); ++i) {
        const IslandBatch& batch = solver.batches[i];
        const std::int32_t owner = cut.owner_of_batch[i];
        if (owner == every_rank) continue;
        gather_bodies(bodies, islands, settings, solver, batch, scratch, nullptr);
        cut.free_bodies.insert(cut.free_bodies.end(), scratch.free_bodies.begin(), scratch.free_bodies.end());
        const std::vector<std::int32_t>& members = scratch.touching_bodies;
        if (members.empty()) continue;
        if (owner == cut_by_body)
            cut_along_curve(bodies, members, cut);
        else
            for (const std::int32_t b : members) cut.owner[b] = owner;
        for (const std::int32_t b : members) cut.parts[std::size_t(cut.owner[b])].bodies.push_back(b);
        const SortedContact* const first = solver.of_batches.data() + batch.first_contact;
        for (const SortedContact* c = first; c != first + batch.contact_count; ++c)
            cut.parts[std::size_t(cut.owner[c->body_a])].contacts.push_back(c->id);
    }
}

} // namespace cairn
