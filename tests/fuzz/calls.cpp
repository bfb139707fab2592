#include "calls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace cairn_fuzz {

namespace {

constexpr std::size_t max_bodies = 40, max_shapes = 5, max_joints = 40, max_dead = 200;

void require(bool holds, const std::string& what) {
    if (!holds) throw std::logic_error(what);
}

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double deepest(const World& world) {
    double depth = 0;
    for (const Contact& contact : world.contacts())
        for (int i = 0; i < contact.point_count; ++i) depth = std::max(depth, -double(contact.points[i].separation));
    return depth;
}

} // namespace

Calls::Calls(std::span<const std::uint8_t> bytes, std::uint64_t max_steps)
    : bytes_(bytes), max_steps_(max_steps), worlds_(3) {
    // All worlds are restored from one snapshot, so that they return the same handles.
    worlds_[threaded].restore(worlds_[single].save());
    worlds_[restored].restore(worlds_[single].save());
    worlds_[threaded].set_threads(4);
    BodyDef def;
    def.type = BodyType::static_;
    each([&](World& world) {
        ground_ = world.create_body(def);
        world.add_shape(ground_, Plane{});
    });
}

template <class F> void Calls::each(F&& f) {
    std::array<std::string, 3> answers;
    for (std::size_t i = 0; i < worlds_.size(); ++i) {
        const std::uint64_t before = worlds_[i].state_hash();
        try {
            f(worlds_[i]);
        } catch (const Error& error) {
            answers[i] = error.what();
            require(worlds_[i].state_hash() == before, "a refused call has changed the world: " + answers[i]);
        }
    }
    require(answers[single] == answers[threaded] && answers[single] == answers[restored],
            "refused in one world only: " + answers[single] + answers[threaded] + answers[restored]);
}

BodyId Calls::body() { return bodies_.empty() ? ground_ : bodies_[std::size_t(bytes_.pick(int(bodies_.size())))]; }

Shape Calls::shape() {
    const float a = bytes_.size(), b = bytes_.size(), c = bytes_.size();
    switch (bytes_.pick(8)) {
    case 0:
    case 1:
        return Sphere{a};
    case 2:
    case 3:
        return Box{{a, b, c}};
    case 4:
        return Capsule{a, b, {}};
    case 5:
        return Cylinder{a, b, {}, 0.1f * std::min(a, b)};
    case 6:
        return cone(a, b);
    default:
        std::array<Vec3, 8> corners;
        for (Vec3& corner : corners) corner = bytes_.vector(a + b);
        return Hull(corners);
    }
}

Shape Calls::surface() {
    if (bytes_.pick(2)) {
        std::array<float, 16> heights;
        for (float& height : heights) height = 0.3f * bytes_.unit();
        return HeightField(4, 4, {1, 1}, heights);
    }
    std::array<Vec3, 9> corners;
    for (std::size_t i = 0; i < 9; ++i)
        corners[i] = Vec3(float(i % 3) - 1, 0.3f * bytes_.unit(), float(i / 3) - 1) * 2.0f;
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t i : {0u, 1u, 3u, 4u})
        indices.insert(indices.end(), {i, i + 3, i + 1, i + 1, i + 3, i + 4});
    return Mesh(corners, indices);
}

Joint Calls::joint() {
    const float a = bytes_.unit(), b = bytes_.unit();
    const JointRange range{std::min(a, b), std::max(a, b), {}};
    JointControl control;
    if (bytes_.pick(2)) control.limits = range;
    if (bytes_.pick(2)) control.motor = JointMotor{3 * a, 0, {}, 20 * std::fabs(b)};
    if (bytes_.pick(2)) control.friction = std::fabs(b);
    switch (bytes_.pick(13)) {
    case 0:
        return FixedJoint{};
    case 1:
        return BallJoint{std::fabs(a), range, std::fabs(b)};
    case 2:
        return HingeJoint{control};
    case 3:
        return SliderJoint{control};
    case 4:
        return CylindricalJoint{control, {}};
    case 5:
        return UniversalJoint{control, {}};
    case 6:
        return DistanceJoint{{JointRange{0, 1 + a, {}}, {}, 0}};
    case 7:
        return WheelJoint{control, {}, control};
    case 8:
        return ServoJoint{{a, b, 0}, bytes_.rotation(), {}, {}, 100, 100};
    case 9:
        return GearJoint{a + 2};
    case 10:
        return RackJoint{b + 2};
    case 11:
        return PulleyJoint{bytes_.place(), bytes_.place(), 1 + std::fabs(a), {}};
    default:
        GeneralJoint general;
        general.limits.push_back({JointAxis::linear, {true, true, a > 0}, -std::fabs(b), std::fabs(b), {}, 0});
        general.drives.push_back({JointAxis::angular, b > 0, 0, 10, 0, a, 5, 1});
        return general;
    }
}

