#include "copy_world.h"

#include <map>

namespace cairn_test {

namespace {

// Reads the list of a call that fills an array, in two calls: first the number, then the elements.
template <class T, class Call> void read_list(std::vector<T>& list, Call&& call) {
    size_t count = 0;
    CAIRN_CALL(call(static_cast<T*>(nullptr), size_t{0}, &count));
    list.resize(count);
    CAIRN_CALL(call(list.data(), list.size(), &count));
    ASSERT_EQ(count, list.size());
}

template <class Call> void read_text(std::string& text, Call&& call) {
    std::vector<char> letters;
    read_list(letters, call);
    letters.resize(letters.size() + 1);
    size_t length = 0;
    CAIRN_CALL(call(letters.data(), letters.size(), &length));
    text = letters.data();
    ASSERT_EQ(text.size(), length);
}

void copy_body(const cairn_world* from, cairn_body_id body, cairn_world* to, cairn_body_id* made) {
    cairn_body_def def = cairn_default_body_def();
    std::string name;
    CAIRN_CALL(cairn_body_get_type(from, body, &def.type));
    CAIRN_CALL(cairn_body_get_position(from, body, &def.position));
    CAIRN_CALL(cairn_body_get_rotation(from, body, &def.rotation));
    CAIRN_CALL(cairn_body_get_linear_velocity(from, body, &def.linear_velocity));
    CAIRN_CALL(cairn_body_get_angular_velocity(from, body, &def.angular_velocity));
    CAIRN_CALL(cairn_body_get_linear_damping(from, body, &def.linear_damping));
    CAIRN_CALL(cairn_body_get_angular_damping(from, body, &def.angular_damping));
    CAIRN_CALL(cairn_body_get_gravity_scale(from, body, &def.gravity_scale));
    CAIRN_CALL(cairn_body_get_allow_sleep(from, body, &def.allow_sleep));
    CAIRN_CALL(cairn_body_get_enabled(from, body, &def.enabled));
    CAIRN_CALL(cairn_body_get_user_data(from, body, &def.user_data));
    read_text(name, [&](auto... to_read) { return cairn_body_get_name(from, body, to_read...); });
    def.name = name.c_str();
    if (def.type == CAIRN_BODY_TYPE_DYNAMIC) {
        def.has_mass_properties = true;
        CAIRN_CALL(cairn_body_get_mass_properties(from, body, &def.mass_properties));
    }
    CAIRN_CALL(cairn_world_create_body(to, &def, made));
    std::vector<cairn_shape_id> shapes;
    read_list(shapes, [&](auto... to_read) { return cairn_body_get_shapes(from, body, to_read...); });
    for (const cairn_shape_id id : shapes) {
        cairn_shape shape;
        cairn_shape_def shape_def = cairn_default_shape_def();
        cairn_shape_id made_shape;
        CAIRN_CALL(cairn_world_get_shape(from, id, &shape));
        CAIRN_CALL(cairn_world_get_shape_def(from, id, &shape_def));
        CAIRN_CALL(cairn_world_add_shape(to, *made, &shape, &shape_def, &made_shape));
        if (shape.kind == CAIRN_SHAPE_HULL) cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.hull.geometry));
        if (shape.kind == CAIRN_SHAPE_MESH) cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.mesh.geometry));
        if (shape.kind == CAIRN_SHAPE_HEIGHT_FIELD)
            cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.height_field.geometry));
    }
    bool is_character = false;
    CAIRN_CALL(cairn_body_is_character(from, body, &is_character));
    if (!is_character) return;
    cairn_character_def character = cairn_default_character_def();
    cairn_vec3 walk;
    CAIRN_CALL(cairn_body_get_character(from, body, &character));
    CAIRN_CALL(cairn_body_get_walk_velocity(from, body, &walk));
    CAIRN_CALL(cairn_body_set_character(to, *made, &character));
    CAIRN_CALL(cairn_body_set_walk_velocity(to, *made, walk));
}

void copy_joint(const cairn_world* from, cairn_joint_id joint, cairn_world* to,
                const std::map<uint64_t, cairn_body_id>& bodies) {
    cairn_joint_def def = cairn_default_joint_def();
    std::string name;
    std::vector<cairn_joint_limit> limits;
    std::vector<cairn_joint_drive> drives;
    cairn_joint_id made;
    CAIRN_CALL(cairn_world_get_joint_def(from, joint, &def));
    read_text(name, [&](auto... to_read) { return cairn_joint_get_name(from, joint, to_read...); });
    read_list(limits, [&](auto... to_read) { return cairn_joint_get_limits(from, joint, to_read...); });
    read_list(drives, [&](auto... to_read) { return cairn_joint_get_drives(from, joint, to_read...); });
    def.name = name.c_str();
    if (def.joint.kind == CAIRN_JOINT_GENERAL) {
        ASSERT_EQ(def.joint.as.general.limit_count, limits.size());
        ASSERT_EQ(def.joint.as.general.drive_count, drives.size());
        def.joint.as.general.limits = limits.data();
        def.joint.as.general.drives = drives.data();
    }
    if (def.body_a.bits) def.body_a = bodies.at(def.body_a.bits);
    if (def.body_b.bits) def.body_b = bodies.at(def.body_b.bits);
    CAIRN_CALL(cairn_world_create_joint(to, &def, &made));
}

} // namespace

void copy_world(const cairn_world* from, cairn_world** to) {
    cairn_world_def settings = cairn_default_world_def();
    CAIRN_CALL(cairn_world_get_settings(from, &settings));
    CAIRN_CALL(cairn_world_create(&settings, to));
    std::vector<cairn_body_id> bodies;
    std::vector<cairn_joint_id> joints;
    std::map<uint64_t, cairn_body_id> made; // by the bits of the original body
    read_list(bodies, [&](auto... to_read) { return cairn_world_get_bodies(from, to_read...); });
    read_list(joints, [&](auto... to_read) { return cairn_world_get_joints(from, to_read...); });
    for (const cairn_body_id body : bodies) copy_body(from, body, *to, &made[body.bits]);
    for (const cairn_joint_id joint : joints) copy_joint(from, joint, *to, made);
}

} // namespace cairn_test
