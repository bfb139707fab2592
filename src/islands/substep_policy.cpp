#include "islands/substep_policy.h"

#include "bodies/integrators.h"
#include "islands/slenderness.h"

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

constexpr int max_adaptive_substeps = 128;
constexpr int joint_substeps = 11; // at least so many per usual step in islands with joints
// The share of an island's weight on one contact from which on that contact alone decides. A smaller share counts in
// proportion: bodies squeezed somewhere in a heap are no structure.
constexpr float full_share = 1.0f / 3;
// s^2, factor of g / w: under earth's gravity, the usual six substeps are enough for bodies that are 10 cm wide.
constexpr float by_width = 0.36f;

// Rounds up to a multiple of 8, so that more islands have the same number and can be solved together; numbers up to 12
// to a multiple of 4, and up to 4 to a whole number, as they would grow by more than half.
int rounded_up(float wanted) {
    if (wanted <= 4) return int(std::ceil(wanted));
    const int unit = wanted <= 12 ? 4 : 8;
    return (int(std::min(wanted, float(max_adaptive_substeps))) + unit - 1) / unit * unit;
}

} // namespace

int wanted_substeps(const WorldDef& settings, const IslandLoad& load, float dt) {
    const int own = substeps_of(settings, dt);
    if (!settings.adaptive_substeps) return own;
    const int usual = load.has_joints ? std::max(own, substeps_in(dt, joint_substeps)) : own;
    const float weight = std::min(load.share / full_share, 1.0f);
    // The contact stiffness that a number of substeps gives: see softness.h.
    const float periods = std::sqrt(load.demand / load.stable_sinking) * usual_step / (2 * 3.14159265f);
    const float so_as_to_stand = (periods > 1 ? max_substeps_per_period : min_substeps_per_period) * periods;
    const float for_its_size = std::sqrt(by_width * load.pull_by_width);
    const float wanted = std::max({weight * std::sqrt(load.demand), for_its_size, so_as_to_stand}) * (dt / usual_step);
    return wanted > float(usual) ? std::max(usual, rounded_up(wanted)) : usual;
}

IslandLoad load_of(const Island& island) {
    return {island.joint_count > 0, island.weight > 0 ? island.greatest_load / island.weight : 0,
            island.greatest_demand, nothing_can_buckle, island.pull_by_width};
}

bool may_be_slender(const WorldDef& settings, const Island& island, IslandLoad load, float dt) {
    if (load.has_joints || !(load.demand > 0)) return false; // structures with joints do not sink
    const int for_loads = wanted_substeps(settings, load, dt);
    load.stable_sinking = island.min_buckling_penetration;
    return wanted_substeps(settings, load, dt) > for_loads;
}

float first_load(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, const ContactInfo& c,
                 math::Vec3 normal) {
    const auto pull_on = [&](std::int32_t body) {
        return float(math::dot(math::to_double(normal), pull_at(bodies, fields, settings, body)));
    };
    const float pull = pull_on(c.body_a); // positive: B is below
    if (pull < 0 && !c.b_moves) return 0;
    const BodyMass& above = bodies.mass[pull >= 0 ? c.body_a : c.body_b];
    return above.inverse_mass > 0 ? above.mass * std::fabs(pull >= 0 ? pull : pull_on(c.body_b)) : 0;
}

} // namespace cairn
