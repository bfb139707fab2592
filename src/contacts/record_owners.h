// Contact records on several ranks: each has those of its own bodies (state/contact_records.h). All of this is done by
// all ranks together.
#pragma once

#include "state/state.h"

#include <cairn/communicator.h>

#include <span>
#include <vector>

namespace cairn {

// The owner of a contact: of its body A.
inline std::int32_t owner_of(const Contacts& contacts, std::uint32_t contact) {
    return contacts.owners[contacts.info[contact].body_a];
}

// Fills in a list that all ranks have with the same elements: each of them is told by its owner. `begin(element)`
// writes what this rank knows of it, and returns its owner; every_rank: all know it.
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

// The normal of its record, for all ranks; null: this process alone.
math::Vec3 normal_of(const Contacts& contacts, std::uint32_t contact, Communicator* ranks);

// Those of many at once.
void find_normals(const Contacts& contacts, std::vector<ContactNormal>& list, Communicator* ranks);

// Gives bodies to other ranks; the records of their contacts go with them. `owners`: of all bodies.
void change_owners(Contacts& contacts, const std::vector<std::int32_t>& owners, Communicator& ranks);

// All ranks get all records, for a snapshot or to be asked about. They keep them until the next step.
void gather_records(Contacts& contacts, Communicator& ranks);
// Before a step: each keeps its own alone again.
void leave_records_to_owners(Contacts& contacts);

} // namespace cairn