void Calls::create() {
    if (bodies_.size() >= max_bodies) return destroy();
    BodyDef def;
    def.type = BodyType(bytes_.pick(8) ? 2 : bytes_.pick(3));
    def.position = bytes_.place();
    def.rotation = bytes_.rotation();
    def.linear_velocity = bytes_.vector(5);
    def.allow_sleep = bytes_.pick(5) != 0;
    def.enabled = bytes_.pick(9) != 8;
    std::array<BodyId, 3> ids;
    std::size_t i = 0;
    each([&](World& world) { ids[i++] = world.create_body(def); });
    require(ids[0] == ids[1] && ids[0] == ids[2], "the worlds give out different handles");
    bodies_.push_back(ids[0]);
    add_shape(ids[0]);
}

void Calls::destroy() {
    if (bodies_.empty()) return;
    const std::size_t i = std::size_t(bytes_.pick(int(bodies_.size())));
    each([&](World& world) { world.destroy_body(bodies_[i]); });
    if (dead_.size() < max_dead) dead_.push_back(bodies_[i]);
    bodies_.erase(bodies_.begin() + std::ptrdiff_t(i));
}

void Calls::add_shape(BodyId id) {
    placed_ = true;
    if (id == ground_ || first(id).shapes().size() >= max_shapes) return;
    ShapeDef def;
    def.position = bytes_.vector(0.3f);
    def.rotation = bytes_.rotation();
    def.material.restitution = 0.5f * std::fabs(bytes_.unit());
    def.is_trigger = bytes_.pick(12) == 0;
    if (bytes_.pick(8) == 0) def.filter.layers = 2;
    if (bytes_.pick(8) == 0) def.filter.collides_with = 1;
    const bool is_surface = !is(id, BodyType::dynamic) && bytes_.pick(3) == 0;
    // The same bytes for each world; degenerate shapes are rejected in all of them.
    each([&, at = bytes_](World& world) {
        bytes_ = at;
        world.add_shape(id, is_surface ? surface() : shape(), def);
    });
}

void Calls::remove_shape() {
    const BodyId id = body();
    const auto shapes = first(id).shapes();
    if (id == ground_ || shapes.empty()) return;
    const ShapeId shape = shapes[std::size_t(bytes_.pick(int(shapes.size())))];
    each([&](World& world) { world.remove_shape(shape); });
}

void Calls::move() {
    placed_ = true;
    const BodyId id = body();
    const Position place = bytes_.place();
    const Quat rotation = bytes_.rotation();
    const Vec3 velocity = bytes_.vector(8);
    const int what = bytes_.pick(5);
    each([&](World& world) {
        Body b = world.body(id);
        if (what == 0) b.set_position(place);
        if (what == 1) b.set_transform(place, rotation);
        if (what == 2) b.set_linear_velocity(velocity);
        if (what == 3) b.set_angular_velocity(velocity);
        if (what == 4) b.move_to({place, rotation}, 0.5f);
    });
}

void Calls::push() {
    const BodyId id = body();
    if (!is(id, BodyType::dynamic) || !first(id).enabled()) return;
    const float mass = first(id).mass();
    if (!std::isfinite(mass)) return;
    const Vec3 vector = bytes_.vector(10 * mass);
    const int what = bytes_.pick(5);
    each([&](World& world) {
        Body b = world.body(id);
        if (what == 0) b.add_force(vector);
        if (what == 1) b.add_force_at(vector, b.position() + 0.2);
        if (what == 2) b.add_torque(0.1f * vector);
        if (what == 3) b.apply_impulse_at(0.1f * vector, b.position() + 0.1);
        if (what == 4) b.apply_angular_impulse(0.01f * vector);
    });
    if (what < 3) pushed_ += double(glm::length(vector));
}

void Calls::change_body() {
    placed_ = true;
    const BodyId id = body();
    const float value = bytes_.unit();
    const int what = bytes_.pick(7);
    each([&](World& world) {
        Body b = world.body(id);
        if (what == 0 && id != ground_) b.set_type(BodyType(std::uint8_t((value + 1) * 1.49f)));
        if (what == 1) b.set_gravity_scale(1 + 0.5f * value);
        if (what == 2) b.set_damping(std::fabs(value), std::fabs(value));
        if (what == 3) b.set_allow_sleep(value > 0);
        if (what == 4) b.set_mass_from_shapes(value > 0 ? std::optional<float>(20 * value) : std::nullopt);
        if (what == 5) b.wake();
        if (what == 6) b.set_enabled(value > -0.5f);
    });
}

