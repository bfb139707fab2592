// Groups: pairs of a convex shape with a mesh or height field, and the patches in which they touch.
#pragma once

#include "contacts/contexts.h"

namespace cairn {

// f(contact) for the patches of a group, or for the contact itself if it is none. f may free the contact.
template <class F> void for_each_patch(const Contacts& contacts, std::uint32_t id, F&& f) {
    if (!is_group(contacts.info[id])) {
        f(id);
        return;
    }
    for (std::int32_t p = contacts.info[id].related; p != none;) {
        const std::int32_t next = contacts.info[p].next;
        f(std::uint32_t(p));
        p = next;
    }
}

// Whether the contact does, or a patch of the group.
bool touches(const Contacts& contacts, const ContactInfo& contact);

void begin_groups(const Contacts& contacts, NarrowScratch& narrow);
// Tests groups, by their places in the list of groups. Others may be at work on other groups.
void test_groups(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, int begin, int end, NarrowBatch& own,
                 float dt);
// Of one of them, at that place among the candidates, that might have met in flight and is held: what touches becomes
// patches.
void test_held_group(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, std::uint32_t place,
                     NarrowBatch& own, float dt);
// Puts the patches that threads have found in the order of the groups.
void collect_fresh_patches(NarrowScratch& narrow);
// The group at that place among the candidates.
void follow_up_group(const FollowUpContext& context, std::uint32_t place, float dt);
// The patch of a group with a normal from A, on triangles of that material, or a new one, without points.
std::uint32_t patch_along(const Shapes& shapes, Contacts& contacts, std::uint32_t group, math::Vec3 normal,
                          std::uint16_t surface_material, Communicator* ranks);
// Ends a patch, and takes it out of its group.
void end_patch(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands, StepEvents& events,
               std::uint32_t patch);

} // namespace cairn
