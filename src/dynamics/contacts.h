// From pairs of bounds to contact records: who touches whom, where, and with which impulses to begin.
#pragma once

#include "dynamics/state.h"

namespace cairn {

// Runs the broad phase; creates contacts for new pairs, destroys those of pairs that ended.
void update_pairs(State& state);

// The narrow phase: tests all pairs that may have moved, writes their records, begins and ends contacts in the
// islands and colors, wakes what is hit, and lists in State::solved what the solver has to do.
void update_contacts(State& state, float dt);

// After the solver: begin, end and hit events, sustained loads, counts.
void report_contacts(State& state, float dt);

// --- one contact (contact_points.cpp)

// Arm and separation of a point; its normal impulse summed over the last step's substeps.
inline const float* point_of(const ContactRecord& r, int i) { return i == 0 ? r.first_point : r.more_points[i - 1]; }
inline float* point_of(ContactRecord& r, int i) { return i == 0 ? r.first_point : r.more_points[i - 1]; }
inline float total_of(const ContactRecord& r, int i) { return i == 0 ? r.first_total : r.more_totals[i - 1]; }

// Writes the record of a contact from the kernel's manifold, which has points. Impulses go on where points stay.
void write_record(State& state, std::uint32_t contact, const Manifold& manifold);
// `count`: how many points it has.
void forget_impulses(ContactRecord& record, int count);
// A record that was written at the start of the last step, moved to the poses at its end.
ContactRecord advanced_record(const State& state, std::uint32_t contact);

// Coefficients of the two materials together, by the rules of KHR_physics_rigid_bodies.
void combine_materials(State& state, std::uint32_t contact);

// Which kernel tests the two, or -1 when none does (two planes); `swapped`: b is the kernel's first shape.
int pair_kind(ShapeType a, ShapeType b, bool& swapped);
CollideKernel pair_kernel(int kind);

} // namespace cairn