void Calls::change_shape() {
    placed_ = true;
    const auto shapes = first(body()).shapes();
    if (shapes.empty()) return;
    Material material;
    material.static_friction = material.dynamic_friction = std::fabs(bytes_.unit());
    material.restitution = 0.5f * std::fabs(bytes_.unit());
    material.rolling_friction = material.torsional_friction = bytes_.pick(2) ? 0.02f : 0.0f;
    CollisionFilter filter;
    filter.collides_with = std::uint64_t(bytes_.pick(4));
    const Vec3 velocity = bytes_.vector(2);
    const int what = bytes_.pick(4);
    each([&](World& world) {
        if (what <= 1) world.set_material(shapes[0], material);
        if (what == 2) world.set_filter(shapes[0], filter);
        if (what == 3) world.set_surface_velocity(shapes[0], velocity);
    });
}

void Calls::join() {
    if (worlds_[single].joints().size() >= max_joints) return;
    const BodyId a = body(), b = bytes_.pick(4) ? body() : BodyId{};
    const Position anchor = first(a).position() + Position(bytes_.vector(0.5f));
    const Vec3 axis = bytes_.vector(1);
    const Joint kind = joint();
    const float strength = bytes_.pick(4) ? std::numeric_limits<float>::infinity() : 2000.0f;
    const JointSolver solver = JointSolver(bytes_.pick(3));
    const bool enabled = bytes_.pick(9) != 8;
    std::array<JointId, 3> ids{};
    std::size_t i = 0;
    each([&](World& world) {
        JointDef def = world.joint_at(a, b, anchor, axis, kind);
        def.break_force = strength;
        def.solver = solver;
        def.enabled = enabled;
        const std::size_t at = i++;
        ids[at] = world.create_joint(def);
    });
    require(ids[0] == ids[1] && ids[0] == ids[2], "the worlds give out different joints");
}

void Calls::change_joint() {
    placed_ = true;
    const auto joints = worlds_[single].joints();
    if (joints.empty()) return;
    const JointId id = joints[std::size_t(bytes_.pick(int(joints.size())))];
    const Joint kind = joint();
    const int what = bytes_.pick(5);
    each([&](World& world) {
        if (what == 0)
            world.destroy_joint(id);
        else if (what == 1)
            world.set_joint_enabled(id, !world.joint_def(id).enabled);
        else
            world.set_joint(id, kind);
    });
}

void Calls::change_fields() {
    if (fields_.size() > 2) {
        each([&](World& world) { world.remove_force_field(fields_.back()); });
        fields_.pop_back();
        return;
    }
    ForceField field;
    field.kind = ForceField::Kind(bytes_.pick(3));
    field.direction = bytes_.vector(1);
    field.strength = bytes_.unit();
    field.exponent = float(bytes_.pick(4) - 2);
    ForceFieldId id;
    each([&](World& world) { id = world.add_force_field(field); });
    fields_.push_back(id);
}

void Calls::change_settings() {
    WorldDef def;
    def.gravity = Vec3(0, -9.81f, 0) + bytes_.vector(1);
    def.substeps = bytes_.pick(13);
    def.adaptive_substeps = bytes_.pick(2) == 0;
    def.enable_sleep = bytes_.pick(4) != 0;
    def.integrator = Integrator(bytes_.pick(3));
    each([&](World& world) { world.set_settings(def); });
}

void Calls::query() {
    const Position from = bytes_.place();
    const Vec3 direction = bytes_.vector(1);
    const float radius = bytes_.size();
    each([&](World& world) {
        for (const RayHit& hit : world.cast_ray_all(from, direction, 10))
            require(world.is_valid(hit.shape), "a ray hit");
        for (const ShapeId s : world.overlap(Sphere{radius}, {from, {}})) require(world.is_valid(s), "an overlap");
        if (const auto hit = world.cast_shape(Box{}, {from, Quat(1, 0, 0, 0)}, direction))
            require(hit->fraction >= 0 && hit->fraction <= 1, "a shape cast that hits nowhere");
        if (const auto near = world.closest_point(from, 3)) require(near->distance <= 3, "a closest point too far off");
    });
}

void Calls::save_and_restore() {
    const std::uint64_t hash = worlds_[single].state_hash();
    const Snapshot snapshot = worlds_[bytes_.pick(2) ? single : threaded].save();
    if (bytes_.pick(2)) worlds_[restored] = World();
    worlds_[restored].restore(snapshot);
    require(worlds_[restored].state_hash() == hash, "what is restored is not what was saved");
    require(worlds_[restored].save().bytes == snapshot.bytes, "what is saved again is not what was restored");
}

