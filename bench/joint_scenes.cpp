#include "bench/joint_scenes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cairn::bench {

namespace {

constexpr float degree = 3.14159265f / 180;

// A net of size x size spheres, each joined to its neighbors; the first row is fixed. `step` is the offset between
// rows.
void net(Builder& b, int size, Vec3 step) {
    b.scene.steps = 300;
    b.scene.collides = false;
    b.scene.lower_bound.y = -1e9f;
    const Vec3 across{1, 0, 0};
    const auto join = [&](std::size_t one, std::size_t other, Vec3 way) {
        SceneJoint joint;
        joint.body_a = one;
        joint.body_b = other;
        joint.anchor_a = 0.5f * way;
        joint.anchor_b = -0.5f * way;
        b.scene.joints.push_back(joint);
    };
    const auto count = static_cast<std::size_t>(size);
    for (std::size_t column = 0; column < count; ++column)
        for (std::size_t row = 0; row < count; ++row) {
            const std::size_t body = b.scene.bodies.size();
            b.sphere(row == 0 ? Motion::fixed : Motion::dynamic,
                     static_cast<float>(column) * across + static_cast<float>(row) * step, 0.4f);
            if (row > 0) join(body - 1, body, step);
            if (row > 0 && column > 0) join(body - count, body, across);
        }
}

Part upright_capsule(float radius, float half_height) {
    Part part;
    part.shape = PartShape::capsule;
    part.radius = radius;
    part.half_height = half_height;
    return part;
}

// One ragdoll: 1.66 m tall, 76 kg; its chest has ten times the mass of a forearm. It stands along its own y axis and
// faces along z, with its arms down.
class Ragdoll {
  public:
    Ragdoll(Vec3 position, Quat rotation) : position_(position), rotation_(rotation) {}

    void add_to(Builder& b) const {
        const auto limb = [&](const Part& part, Vec3 at) { return add(b, part, at); };
        const auto ball = [&](const Limb& one, const Limb& other, Vec3 at, Quat axes, float swing, float twist) {
            join(b, JointKind::ball, one, other, at, axes).reach = SwingTwist{swing * degree, twist * degree};
        };
        const auto hinge = [&](const Limb& one, const Limb& other, Vec3 at, float lower, float upper) {
            join(b, JointKind::hinge, one, other, at, along_x()).angle = AngleRange{lower * degree, upper * degree};
        };
        const Limb pelvis = limb(box_part({0.14f, 0.1f, 0.1f}), {0, 0, 0});
        const Limb chest = limb(box_part({0.17f, 0.17f, 0.1f}), {0, 0.29f, 0});
        const Limb head = limb(upright_capsule(0.1f, 0.03f), {0, 0.63f, 0});
        ball(pelvis, chest, {0, 0.11f, 0}, up(), 35, 30);
        ball(chest, head, {0, 0.48f, 0}, up(), 40, 50);
        for (const float side : {-1.0f, 1.0f}) {
            const float arm = side * 0.245f, leg = side * 0.09f;
            const Limb upper_arm = limb(upright_capsule(0.055f, 0.11f), {arm, 0.3f, 0});
            const Limb forearm = limb(upright_capsule(0.05f, 0.11f), {arm, 0.08f, 0});
            ball(chest, upper_arm, {arm, 0.41f, 0}, down(), 75, 45);
            hinge(upper_arm, forearm, {arm, 0.19f, 0}, -140, 0);
            const Limb thigh = limb(upright_capsule(0.075f, 0.18f), {leg, -0.3f, 0});
            const Limb shin = limb(upright_capsule(0.06f, 0.18f), {leg, -0.66f, 0});
            ball(pelvis, thigh, {leg, -0.12f, 0}, down(), 60, 30);
            hinge(thigh, shin, {leg, -0.48f, 0}, 0, 130);
        }
    }

  private:
    // Rotations that map the x axis of a joint to these axes of the ragdoll.
    static Quat along_x() { return Quat(1.0f, 0.0f, 0.0f, 0.0f); }
    static Quat up() { return Quat(std::sqrt(0.5f), 0.0f, 0.0f, std::sqrt(0.5f)); }
    static Quat down() { return Quat(std::sqrt(0.5f), 0.0f, 0.0f, -std::sqrt(0.5f)); }

