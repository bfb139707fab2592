// Decides which rank solves which batches and contacts, and which rank owns which bodies.
#include "solver/rank_cut.h"

#include "contacts/record_owners.h"
#include "core/order.h"
#include "math/vec.h"
#include "solver/batch_rows.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace cairn {

namespace {

// Minimum number of contacts for a batch to be worth cutting: for fewer, the communication takes longer than the
// solving.
constexpr std::int32_t min_cut_contacts = 512;
// Factors for cutting anew: when some rank has more than `max_overload` times the mean load, and the new cut lowers the
// greatest load by more than a factor of `min_relief`, as moving records to other ranks takes about as long as testing
// pairs in several steps.
constexpr double max_overload = 1.1, min_relief = 1.05;

// Which of `ranks` equal parts of the length `whole` contains this place.
std::int32_t part_at(double place, double whole, int ranks) {
    return std::clamp(std::int32_t(double(ranks) * place / whole), 0, ranks - 1);
}

// Morton key of a point in the unit cube, 21 bits per axis: points that are close along the curve are mostly close in
// space.
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

double weight_of(const Bodies& bodies, std::int32_t body) { return 1.0 + bodies.links[body].contact_count; }

// Assigns bodies to the ranks along the space-filling curve, so that all ranks get the same share of contacts.
void cut_along_curve(const Bodies& bodies, std::span<const std::int32_t> members, RankCut& cut,
                     std::vector<std::int32_t>& owners) {
    if (members.empty()) return;
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
        whole += weight_of(bodies, b);
    }
    double place = 0;
    for (const std::uint32_t k : order_by(cut.keys)) {
        const std::int32_t b = members[k];
        const double weight = weight_of(bodies, b);
        owners[std::size_t(b)] = part_at(place + 0.5 * weight, whole, cut.size);
        place += weight;
    }
}

// Decides which batches are cut. The others are assigned to the ranks in their order, in equal shares of the work.
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

// Lists the bodies of the batches that are distributed, and weighs all islands. Bodies of the other batches belong to
// every rank.
void list_bodies(const Bodies& bodies, Islands& islands, const ForceFields& fields, const WorldDef& settings,
                 SolverScratch& solver, std::vector<std::int32_t>& owners) {
    RankCut& cut = solver.cut;
    BatchScratch& scratch = solver.at_work[0];
    cut.bodies_of_batch.assign(solver.batches.size(), {});
    cut.touching.clear(), cut.free_bodies.clear();
    for (std::size_t i = 0; i < solver.batches.size(); ++i) {
        const IslandBatch& batch = solver.batches[i];
        gather_bodies(bodies, islands, fields, settings, solver, batch, scratch, nullptr);
        const std::vector<std::int32_t>&touching = scratch.touching_bodies, &free = scratch.free_bodies;
        if (cut.owner_of_batch[i] == every_rank) {
            for (const std::int32_t b : touching) owners[std::size_t(b)] = every_rank;
            continue;
        }
        cut.bodies_of_batch[i] = {std::int32_t(cut.touching.size()), std::int32_t(touching.size())};
        cut.touching.insert(cut.touching.end(), touching.begin(), touching.end());
        cut.free_bodies.insert(cut.free_bodies.end(), free.begin(), free.end());
    }
}

// The greatest load of a rank over the mean; infinite while some bodies have no single owner.
double overload_of(const Bodies& bodies, RankCut& cut, const std::vector<std::int32_t>& owners) {
    cut.weights.assign(std::size_t(cut.size), 0);
    for (const std::vector<std::int32_t>* const list : {&cut.touching, &cut.free_bodies})
        for (const std::int32_t b : *list) {
            const std::int32_t owner = owners[std::size_t(b)];
            if (owner == every_rank) return std::numeric_limits<double>::infinity();
            cut.weights[std::size_t(owner)] += weight_of(bodies, b);
        }
    const double whole = std::accumulate(cut.weights.begin(), cut.weights.end(), 0.0);
    const double greatest = *std::max_element(cut.weights.begin(), cut.weights.end());
    return whole > 0 ? greatest * double(cut.size) / whole : 1.0;
}

// Assigns all bodies anew: those of batches that are cut, and free bodies, along the curve.
void cut_anew(const Bodies& bodies, RankCut& cut, std::vector<std::int32_t>& owners) {
    std::vector<std::int32_t> members = cut.free_bodies;
    for (std::size_t i = 0; i < cut.owner_of_batch.size(); ++i) {
        const std::span<const std::int32_t> touching = touching_of(cut, i);
        if (cut.owner_of_batch[i] == cut_by_body) members.insert(members.end(), touching.begin(), touching.end());
        if (cut.owner_of_batch[i] >= 0)
            for (const std::int32_t b : touching) owners[std::size_t(b)] = cut.owner_of_batch[i];
    }
    cut_along_curve(bodies, members, cut, owners);
}

