// How many substeps an island takes. A soft contact sinks under its load F by F / (m w^2), with m the reduced mass of
// its two bodies and w in proportion to the number of substeps n; what matters is the demand F / m. In a heap the load
// is spread over many contacts and the default is enough. In a slender structure (a tower, a heavy box on light ones)
// one contact carries a good part of all the weight (its share): there n grows with the square root of the demand. The
// rule looks at the scene alone, so that results do not depend on threads. docs/decisions/substeps.md has the
// measurements. Joints are soft too: there it is the mean demand of an island's joints that counts.
#include "islands/substeps.h"

#include "state/joint_links.h"
#include "state/state.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr float substeps_per_demand = 0.95f; // n = this x sqrt(demand in m/s^2) at 60 steps per second
constexpr float least_load = 1e-12f;         // N: less is none; numbers that fade away take processors long to add
constexpr float full_share = 1.0f / 3.0f;    // of the island's weight on one contact: slender
constexpr float least_share = 0.125f;        // of that: what is squeezed somewhere in a heap is no structure
constexpr float immovable_stiffness = 4.0f;  // contacts with what does not move are so much stiffer
constexpr float most_of_weight = 1.2f;
constexpr int most_adaptive_substeps = 128;
// A number is kept until this share of it would do, or that share of the base.
constexpr float least_use = 0.5f, least_of_base = 0.8f;
// m/s: what is tossed about more than that is no structure, and its loads are impacts, however long they last.
constexpr float most_unrest = 1.0f;

constexpr int net_substeps = 7, heap_substeps = 8;          // of many joints in motion
constexpr float most_demand = 1000, demand_to_return = 900; // m/s^2: above they take more, until below that again
constexpr std::int32_t many_in_heap = 100, many_joints = 1000;

// Of a heap at rest, likewise.
constexpr float substeps_per_heap_demand = 0.21f, substeps_per_joint_demand = 1.0f / 3;
constexpr float usual_substeps = 6, tossed_part = 2.0f / 3;
constexpr std::int32_t many_contacts = 256;
constexpr float most_spare_substeps = 1.5f, least_spare_substeps = 0.1f; // before fewer are taken
constexpr float rest_begins = 0.25f, rest_ends = 0.5f; // m/s: unrest of a heap that comes to rest, or is stirred up

// Up to a multiple of 8, as islands of one number are solved together; few are not made half as many again.
int rounded_up(float wanted) {
    const int least = wanted <= 12 ? 4 : 8;
    return (int(std::min(wanted, float(most_adaptive_substeps))) + least - 1) / least * least;
}

// Many contacts, and one to go with each joint, if there are any: then many joints.
bool is_heap(const Island& island, std::int32_t contacts) {
    const std::int32_t joints = island.joint_count;
    return joints == 0 ? contacts >= many_contacts : joints >= many_in_heap && contacts >= joints;
}

// What was tossed into a heap takes fewer than what was built as it stands: no stone of a castle must move, and a heap
// lies as it fell. Of heaps without joints the most loaded contact tells how few, as those of all sink together; of
// those with joints the joints do, as some limb is always squeezed.
int substeps_at_rest(const State& s, const Island& island) {
    const float usual = float(s.settings.substeps), least = (island.was_tossed ? tossed_part : 1.0f) * usual;
    float wanted = 0, most = usual;
    if (island.joint_count == 0) {
        wanted = substeps_per_heap_demand * std::sqrt(island.greatest_demand) * (usual / usual_substeps);
    } else {
        wanted = substeps_per_joint_demand * std::sqrt(island.joint_demand) * (least / usual);
        most = std::max(float(joint_substeps), usual);
    }
    const float now = float(island.rest_substeps);
    const bool keep = wanted <= now && wanted >= std::max(now - most_spare_substeps, least - least_spare_substeps);
    return keep ? island.rest_substeps : int(std::ceil(std::clamp(wanted, least, most)));
}

// Few joints always take the most, which costs little: so what swings on them moves as it should, and limbs come to
// rest sooner. The number of many does not follow closely what they bear: each change of it changes the gaps of all
// joints, and a hanging net that bounced was kept bouncing. In a heap they bear impacts, which say nothing.
int substeps_in_motion(const State& s, Island& island, bool is_heap) {
    const std::int32_t joints = island.joint_count;
    if (joints == 0) return s.settings.substeps;
    int n = joint_substeps;
    if (is_heap || joints >= many_joints) {
        const float most = island.joint_substeps == joint_substeps ? demand_to_return : most_demand;
        n = is_heap ? heap_substeps : island.joint_demand > most ? joint_substeps : net_substeps;
    }
    island.joint_substeps = n;
    return std::max(n, s.settings.substeps);
}

// Without regard to what is slender.
int base_substeps(const State& s, Island& island, std::int32_t contacts) {
    if (!s.settings.adaptive_substeps) {
        island.joint_substeps = island.rest_substeps = 0;
        return s.settings.substeps;
    }
    const bool heap = is_heap(island, contacts);
    if (heap && island.unrest > most_unrest) island.was_tossed = 1;
    if (!heap || !(island.unrest < (island.rest_substeps > 0 ? rest_ends : rest_begins))) {
        island.rest_substeps = 0;
        return substeps_in_motion(s, island, heap);
    }
    island.joint_substeps = 0;
    return island.rest_substeps = substeps_at_rest(s, island);
}

} // namespace

float first_load(const State& s, const ContactInfo& c, math::Vec3 normal) {
    const auto& g = s.settings.gravity;
    const float pull = math::dot(normal, math::Vec3{g.x, g.y, g.z}); // > 0: B is below
    if (pull < 0 && !c.b_moves) return 0;
    const BodyMass& above = s.mass[std::size_t(pull >= 0 ? c.body_a : c.body_b)];
    return above.inverse_mass > 0 ? above.mass * std::fabs(pull) : 0;
}

void note_load(Island& island, ContactInfo& c, float force, float inverse_mass) {
    // The lesser of two steps: impacts last one step, loads stay. Of what is tossed about, they only fall.
    const float most = island.unrest > most_unrest ? c.load : force;
    c.load += load_gain * (std::min(std::min(force, c.force), most) - c.load);
    if (c.load < least_load) c.load = 0;
    c.force = force;
    // More than the weight of all comes from being squeezed between immovable things: no stiffness helps there.
    const float load = std::min(c.load, most_of_weight * island.weight);
    const float stiffness = c.b_moves ? 1.0f : immovable_stiffness;
    raise(island.greatest_load, load);
    raise(island.greatest_demand, load * (inverse_mass / stiffness));
}

int island_substeps(const State& s, Island& island, std::int32_t contacts) {
    const int base = base_substeps(s, island, contacts), usual = std::max(base, s.settings.substeps);
    if (s.settings.adaptive_substeps && island.weight > 0) {
        const float part = std::min(island.greatest_load / (full_share * island.weight), 1.0f);
        const float share = std::max(part - least_share, 0.0f) / (1 - least_share);
        const float wanted = substeps_per_demand * share * std::sqrt(island.greatest_demand);
        const int rounded = rounded_up(wanted), now = island.wanted_substeps;
        const float least = std::max(least_use * float(now), least_of_base * float(usual));
        const bool keep = (rounded <= now && wanted > least) || (rounded > now && island.unrest > most_unrest);
        if (!keep) island.wanted_substeps = wanted > float(usual) ? rounded : 0;
    } else {
        island.wanted_substeps = 0;
    }
    island.greatest_load = island.greatest_demand = 0;
    return s.in_pass(std::max(base, int(island.wanted_substeps)));
}

} // namespace cairn
