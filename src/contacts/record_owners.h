// Contact records on several ranks: each rank has those of its own bodies (state/contact_records.h). All ranks call
// these functions together.
#pragma once

#include "state/state.h"

#include <cairn/communicator.h>

#include <span>
#include <vector>

namespace cairn {

// The owner of a contact: that of its body A.
inline std::int32_t owner_of(const Contacts& contacts, std::uint32_t contact) {
    return contacts.owners[contacts.info[contact].body_a];
}

// Completes a list that has the same elements on all ranks: the owner of each element broadcasts it. `begin(element)`
// writes what this rank knows of the element, and returns its owner; every_rank: all ranks know it.
template <class T, class F> void exchange_of_owners(std::vector<T>& list, Communicator& ranks, F&& begin) {
    std::vector<std::vector<std::size_t>> places(std::size_t(ranks.size())); // in the list, by owner
    for (std::size_t k = 0; k < list.size(); ++k)
        if (const std::int32_t owner = begin(list[k]); owner != every_rank) places[std::size_t(owner)].push_back(k);
    std::vector<T> part;
    for (int root = 0; root < ranks.size(); ++root) {
        const std::vector<std::size_t>& own = places[std::size_t(root)];
        if (own.empty()) continue;
        part.clear();
        for (const std::size_t k : own) part.push_back(list[k]);
        ranks.broadcast(root, std::as_writable_bytes(std::span(part)));
        for (std::size_t k = 0; k < own.size(); ++k) list[own[k]] = part[k];
    }
}

// The normal in a contact's record, on all ranks; `ranks` null: this process alone.
math::Vec3 normal_of(const Contacts& contacts, std::uint32_t contact, Communicator* ranks);

// The normals of many contacts at once.
void find_normals(const Contacts& contacts, std::vector<ContactNormal>& list, Communicator* ranks);

// Gives bodies to other ranks, and sends along the records of their contacts. `owners`: of all bodies.
void change_owners(Contacts& contacts, const std::vector<std::int32_t>& owners, Communicator& ranks);

// Gives all ranks all records, for a snapshot or for queries. They keep these until the next step.
void gather_records(Contacts& contacts, Communicator& ranks);
// Before a step: each rank keeps the records of its own bodies alone.
void leave_records_to_owners(Contacts& contacts);

} // namespace cairn