// Gives bodies without a single owner the owner that they have in `anew`.
void adopt(const RankCut& cut, const std::vector<std::int32_t>& anew, std::vector<std::int32_t>& owners) {
    for (const std::vector<std::int32_t>* const list : {&cut.touching, &cut.free_bodies})
        for (const std::int32_t b : *list)
            if (owners[std::size_t(b)] == every_rank) owners[std::size_t(b)] = anew[std::size_t(b)];
}

// A batch that is not cut is solved by the rank that owns most of it; the other ranks hand over their bodies.
void unite_batches(const Bodies& bodies, RankCut& cut, std::vector<std::int32_t>& owners) {
    for (std::size_t i = 0; i < cut.owner_of_batch.size(); ++i) {
        const std::span<const std::int32_t> touching = touching_of(cut, i);
        if (cut.owner_of_batch[i] < 0 || touching.empty()) continue;
        cut.weights.assign(std::size_t(cut.size), 0);
        for (const std::int32_t b : touching) cut.weights[std::size_t(owners[std::size_t(b)])] += weight_of(bodies, b);
        const auto most = std::max_element(cut.weights.begin(), cut.weights.end()) - cut.weights.begin();
        cut.owner_of_batch[i] = std::int32_t(most);
        for (const std::int32_t b : touching) owners[std::size_t(b)] = std::int32_t(most);
    }
}

// Keeps the owners of the last step as long as the load is balanced well enough.
void choose_owners(const Bodies& bodies, RankCut& cut, std::vector<std::int32_t>& owners) {
    const double overload = overload_of(bodies, cut, owners);
    if (overload > max_overload) {
        std::vector<std::int32_t> anew = owners;
        cut_anew(bodies, cut, anew);
        adopt(cut, anew, owners);
        const double now = overload_of(bodies, cut, owners);
        if (now > max_overload && now > min_relief * overload_of(bodies, cut, anew)) owners.swap(anew);
    }
    unite_batches(bodies, cut, owners);
}

} // namespace

void share_out_records(const Bodies& bodies, Contacts& contacts, SolverScratch& solver, Communicator& ranks) {
    if (!contacts.records.is_whole()) return;
    if (!contacts.owners.of_body.empty()) return leave_records_to_owners(contacts);
    RankCut& cut = solver.cut;
    cut.rank = ranks.rank(), cut.size = ranks.size();
    std::vector<std::int32_t> members;
    for (std::int32_t b = 0; b < std::int32_t(bodies.links.size()); ++b)
        if (bodies.slots.is_live(std::uint32_t(b)) && bodies.is_dynamic(b) && bodies.links[b].joint_count == 0)
            members.push_back(b);
    cut.owner.assign(bodies.links.size(), every_rank);
    cut_along_curve(bodies, members, cut, cut.owner);
    change_owners(contacts, cut.owner, ranks);
}

void cut_batches(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                 const WorldDef& settings, Communicator& ranks, SolverScratch& solver) {
    RankCut& cut = solver.cut;
    cut.rank = ranks.rank(), cut.size = ranks.size();
    share_out_whole(solver.batches, cut);
    cut.owner = contacts.owners.of_body;
    cut.owner.resize(bodies.links.size(), every_rank);
    list_bodies(bodies, islands, fields, settings, solver, cut.owner);
    choose_owners(bodies, cut, cut.owner);
    if (cut.owner != contacts.owners.of_body) change_owners(contacts, cut.owner, ranks);
    cut.parts.resize(std::size_t(cut.size));
    for (RankPart& part : cut.parts) part.bodies.clear(), part.contacts.clear();
    for (const std::int32_t b : cut.touching) cut.parts[std::size_t(cut.owner[std::size_t(b)])].bodies.push_back(b);
    for (std::size_t i = 0; i < solver.batches.size(); ++i) {
        if (cut.owner_of_batch[i] == every_rank) continue;
        const SortedContact* const first = solver.of_batches.data() + solver.batches[i].first_contact;
        for (const SortedContact* c = first; c != first + solver.batches[i].contact_count; ++c)
            cut.parts[std::size_t(cut.owner[std::size_t(c->body_a)])].contacts.push_back(c->id);
    }
}

} // namespace cairn
