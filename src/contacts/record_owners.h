// Contact records on several ranks: each has those of its own bodies (state/contact_records.h). All of this is done by
// all ranks together.
#pragma once

#include "state/state.h"

#include <cairn/communicator.h>

namespace cairn {

// The owner of a contact: of its body A.
inline std::int32_t owner_of(const Contacts& contacts, std::uint32_t contact) {
    return contacts.owners[contacts.info[contact].body_a];
}

// The normal of its record, for all ranks; null: this process alone.
math::Vec3 normal_of(const Contacts& contacts, std::uint32_t contact, Communicator* ranks);

// Gives bodies to other ranks; the records of their contacts go with them. `owners`: of all bodies.
void change_owners(Contacts& contacts, const std::vector<std::int32_t>& owners, Communicator& ranks);

// All ranks get all records, for a snapshot or to be asked about. They keep them until the next step.
void gather_records(Contacts& contacts, Communicator& ranks);
// Before a step: each keeps its own alone again.
void leave_records_to_owners(Contacts& contacts);

} // namespace cairn
