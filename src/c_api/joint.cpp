// Joints: lists of limits and drives of general joints, of which a C definition has only the lengths.
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

using namespace cairn;
using namespace cairn::c_api;

namespace {

// A joint as a general joint; without limits and drives if it is of another kind.
GeneralJoint general_joint(const cairn_world* world, cairn_joint_id joint) {
    const Joint& kind = world_of(world).joint_def(to_cpp(joint)).joint;
    const GeneralJoint* general = std::get_if<GeneralJoint>(&kind);
    return general ? *general : GeneralJoint{};
}

} // namespace

cairn_result cairn_joint_get_limits(const cairn_world* world, cairn_joint_id joint, cairn_joint_limit* limits,
                                    size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(limits, capacity, count, "limits");
        write_list(general_joint(world, joint).limits, limits, capacity, count,
                   [](const JointLimit& limit) { return to_c(limit); });
    });
}

cairn_result cairn_joint_get_drives(const cairn_world* world, cairn_joint_id joint, cairn_joint_drive* drives,
                                    size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(drives, capacity, count, "drives");
        write_list(general_joint(world, joint).drives, drives, capacity, count,
                   [](const JointDrive& drive) { return to_c(drive); });
    });
}

cairn_result cairn_world_joint_at(const cairn_world* world, cairn_body_id body_a, cairn_body_id body_b,
                                  cairn_position anchor, cairn_vec3 axis, const cairn_joint* joint,
                                  cairn_joint_def* result) {
    return guarded([&] {
        require_versioned(result, "result");
        cairn_joint_def def = to_c(world_of(world).joint_at(to_cpp(body_a), to_cpp(body_b), to_cpp(anchor),
                                                            to_cpp(axis), to_cpp(required(joint, "joint"))));
        def.joint = *joint; // with the caller's lists
        write_versioned(def, result);
    });
}

cairn_joint_spring cairn_spring_from_frequency(float hertz, float damping_ratio) {
    return to_c(JointSpring::from_frequency(hertz, damping_ratio));
}