    struct Limb {
        std::size_t body;
        Vec3 at; // position of its center in the ragdoll's frame
    };
    Limb add(Builder& b, const Part& part, Vec3 at) const {
        constexpr float middle = -0.07f; // half its height, m
        b.body(Motion::dynamic, position_ + rotation_ * (at - Vec3(0, middle, 0)), part, 1000, rotation_);
        return {b.scene.bodies.size() - 1, at};
    }
    static SceneJoint& join(Builder& b, JointKind kind, const Limb& one, const Limb& other, Vec3 at, Quat axes) {
        SceneJoint joint;
        joint.kind = kind;
        joint.body_a = one.body;
        joint.body_b = other.body;
        joint.anchor_a = at - one.at;
        joint.anchor_b = at - other.at;
        joint.axes_a = joint.axes_b = axes;
        b.scene.joints.push_back(joint);
        return b.scene.joints.back();
    }

    Vec3 position_;
    Quat rotation_;
};

// A small rotation from a rotation vector: a quaternion whose vector part is half of it, normalized.
Quat turned_by(Vec3 rotation) {
    const Vec3 v = 0.5f * rotation;
    const float scale = 1 / std::sqrt(1 + glm::dot(v, v));
    return Quat(scale, scale * v.x, scale * v.y, scale * v.z);
}

} // namespace

// A chain of links, initially horizontal, on hinges along z.
void chain(Builder& b, int size) {
    b.scene.steps = 300;
    b.scene.collides = false;
    b.scene.lower_bound.y = -1e9f;
    constexpr float half = 0.25f; // half the length of a link, m
    const Quat to_x(std::sqrt(0.5f), 0.0f, 0.0f, -std::sqrt(0.5f)),
        x_to_z(std::sqrt(0.5f), 0.0f, -std::sqrt(0.5f), 0.0f);
    b.sphere(Motion::fixed, {0, 0, 0}, 0.1f);
    for (int i = 0; i < size; ++i) {
        b.body(Motion::dynamic, {(2 * static_cast<float>(i) + 1) * half, 0, 0}, upright_capsule(0.05f, half - 0.05f),
               1000, to_x);
        SceneJoint joint;
        joint.kind = JointKind::hinge;
        joint.body_a = static_cast<std::size_t>(i);
        joint.body_b = joint.body_a + 1;
        joint.anchor_a = i == 0 ? Vec3(0.0f) : Vec3(0, half, 0);
        joint.anchor_b = {0, -half, 0};
        joint.axes_a = i == 0 ? x_to_z : glm::conjugate(to_x) * x_to_z;
        joint.axes_b = glm::conjugate(to_x) * x_to_z;
        b.scene.joints.push_back(joint);
    }
}

void joint_grid(Builder& b, int size) { net(b, size, {0, -1, 0}); }
void joint_swing(Builder& b, int size) { net(b, size, {0, 0, 1}); }

// Ragdolls that lie on their backs or faces, in columns above a narrow room, with small random rotations.
void ragdolls(Builder& b, int size) {
    b.scene.steps = 300;
    constexpr int layers = 28;
    constexpr float width = 0.95f, length = 1.95f, height = 0.65f; // space per ragdoll, m
    const int columns = (size + layers - 1) / layers;
    const int across = static_cast<int>(std::ceil(std::sqrt(0.5f * static_cast<float>(columns))));
    b.room(0.5f * static_cast<float>(across) * length + 0.25f, layers * height + 20);
    Random random(10);
    for (int i = 0; i < size; ++i) {
        const int x = i % (2 * across), z = i / (2 * across) % across, y = i / (2 * across * across);
        const Vec3 position((static_cast<float>(x) - static_cast<float>(across) + 0.5f) * width,
                            1 + static_cast<float>(y) * height,
                            (static_cast<float>(z) - 0.5f * static_cast<float>(across - 1)) * length);
        const float lie = random.next() & 1024 ? std::sqrt(0.5f) : -std::sqrt(0.5f);
        const float yaw = random.between(-0.17f, 0.17f), pitch = random.between(-0.17f, 0.17f);
        Ragdoll(position, turned_by({pitch, yaw, 0}) * Quat(std::sqrt(0.5f), lie, 0.0f, 0.0f)).add_to(b);
    }
}

} // namespace cairn::bench
