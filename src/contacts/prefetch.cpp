
#include "contacts/prefetch.h"

#include "core/cache.h"

namespace cairn {

void prefetch_pair(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, std::uint32_t id) {
    const ContactInfo& c = contacts.info[id];
    for (const std::uint32_t shape : {c.shape_a, c.shape_b}) {
        prefetch(&shapes.poses[shape]);
        prefetch(&shapes.geometry[shape]);
        prefetch(&shapes.geometry[shape].is_double_sided);
        prefetch(&shapes.data[shape]);
        prefetch(&shapes.links[shape]);
    }
    for (const std::int32_t body : {c.body_a, c.body_b}) {
        prefetch(&bodies.motion[body].v);
        prefetch(&bodies.links[body].radius);
    }
    prefetch_record(contacts, id); // the whole record: another thread may be about to change the number of points
}

void prefetch_patch(const Contacts& contacts, std::uint32_t id, int n, bool with_record) {
    if (!is_group(contacts.info[id])) return;
    std::int32_t patch = contacts.info[id].related;
    for (; n > 0 && patch != none; --n) patch = contacts.info[patch].next;
    if (patch == none) return;
    prefetch(&contacts.info[patch]);
    if (with_record) prefetch_record(contacts, std::uint32_t(patch));
}

} // namespace cairn
