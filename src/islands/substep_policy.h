// The number of substeps of an island, a function of its structure and its present loads only.
//
// Under a load F, a soft contact with the reduced mass m sinks by F / (m omega^2), where omega is proportional to the
// number of substeps n. So penetration depends only on the demand F / m, an acceleration, and n proportional to its
// square root keeps penetrations alike. In a heap many contacts share the weight, and the demand is the weight of its
// layers, g each: penetrations that are alike relative to the width w of the bodies, at any scale, require n
// proportional to the square root of g / w (Froude). In a slender structure (a tower, a heavy box on light ones) one
// contact carries a large share of the weight. Hence
//
//     n = max(usual, sqrt(0.36 g / w), share x sqrt(demand)),    demand in m/s^2,
//
// where `usual` is the world's number, or at least 11 with joints, as the error of soft rows in motion is proportional
// to 1 / n^2; and n is at least what keeps a structure from buckling (slenderness.h). This is for a step of 1/60 s: as
// the length of substeps matters, n is proportional to the length of the step. It depends on the scene alone, so that
// results do not depend on threads. docs/decisions/substeps.md has the measurements.
#pragma once

#include "bodies/integrators.h"
#include "state/state.h"
#include "state/step_scratch.h"
#include "state/substeps.h"

#include <algorithm>
#include <limits>

namespace cairn {

// Bounds of the period of a soft constraint's spring, in substeps: see softness.h.
inline constexpr float min_substeps_per_period = 6, max_substeps_per_period = 8;
inline constexpr float stiff_factor = 2; // for the frequency of contacts with immovable bodies, and of joints

// The quantities that the number of substeps depends on.
struct IslandLoad {
    bool has_joints;
    float share;             // of the island's weight, on its most loaded contact
    float demand;            // m/s^2: greatest ratio of load to reduced mass of a contact
    float stable_sinking;    // m: how far contacts may sink without buckling (slenderness.h)
    float pull_by_width = 0; // 1/s^2: see slenderness.h
};
int wanted_substeps(const WorldDef& settings, const IslandLoad& load, float dt);

// The loads that the contacts of an island carried in the last step; stable_sinking is left at `nothing_can_buckle`.
IslandLoad load_of(const Island& island);
// Resets the loads, before the solver measures them again.
inline void forget_load(Island& island) { island.greatest_load = island.greatest_demand = 0; }
// Whether the shape of an island may require more substeps than its loads do: then it is treated as a column.
bool may_be_slender(const WorldDef& settings, const Island& island, IslandLoad load, float dt);

// The load that a contact may have to carry when it begins: the weight of the body above. Normal from A to B.
float first_load(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, const ContactInfo& contact,
                 math::Vec3 normal);
// Upper limit of a load, as a share of the weight: greater ones come from being squeezed between immovable bodies,
// where stiffness does not help.
inline constexpr float max_share = 1.2f;

// Time constant of the low-pass filter for loads, in usual steps, and the filter's gain in a step of dt seconds.
inline constexpr float load_time = 3;
inline float load_gain(float dt) {
    const float steps = dt / usual_step;
    return steps / (steps + load_time);
}
// m/s: if bodies move faster relative to each other, they are no structure, and their loads are impacts, however long
// these last.
inline constexpr float max_agitation = 1.0f;
// The demand of a load, m/s^2; `inverse_mass`: the sum of the inverse masses that carry it.
inline float demand_of(const ContactInfo& c, float load, float inverse_mass) {
    const float stiffness = c.b_moves ? 1.0f : stiff_factor * stiff_factor;
    return load * (inverse_mass / stiffness);
}

// After a step: records the normal force of a contact, and the sum of the inverse masses that carry it; `gain`: see
// load_gain. Other threads may update other contacts of the island meanwhile.
inline void note_load(Island& island, ContactInfo& c, float force, float inverse_mass, float gain) {
    // The lesser force of two steps counts: impacts last one step, loads longer. In agitated islands loads only
    // decrease.
    const float most = island.agitation > max_agitation ? c.load : force;
    c.load += gain * (std::min(std::min(force, c.force), most) - c.load);
    if (c.load < std::numeric_limits<float>::min()) c.load = 0; // subnormal numbers slow down additions
    c.force = force;
    const float load = std::min(c.load, max_share * island.weight);
    raise(island.greatest_load, load);
    raise(island.greatest_demand, demand_of(c, load, inverse_mass));
}

} // namespace cairn
