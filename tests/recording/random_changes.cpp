#include "random_changes.h"

#include <utility>

namespace cairn::test {

Shape RandomChanges::solid() {
    const float size = 0.2f + 0.1f * float(pick(3));
    switch (pick(6)) {
    case 0:
        return Sphere{size};
    case 1:
        return Box{{size, 0.3f, size}, pick(2) == 0 ? 0.0f : 0.02f};
    case 2:
        return Capsule{size, 0.2f, {}};
    case 3:
        return Capsule{size, 0.2f, 0.1f};
    case 4:
        return Cylinder{size, 0.3f, {}, 0.01f};
    default: {
        std::vector<Vec3> points;
        for (int i = 0; i < 12; ++i) points.push_back(vector(0.4f));
        Hull hull(points);
        hull.rounding = pick(2) == 0 ? 0.0f : 0.03f;
        return hull;
    }
    }
}

Joint RandomChanges::joint() {
    JointControl control;
    if (pick(2) == 0) control.limits = JointRange{-0.5f, 1.0f, JointSpring{20.0f, 1.0f, true}};
    if (pick(2) == 0) control.motor = JointMotor{number(2.0f), 0.1f, JointSpring{10.0f, 1.0f, false}, 50.0f};
    control.friction = pick(2) == 0 ? 0.0f : 0.5f;
    switch (pick(8)) {
    case 0:
        return FixedJoint{};
    case 1:
        return BallJoint{0.8f, JointRange{-1.0f, 1.0f, {}}, 0.1f};
    case 2:
        return HingeJoint{control};
    case 3:
        return SliderJoint{control};
    case 4:
        return CylindricalJoint{control, {}};
    case 5:
        return ServoJoint{};
    case 6:
        return WheelJoint{control, {}, {}};
    default: {
        GeneralJoint general;
        general.limits.push_back({JointAxis::linear, {true, true, false}, {}, {}, {}, 0.0f});
        general.limits.push_back({JointAxis::angular, {false, false, true}, -0.3f, 0.4f, 100.0f, 2.0f});
        general.drives.push_back({JointAxis::linear, true, 2, 30.0f, 0.2f, 0.0f, 40.0f, 3.0f});
        return general;
    }
    }
}

void RandomChanges::create(World& world) {
    BodyDef def;
    def.type = BodyType(pick(8) < 6 ? 2 : pick(2));
    def.position = place();
    def.rotation = rotation();
    if (def.type != BodyType::static_) def.linear_velocity = vector(2.0f), def.angular_velocity = vector(3.0f);
    def.linear_damping = pick(2) == 0 ? 0.0f : 0.1f;
    def.name = pick(2) == 0 ? "" : "crate " + std::to_string(pick(100));
    def.user_data = random_();
    if (pick(4) == 0) def.mass = 2.0f;
    const BodyId body = world.create_body(def);
    ShapeDef how;
    how.position = vector(0.2f);
    how.rotation = rotation();
    how.material.restitution = 0.3f;
    world.add_shape(body, solid(), how);
    if (pick(3) == 0) world.add_shape(body, solid());
    const std::vector<BodyId> bodies = world.bodies();
    const BodyId other = bodies[std::size_t(pick(int(bodies.size())))];
    if (def.type == BodyType::dynamic && other != body && pick(2) == 0) {
        JointDef joint_def = world.joint_at(other, body, def.position, {0, 1, 0}, joint());
        joint_def.name = "joint";
        joint_def.break_force = pick(3) == 0 ? 500.0f : std::numeric_limits<float>::infinity();
        world.create_joint(joint_def);
    }
}

void RandomChanges::change_character(Body body) {
    if (!body.is_character() || pick(5) == 0) {
        CharacterDef def;
        def.step_height = 0.4f;
        def.flies = pick(5) == 0;
        return body.set_character(def);
    }
    switch (pick(4)) {
    case 0:
        return body.remove_character();
    case 1:
        return body.jump(3.0f);
    default:
        return body.set_walk_velocity(vector(3.0f));
    }
}

void RandomChanges::change_body(World& world, BodyId id) {
    Body body = world.body(id);
    const bool is_dynamic = body.type() == BodyType::dynamic;
    switch (pick(21)) {
    case 12:
        return body.sleep();
    case 13:
        return body.set_enabled(!body.enabled());
    case 0:
        return body.set_transform(place(), rotation());
    case 1:
        return body.set_position(place());
    case 2:
        return body.set_rotation(rotation());
    case 3:
        return body.set_linear_velocity(vector(4.0f));
    case 4:
        return body.set_angular_velocity(vector(4.0f));
    case 5:
        return body.set_gravity_scale(number(2.0f));
    case 6:
        return body.set_damping(0.2f, 0.1f);
    case 7:
        return body.set_allow_sleep(pick(2) == 0);
    case 8:
        return body.set_name("renamed " + std::to_string(pick(10)));
    case 9:
        return body.wake();
    case 10:
        if (body.is_character()) body.remove_character();
        return body.set_type(BodyType(pick(3)));
    case 11:
        if (body.type() != BodyType::kinematic) return;
        return body.move_to({place(), rotation()}, 0.5f);
    default:
        break;
    }
    if (body.type() == BodyType::kinematic) return change_character(body);
    if (!is_dynamic || !body.enabled()) return;
    switch (pick(8)) {
    case 0:
        return body.add_force(vector(30.0f));
    case 1:
        return body.add_force_at(vector(30.0f), place());
    case 2:
        return body.add_torque(vector(5.0f));
    case 3:
        return body.apply_impulse(vector(2.0f));
    case 4:
        return body.apply_impulse_at(vector(2.0f), body.position());
    case 5:
        return body.apply_angular_impulse(vector(0.5f));
    case 6:
        return body.set_mass_properties({3.0f, vector(0.1f), {0.5f, 0.6f, 0.7f}, rotation()});
    default:
        return body.set_mass_from_shapes(pick(2) == 0 ? std::optional(1.5f) : std::nullopt);
    }
}

void RandomChanges::change_shapes(World& world, BodyId id) {
    const std::vector<ShapeId> shapes = std::as_const(world).body(id).shapes();
    if (shapes.empty()) {
        world.add_shape(id, solid());
        return;
    }
    const ShapeId shape = shapes[std::size_t(pick(int(shapes.size())))];
    Material material;
    material.dynamic_friction = 0.1f * float(pick(5));
    material.friction_combine = CombineRule(pick(4));
    switch (pick(7)) {
    case 5:
        return world.set_shape(shape, solid());
    case 6: {
        ShapeDef def = world.shape_def(shape);
        def.position = vector(0.2f);
        def.density = 500.0f + 100.0f * float(pick(9));
        def.is_trigger = pick(4) == 0;
        if (std::as_const(world).body(id).type() != BodyType::dynamic) def.one_way = {0, float(pick(2)), 0};
        return world.set_shape_def(shape, def);
    }
    case 0:
        return world.set_material(shape, material);
    case 1:
        return world.set_filter(shape, {std::uint64_t{1} << pick(2), ~std::uint64_t{}});
    case 2:
        if (std::as_const(world).body(id).type() == BodyType::dynamic) return;
        return world.set_surface_velocity(shape, vector(1.0f));
    case 3:
        return world.remove_shape(shape);
    default:
        world.add_shape(id, solid());
    }
}

void RandomChanges::change_joints(World& world) {
    const std::vector<JointId> joints = world.joints();
    if (joints.empty()) return;
    const JointId id = joints[std::size_t(pick(int(joints.size())))];
    switch (pick(5)) {
    case 3:
        return world.set_joint_enabled(id, !world.joint_def(id).enabled);
    case 0:
        return world.set_joint(id, joint());
    case 1:
        return world.set_joint_strength(id, 300.0f, 200.0f);
    case 2:
        return world.destroy_joint(id);
    default:
        return;
    }
}

void RandomChanges::change_world(World& world) {
    ForceField field;
    field.direction = vector(2.0f);
    if (pick(2) == 0) field.kind = ForceField::Kind::radial, field.strength = 2.0f, field.exponent = -1.0f;
    if (pick(3) == 0) field.kind = ForceField::Kind::fluid, field.half_extents = {20, 2, 5}, field.density = 700.0f;
    std::erase_if(fields_, [&](ForceFieldId id) { return !world.is_valid(id); });
    WorldDef settings = world.settings();
    switch (pick(4)) {
    case 0:
        settings.gravity = {number(1.0f), -9.81f, number(1.0f)};
        settings.substeps = 4 + pick(4);
        settings.integrator = Integrator(pick(3));
        return world.set_settings(settings);
    case 1:
        if (fields_.size() < 3) fields_.push_back(world.add_force_field(field));
        return;
    case 2:
        if (!fields_.empty()) world.set_force_field(fields_.back(), field);
        return;
    default:
        if (!fields_.empty()) world.remove_force_field(fields_[0]);
    }
}

void RandomChanges::populate(World& world) {
    BodyDef ground;
    ground.type = BodyType::static_;
    const BodyId floor = world.create_body(ground);
    world.add_shape(floor, Plane{});
    const std::vector<Vec3> corners{{-2, 0.1f, -2}, {2, 0.1f, -2}, {2, 0.4f, 2}, {-2, 0.2f, 2}};
    const std::vector<std::uint32_t> triangles{0, 2, 1, 0, 3, 2};
    world.add_shape(floor, Mesh(corners, triangles));
    const std::vector<float> heights{0.0f, 0.3f, 0.1f, 0.2f, 0.5f, 0.1f, HeightField::hole, 0.2f, 0.1f};
    ShapeDef aside;
    aside.position = {5, 0, 0};
    world.add_shape(floor, HeightField(3, 3, {1.0f, 1.5f}, heights), aside);
    for (int i = 0; i < 12; ++i) create(world);
}

void RandomChanges::change(World& world, bool steps) {
    if (steps && pick(3) != 0) return world.step(1.0f / 60.0f);
    const std::vector<BodyId> bodies = world.bodies();
    const int kind = pick(20);
    try {
        if (kind < 3 || bodies.size() < 5) return create(world);
        const BodyId body = bodies[std::size_t(pick(int(bodies.size())))];
        if (kind == 3 && body != bodies[0]) return world.destroy_body(body);
        if (kind < 14) return change_body(world, body);
        if (kind < 16) return change_shapes(world, body);
        if (kind < 18) return change_joints(world);
        change_world(world);
    } catch (const Error&) { // the call was rejected and has no effect
    }
}

} // namespace cairn::test
