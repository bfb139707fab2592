// Mesh contacts ("groups" in the code): pairs of a convex shape with a mesh or height field, and the patches of each,
// one contact per direction in which the shapes touch.
#pragma once

#include "contacts/contexts.h"

namespace cairn {

// Calls f(contact) for the patches of a mesh contact, or for the contact itself if it is none. f may free the contact.
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

// Whether a contact, or any patch of a mesh contact, touches.
bool touches(const Contacts& contacts, const ContactInfo& contact);

void begin_groups(const Contacts& contacts, NarrowScratch& narrow);
// Tests mesh contacts, by their places in the list of these. Other threads may test others meanwhile.
void test_groups(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, int begin, int end, NarrowBatch& own,
                 float dt);
// Tests the mesh contact at that place among the candidates, which might have met in free flight, but whose bodies are
// constrained: its manifolds become patches.
void test_held_group(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, std::uint32_t place,
                     NarrowBatch& own, float dt);
// Sorts the new patches that all threads have found into the order of their mesh contacts.
void collect_fresh_patches(NarrowScratch& narrow);
// Applies the outcome of the mesh contact at that place among the candidates, as follow_up does.
void follow_up_group(const FollowUpContext& context, std::uint32_t place, float dt);
// Returns the patch of a mesh contact with about this normal from A and this material, or a new one without points.
std::uint32_t patch_along(const Shapes& shapes, Contacts& contacts, std::uint32_t group, math::Vec3 normal,
                          std::uint16_t surface_material, Communicator* ranks);
// Ends a patch, and takes it out of its mesh contact.
void end_patch(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands, StepEvents& events,
               std::uint32_t patch);

} // namespace cairn