void Calls::call_wrongly() {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const BodyId dead = dead_.empty() ? BodyId{} : dead_[std::size_t(bytes_.pick(int(dead_.size())))];
    const int what = bytes_.pick(6);
    int refused = 0;
    each([&](World& world) {
        ++refused;
        if (what == 0) world.step(-1);
        if (what == 1) world.body(ground_).set_position(Position(double(nan)));
        if (what == 2) world.add_shape(ground_, Sphere{nan});
        if (what == 3) world.destroy_body(dead);
        if (what == 4) world.body(dead).wake();
        if (what == 5) world.create_joint({});
        --refused;
    });
    require(refused == 3, "a wrong call was accepted");
}

void Calls::step() {
    if (steps() >= max_steps_) return;
    const float dt = bytes_.pick(8) ? 1.0f / 60 : 1.0f / 120;
    const Before before = {worlds_[single].kinetic_energy(), deepest(worlds_[single]),
                           !worlds_[single].joints().empty()};
    each([&](World& world) { world.step(dt); });
    check_step(before, dt);
    pushed_ = 0;
    placed_ = false;
}

void Calls::check_step(const Before& before, float dt) {
    const World& world = worlds_[single];
    require(world.state_hash() == worlds_[threaded].state_hash(), "another number of threads, another world");
    require(world.state_hash() == worlds_[restored].state_hash(), "the restored world went another way");
    std::vector<BodyId> expected = bodies_;
    expected.push_back(ground_);
    std::sort(expected.begin(), expected.end(), [](BodyId a, BodyId b) { return a.index() < b.index(); });
    require(world.bodies() == expected, "bodies() is not what was made and not removed");
    for (const BodyId id : dead_) require(!world.is_valid(id), "a stale handle is valid");
    for (const Contact& contact : world.contacts())
        require(world.is_valid(contact.shape_a) && world.is_valid(contact.body_b), "a contact of what is gone");
    for (const JointId id : world.joints())
        require(std::isfinite(world.joint_state(id).linear_error), "the state of a joint is not finite");

    // The energy that gravity, forces and the correction of overlaps can have added. Motors and moving bodies may add
    // more.
    bool is_driven = before.has_joints || !fields_.empty(); // a field may be singular at its center
    double given = 0;
    const double acceleration = 20, parting = 2.0 * double(world.settings().recovery_speed);
    for (const BodyId id : expected) {
        const Body b = world.body(id);
        require(is_finite(b.linear_velocity()) && is_finite(b.angular_velocity()) && is_finite(Vec3(b.position())),
                "a body is not finite");
        if (b.type() == BodyType::kinematic) is_driven = true;
        for (const ShapeId shape : b.shapes()) is_driven |= glm::length(world.shape_def(shape).surface_velocity) > 0;
        const double mass = double(b.mass()), v = double(glm::length(b.linear_velocity()));
        if (!std::isfinite(mass)) continue;
        given += mass * (acceleration * double(dt) * (v + acceleration * double(dt)) + parting * (parting + v));
        given += pushed_ * (v + 1) * double(dt);
    }
    require(is_driven || world.kinetic_energy() <= 1.5 * before.energy + given + pushed_,
            "energy from nothing: " + std::to_string(before.energy) + " J, then " +
                std::to_string(world.kinetic_energy()) + " J, of which " + std::to_string(given) +
                " J may have been given");
    double fastest = 0;
    for (const BodyId id : bodies_) fastest = std::max(fastest, double(glm::length(world.body(id).linear_velocity())));
    require(is_driven || placed_ || deepest(world) <= before.depth + 2 * fastest * double(dt) + 0.1,
            "bodies sink into each other: " + std::to_string(before.depth) + " m, then " +
                std::to_string(deepest(world)) + " m at " + std::to_string(fastest) + " m/s");
}

void Calls::call() {
    switch (bytes_.pick(20)) {
    case 0:
    case 1:
    case 2:
        return create();
    case 3:
        return destroy();
    case 4:
        return add_shape(body());
    case 5:
        return remove_shape();
    case 6:
        return move();
    case 7:
        return push();
    case 8:
        return change_body();
    case 9:
        return change_shape();
    case 10:
        return join();
    case 11:
        return change_joint();
    case 12:
        return change_fields();
    case 13:
        return change_settings();
    case 14:
        return query();
    case 15:
        return save_and_restore();
    case 16:
        return call_wrongly();
    default:
        return step();
    }
}

void Calls::run() {
    while (!bytes_.is_empty()) call();
    step();
}

} // namespace cairn_fuzz
