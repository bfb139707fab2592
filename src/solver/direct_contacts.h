// Contacts of bodies whose joints are solved directly.
//
// Geometric stiffness raises the inertia of such bodies under tension (joints/direct_joints.h). If a contact turned a
// body with its own, smaller inertia, the joints would take the rotation for that of the raised one, which is a larger
// moment than the contact has given, and pass it on: energy out of nothing. So both use the raised inertia.
#pragma once

#include "state/direct_sets.h"
#include "state/step_scratch.h"

namespace cairn {

// Lists the contacts of the bodies of sets that contacts touch. Called after the direct rows are filled.
void list_direct_contacts(const DirectSets& direct, BatchScratch& scratch);
// Writes the inertia with which these sets are solved in this substep to the rows of their bodies. Called after the
// sets have begun a substep, and again after the inertia of rows has been renewed.
void share_inertia(const DirectSets& direct, BatchScratch& scratch);
// Gives the listed contacts the inertia of the rows.
void renew_direct_contacts(BatchScratch& scratch, ThreadPool* thread_pool);

} // namespace cairn
