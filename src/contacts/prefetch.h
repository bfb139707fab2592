// Prefetches into the cache for pair tests.
#pragma once

#include "core/cache.h"
#include "state/state.h"

namespace cairn {

// Prefetches what the test of a convex pair, or of a mesh contact, begins with.
void prefetch_pair(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, std::uint32_t contact);
// Prefetches the record of a contact, if this rank has it.
inline void prefetch_record(const Contacts& contacts, std::uint32_t contact) {
    if (!contacts.records.has(contact)) return;
    const char* record = reinterpret_cast<const char*>(&contacts.records[contact]);
    for (std::size_t at = 0; at < sizeof(ContactRecord); at += 64) prefetch(record + at);
}
// Prefetches patch number n of a mesh contact, if the contact is one. Patches form a linked list, so each is prefetched
// later than the patch before it.
inline constexpr int patches_at_hand = 3;
inline constexpr std::size_t patch_ahead(int n) { return std::size_t(2 * (patches_at_hand - n)); }
void prefetch_patch(const Contacts& contacts, std::uint32_t contact, int n, bool with_record);

} // namespace cairn
