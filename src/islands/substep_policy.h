// How many substeps an island takes: one function of what it is made of and of what it bears now.
//
// A soft contact with the reduced mass m sinks under a load F by F / (m omega^2), with omega in proportion to the
// number of substeps n. So the overlap depends on the demand F / m, an acceleration, alone, and n in proportion to its
// root keeps overlaps alike. In a heap many contacts share the weight, and the demand is what its layers pull, each by
// g: that overlaps are alike beside the width w of its bodies, whatever their scale, asks for n in proportion to the
// root of g / w (Froude). In a slender structure (a tower, a heavy box on light ones) one contact carries a good part
// of all the weight, its share. Hence
//
//     n = max(usual, sqrt(0.36 g / w), share x sqrt(demand)),    demand in m/s^2,
//
// where `usual` is the world's number, or 11 where joints are: the error of soft rows in motion falls with the square
// of n; and at least as many as keep what stands from buckling (slenderness.h). That is for a step of 1/60 s: what
// counts is how long a substep is, so shorter steps take fewer in proportion, longer ones more. It looks at the scene
// alone, so that results do not depend on threads. docs/decisions/substeps.md has the measurements.
#pragma once

#include "bodies/integrators.h"
#include "state/state.h"
#include "state/step_scratch.h"
#include "state/substeps.h"

#include <algorithm>
#include <limits>

namespace cairn {

inline constexpr float min_substeps_per_period = 6, max_substeps_per_period = 8; // softness.h
inline constexpr float stiff_factor = 2; // of the frequency: contacts with what does not move, and joints

// What the policy looks at.
struct IslandLoad {
    bool has_joints;
    float share;             // of the island's weight that its most loaded contact carries
    float demand;            // m/s^2: the greatest ratio of load to reduced mass of a contact
    float stable_sinking;    // m: how far contacts may sink (slenderness.h)
    float pull_by_width = 0; // 1/s^2: see slenderness.h
};
int wanted_substeps(const WorldDef& settings, const IslandLoad& load, float dt);

// What the contacts of an island carried in the last step. Nothing can buckle yet.
IslandLoad load_of(const Island& island);
// To be measured anew in the solver.
inline void forget_load(Island& island) { island.greatest_load = island.greatest_demand = 0; }
// Whether its places alone may ask for more substeps than its loads: then its column is looked at.
bool may_be_slender(const WorldDef& settings, const Island& island, IslandLoad load, float dt);

// What a contact that begins may have to carry: the weight of the body above. Normal from A to B.
float first_load(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, const ContactInfo& contact,
                 math::Vec3 normal);
// More than that share of the weight comes from being squeezed between immovable things: no stiffness helps there.
inline constexpr float max_share = 1.2f;

// In usual steps: the time constant of the low-pass filter for loads, and what it takes over in a step of dt seconds.
inline constexpr float load_time = 3;
inline float load_gain(float dt) {
    const float steps = dt / usual_step;
    return steps / (steps + load_time);
}
// m/s: bodies that move that fast against each other are no structure, and their loads are impacts, however long they
// last.
inline constexpr float max_agitation = 1.0f;
// m/s^2: what a load asks for, by the sum of the inverse masses that bear it.
inline float demand_of(const ContactInfo& c, float load, float inverse_mass) {
    const float stiffness = c.b_moves ? 1.0f : stiff_factor * stiff_factor;
    return load * (inverse_mass / stiffness);
}

// After a step: the normal force that a contact carried, and the sum of the inverse masses that bore it; `gain`: see
// load_gain. Others may be at work on other contacts of the island.
inline void note_load(Island& island, ContactInfo& c, float force, float inverse_mass, float gain) {
    // The lesser of two steps: impacts last one step, loads stay. Of what is agitated, they only fall.
    const float most = island.agitation > max_agitation ? c.load : force;
    c.load += gain * (std::min(std::min(force, c.force), most) - c.load);
    if (c.load < std::numeric_limits<float>::min()) c.load = 0; // subnormal numbers take processors long to add
    c.force = force;
    const float load = std::min(c.load, max_share * island.weight);
    raise(island.greatest_load, load);
    raise(island.greatest_demand, demand_of(c, load, inverse_mass));
}

} // namespace cairn
