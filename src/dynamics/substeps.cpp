// How many substeps an island takes. A soft contact sinks under its load F by F / (m w^2), with m the reduced mass of
// its two bodies and w in proportion to the number of substeps n; what matters is the demand F / m. In a heap the load
// is spread over many contacts and the default is enough. In a slender structure (a tower, a heavy box on light ones)
// one contact carries a good part of all the weight (its share): there n grows with the square root of the demand. The
// rule looks at the scene alone, so that results do not depend on threads. docs/decisions/substeps.md has the
// measurements.
#include "dynamics/joints.h"
#include "dynamics/solver.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr float substeps_per_demand = 0.95f; // n = this x sqrt(demand in m/s^2) at 60 steps per second
constexpr float load_gain = 0.25f;           // of the low-pass filter over steps
constexpr float full_share = 1.0f / 3.0f;    // of the island's weight on one contact: slender
constexpr float immovable_stiffness = 4.0f;  // contacts with what does not move are so much stiffer
constexpr float most_of_weight = 1.2f;
constexpr int most_adaptive_substeps = 128;
// A number is kept until this share of it would do, or that share of the base.
constexpr float least_use = 0.5f, least_of_base = 0.8f;
// m/s: what is tossed about more than that is no structure, and its loads are impacts, however long they last.
constexpr float most_unrest = 1.0f;

// Up to a multiple of 8, as islands of one number are solved together; few are not made half as many again.
int rounded_up(float wanted) {
    const int least = wanted <= 12 ? 4 : 8;
    return (int(std::min(wanted, float(most_adaptive_substeps))) + least - 1) / least * least;
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
    c.load += load_gain * (std::min({force, c.force, most}) - c.load);
    c.force = force;
    // More than the weight of all comes from being squeezed between immovable things: no stiffness helps there.
    const float load = std::min(c.load, most_of_weight * island.weight);
    const float stiffness = c.b_moves ? 1.0f : immovable_stiffness;
    raise(island.greatest_load, load);
    raise(island.greatest_demand, load * (inverse_mass / stiffness));
}

int island_substeps(const State& s, Island& island) {
    int base = s.settings.substeps;
    if (s.settings.adaptive_substeps && island.joint_count > 0) base = std::max(base, joint_substeps);
    if (s.settings.adaptive_substeps && island.weight > 0) {
        const float share = std::min(island.greatest_load / (full_share * island.weight), 1.0f);
        const float wanted = substeps_per_demand * share * std::sqrt(island.greatest_demand);
        const int rounded = rounded_up(wanted), now = island.wanted_substeps;
        const float least = std::max(least_use * float(now), least_of_base * float(base));
        const bool keep = (rounded <= now && wanted > least) || (rounded > now && island.unrest > most_unrest);
        if (!keep) island.wanted_substeps = wanted > float(base) ? rounded : 0;
    } else {
        island.wanted_substeps = 0;
    }
    island.greatest_load = island.greatest_demand = 0;
    return s.in_pass(std::max(base, int(island.wanted_substeps)));
}

} // namespace cairn
