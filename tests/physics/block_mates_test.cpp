// Islands are solved eight contacts or joints at a time in SIMD lanes, and contacts of several islands share a block.
// Each island must nevertheless move, to the last bit, as it does in a world of its own.
#include "support.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>
#include <utility>

namespace cairn_test {
namespace {

constexpr std::size_t islands = 20;
constexpr int steps = 90;
constexpr double spacing = 64; // m; a power of two, so that positions round alike in every island

class RandomStart {
  public:
    explicit RandomStart(int seed) : random_(std::uint32_t(seed)) {}
    float between(float low, float high) { return low + (high - low) * float(random_() >> 8) * 0x1p-24f; }
    Vec3 vector(float size) {
        const float x = between(-size, size), y = between(-size, size), z = between(-size, size);
        return {x, y, z};
    }
    Quat rotation() {
        const Vec3 v = vector(1);
        return glm::normalize(Quat(between(0.1f, 1), v.x, v.y, v.z));
    }
    int below(int count) { return int(random_() % std::uint32_t(count)); }

  private:
    std::mt19937 random_;
};

struct Island {
    std::vector<BodyId> bodies;
};

Shape shape_of(int type, RandomStart& random) {
    const float a = random.between(0.1f, 0.3f), b = random.between(0.1f, 0.2f);
    switch (type) {
    case 0:
        return Sphere{a};
    case 1:
        return random.below(2) ? Box{{a, b, 0.15f}} : Box{{a, a, a}}; // a cube has isotropic inertia, like a ball
    case 2:
        return Capsule{a, 0.1f, {}};
    default:
        return Cylinder{b, 0.15f, {}, 0};
    }
}

// A random mix of all kinds of constraint rows: limits or none, rigid or soft ones, motors, springs and friction.
JointControl control(RandomStart& random) {
    JointControl control;
    const JointSpring spring{random.between(5, 50), random.between(0, 1)};
    if (random.below(2)) control.limits = {-random.between(0, 0.3f), random.between(0, 0.3f)};
    if (control.limits && random.below(3) == 0) control.limits->spring = spring;
    if (random.below(3) == 0) control.motor = JointMotor{random.between(-2, 2), 0, {}, random.between(0.1f, 5)};
    if (control.motor && random.below(2)) control.motor->spring = spring;
    if (random.below(3) == 0) control.friction = random.between(0, 1);
    return control;
}
Joint joint_of(RandomStart& random) {
    switch (random.below(6)) {
    case 0:
        return HingeJoint{};
    case 1:
        return HingeJoint{control(random)};
    case 2:
        return SliderJoint{control(random)};
    case 3:
        return BallJoint{random.between(0.1f, 0.6f), JointRange{-random.between(0, 0.3f), random.between(0, 0.3f)}};
    case 4:
        return BallJoint{random.between(0.1f, 0.6f)};
    default:
        return BallJoint{};
    }
}

// An island of jointed and loose bodies that fall, rotating fast, onto the ground and each other. No body is so fast
// that the step is split, because a split applies to the whole world.
Island add_island(World& world, int seed, float restitution) {
    RandomStart random(seed);
    Island island;
    const Position origin(spacing * seed, 0, 0);
    BodyDef floor; // an own floor close by, so that arms are short
    floor.type = BodyType::static_;
    floor.position = origin;
    add_body(world, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(20)}, floor, surface(0.5f, restitution));
    const Vec3 thrown = random.vector(3) - Vec3(0, random.between(0, 12), 0);
    const int count = 3 + random.below(4), first_type = random.below(4), types = 1 + random.below(4);
    for (int i = 0; i < count; ++i) {
        BodyDef def;
        def.position = origin + Position(0.05 * (i % 2), 0.4 + 0.5 * i, 0);
        def.rotation = random.rotation();
        def.linear_velocity = thrown;
        def.angular_velocity = random.vector(random.below(2) ? 2.0f : 15.0f);
        const Shape shape = shape_of((first_type + i % types) % 4, random);
        island.bodies.push_back(add_body(world, shape, def, surface(random.between(0.1f, 0.8f), restitution)));
        if (i == 0 || (i == 2 && seed % 2)) continue;
        JointDef joint;
        joint.body_a = island.bodies[std::size_t(i) - 1];
        joint.body_b = island.bodies.back();
        joint.solver = JointSolver::iterative;
        joint.frame_a.position = Vec3(0, 0.25f, 0);
        joint.frame_b.position = Vec3(0, -0.25f, 0);
        joint.joint = joint_of(random);
        world.create_joint(joint);
    }
    return island;
}

// One world that holds the islands of the given seeds, in the given order.
struct Together {
    World world;
    std::vector<Island> members;

    Together(const WorldDef& def, const std::vector<int>& seeds, float restitution) : world(def) {
        for (const int seed : seeds) members.push_back(add_island(world, seed, restitution));
    }
};

bool is_same_motion(const World& world_a, BodyId body_a, const World& world_b, BodyId body_b) {
    const Body a = world_a.body(body_a), b = world_b.body(body_b);
    return a.position() == b.position() && a.rotation() == b.rotation() && a.linear_velocity() == b.linear_velocity() &&
           a.angular_velocity() == b.angular_velocity();
}
bool is_same_motion(const World& world_a, const Island& a, const World& world_b, const Island& b) {
    for (std::size_t i = 0; i < a.bodies.size(); ++i)
        if (!is_same_motion(world_a, a.bodies[i], world_b, b.bodies[i])) return false;
    return true;
}

struct BlockMates : testing::TestWithParam<std::pair<Integrator, float>> {
    WorldDef def;
    float restitution = GetParam().second;
    std::vector<int> seeds = std::vector<int>(islands);

    BlockMates() {
        def.integrator = GetParam().first;
        def.adaptive_substeps = false;
        def.enable_sleep = false;
        std::iota(seeds.begin(), seeds.end(), 0);
    }
};

TEST_P(BlockMates, DoNotNoticeEachOther) {
    Together all(def, seeds, restitution);
    std::vector<std::unique_ptr<Together>> alone;
    for (const int seed : seeds) alone.push_back(std::make_unique<Together>(def, std::vector{seed}, restitution));
    for (int step = 0; step < steps; ++step) {
        all.world.step(1.0f / 60);
        for (std::size_t i = 0; i < islands; ++i) {
            alone[i]->world.step(1.0f / 60);
            ASSERT_TRUE(is_same_motion(alone[i]->world, alone[i]->members[0], all.world, all.members[i]))
                << "island " << i << ", step " << step;
        }
    }
}

// With the islands created in reverse order, contacts and joints of one graph color lie in other lanes and blocks.
TEST_P(BlockMates, DoNotNoticeTheirOrder) {
    Together forward(def, seeds, restitution);
    std::reverse(seeds.begin(), seeds.end());
    Together backward(def, seeds, restitution);
    for (int step = 0; step < steps; ++step) {
        forward.world.step(1.0f / 60);
        backward.world.step(1.0f / 60);
        for (std::size_t i = 0; i < islands; ++i)
            ASSERT_TRUE(
                is_same_motion(forward.world, forward.members[i], backward.world, backward.members[islands - 1 - i]))
                << "island " << i << ", step " << step;
    }
}

INSTANTIATE_TEST_SUITE_P(Physics, BlockMates,
                         testing::Values(std::pair(Integrator::semi_implicit_euler, 0.0f),
                                         std::pair(Integrator::semi_implicit_euler, 0.5f),
                                         std::pair(Integrator::rk4, 0.5f)));

} // namespace
} // namespace cairn_test
