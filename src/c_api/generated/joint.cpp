// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

using namespace cairn::c_api;
using namespace cairn;

cairn_result cairn_world_create_joint(cairn_world* world, const cairn_joint_def* def, cairn_joint_id* result) {
    return guarded([&] {
        required(result, "result");
        *result = to_c(world_of(world).create_joint(to_cpp(versioned(required(def, "def"), "def",
            cairn_default_joint_def()))));
    });
}

cairn_result cairn_world_destroy_joint(cairn_world* world, cairn_joint_id joint) {
    return guarded([&] {
        world_of(world).destroy_joint(to_cpp(joint));
    });
}

bool cairn_joint_is_valid(const cairn_world* world, cairn_joint_id joint) {
    return world && world_of(world).is_valid(to_cpp(joint));
}

cairn_result cairn_world_get_joint_def(const cairn_world* world, cairn_joint_id joint, cairn_joint_def* joint_def) {
    return guarded([&] {
        require_versioned(joint_def, "joint_def");
        write_versioned(to_c(world_of(world).joint_def(to_cpp(joint))), joint_def);
    });
}

cairn_result cairn_world_set_joint(cairn_world* world, cairn_joint_id id, const cairn_joint* joint) {
    return guarded([&] {
        world_of(world).set_joint(to_cpp(id), to_cpp(required(joint, "joint")));
    });
}

cairn_result cairn_world_set_joint_strength(cairn_world* world, cairn_joint_id joint, float break_force,
                                            float break_torque) {
    return guarded([&] {
        world_of(world).set_joint_strength(to_cpp(joint), break_force, break_torque);
    });
}

cairn_result cairn_world_set_joint_enabled(cairn_world* world, cairn_joint_id joint, bool enabled) {
    return guarded([&] {
        world_of(world).set_joint_enabled(to_cpp(joint), enabled);
    });
}

cairn_result cairn_world_get_joint_state(const cairn_world* world, cairn_joint_id joint,
                                         cairn_joint_state* joint_state) {
    return guarded([&] {
        required(joint_state, "joint_state");
        *joint_state = to_c(world_of(world).joint_state(to_cpp(joint)));
    });
}

cairn_result cairn_world_get_joints(const cairn_world* world, cairn_joint_id* joints, size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(joints, capacity, count, "joints");
        write_list(world_of(world).joints(), joints, capacity, count, [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_body_get_joints(const cairn_world* world, cairn_body_id body, cairn_joint_id* joints,
                                   size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(joints, capacity, count, "joints");
        write_list(world_of(world).joints(to_cpp(body)), joints, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_find_joint(const cairn_world* world, const char* name, cairn_joint_id* result, bool* found) {
    return guarded([&] {
        required(result, "result");
        required(found, "found");
        const auto answer = world_of(world).find_joint(required_text(name, "name"));
        *found = answer.has_value();
        if (answer) *result = to_c(*answer);
    });
}

cairn_result cairn_joint_get_name(const cairn_world* world, cairn_joint_id joint, char* text, size_t capacity,
                                  size_t* length) {
    return guarded([&] {
        require_room(text, capacity, length, "text");
        write_text(world_of(world).joint_def(to_cpp(joint)).name, text, capacity, length);
    });
}
