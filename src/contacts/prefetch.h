// What the cache is asked for before a pair is tested.
#pragma once

#include "core/cache.h"
#include "state/state.h"

namespace cairn {

// Asks the cache for what the test of a pair of convex shapes, or of one with a surface, begins with.
void prefetch_pair(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, std::uint32_t contact);
inline void prefetch_record(const Contacts& contacts, std::uint32_t contact, std::size_t size = sizeof(ContactRecord)) {
    const char* record = reinterpret_cast<const char*>(&contacts.records[contact]);
    for (std::size_t at = 0; at < size; at += 64) ask_cache(record + at);
}
// Likewise for the patch number n of a group, which is found along those before it: each is asked for somewhat later
// than the one before. Nothing for contacts that are no groups.
inline constexpr int patches_at_hand = 3;
inline constexpr std::size_t patch_ahead(int n) { return std::size_t(2 * (patches_at_hand - n)); }
void prefetch_patch(const Contacts& contacts, std::uint32_t contact, int n, bool with_record);

} // namespace cairn
