// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

using namespace cairn::c_api;
using namespace cairn;

cairn_result cairn_world_get_contact_begins(const cairn_world* world, cairn_contact_begin* contact_begins,
                                            size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(contact_begins, capacity, count, "contact_begins");
        write_list(world_of(world).contact_begins(), contact_begins, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_get_contact_ends(const cairn_world* world, cairn_contact_end* contact_ends, size_t capacity,
                                          size_t* count) {
    return guarded([&] {
        require_room(contact_ends, capacity, count, "contact_ends");
        write_list(world_of(world).contact_ends(), contact_ends, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_get_contact_hits(const cairn_world* world, cairn_contact_hit* contact_hits, size_t capacity,
                                          size_t* count) {
    return guarded([&] {
        require_room(contact_hits, capacity, count, "contact_hits");
        write_list(world_of(world).contact_hits(), contact_hits, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_get_trigger_events(const cairn_world* world, cairn_trigger_event* trigger_events,
                                            size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(trigger_events, capacity, count, "trigger_events");
        write_list(world_of(world).trigger_events(), trigger_events, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_get_joint_events(const cairn_world* world, cairn_joint_event* joint_events, size_t capacity,
                                          size_t* count) {
    return guarded([&] {
        require_room(joint_events, capacity, count, "joint_events");
        write_list(world_of(world).joint_events(), joint_events, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_get_sleep_events(const cairn_world* world, cairn_sleep_event* sleep_events, size_t capacity,
                                          size_t* count) {
    return guarded([&] {
        require_room(sleep_events, capacity, count, "sleep_events");
        write_list(world_of(world).sleep_events(), sleep_events, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_get_contacts(const cairn_world* world, cairn_contact* contacts, size_t capacity,
                                      size_t* count) {
    return guarded([&] {
        require_room(contacts, capacity, count, "contacts");
        write_list(world_of(world).contacts(), contacts, capacity, count, [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_body_get_contacts(const cairn_world* world, cairn_body_id body, cairn_contact* contacts,
                                     size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(contacts, capacity, count, "contacts");
        write_list(world_of(world).contacts(to_cpp(body)), contacts, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}
