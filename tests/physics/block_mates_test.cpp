// Islands are solved 8 contacts or joints at a time, and those of several islands share a block: none may notice. Each
// island must move as it does in a world of its own, to the last bit.
#include "support.h"

#include <cstring>
#include <memory>
#include <random>
#include <utility>

namespace cairn_test {
namespace {

constexpr int islands = 12, steps = 90;
constexpr double spacing = 64; // m; a power of two, so that places round alike

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

// Of each type one in an island: which of two boxes is A in their contact depends on the tree of the broad phase.
Shape shape_of(int type, RandomStart& random) {
    const float a = random.between(0.1f, 0.3f), b = random.between(0.1f, 0.2f);
    switch (type) {
    case 0:
        return Sphere{a};
    case 1:
        return Box{{a, b, 0.15f}};
    case 2:
        return Capsule{a, 0.1f, {}};
    default:
        return Cylinder{b, 0.15f, {}, 0};
    }
}

// Joined and loose bodies that fall, quickly turning, onto the ground and each other.
Island add_island(World& world, int seed, float restitution) {
    RandomStart random(seed);
    Island island;
    const Vec3 thrown = random.vector(3) - Vec3(0, random.between(0, 12), 0);
    const int count = 3 + random.below(2), first_type = random.below(4);
    for (int i = 0; i < count; ++i) {
        BodyDef def;
        def.position = Position(spacing * seed, 0, 0) + Position(0.05 * (i % 2), 0.4 + 0.5 * i, 0);
        def.rotation = random.rotation();
        def.linear_velocity = thrown;
        def.angular_velocity = random.vector(random.below(2) ? 2.0f : 15.0f);
        const Shape shape = shape_of((first_type + i) % 4, random);
        island.bodies.push_back(add_body(world, shape, def, surface(random.between(0.1f, 0.8f), restitution)));
        if (i == 0 || (i == 2 && seed % 2)) continue;
        JointDef joint;
        joint.body_a = island.bodies[std::size_t(i) - 1];
        joint.body_b = island.bodies.back();
        joint.solver = JointSolver::iterative;
        joint.frame_a.position = Vec3(0, 0.25f, 0);
        joint.frame_b.position = Vec3(0, -0.25f, 0);
        joint.joint = BallJoint{};
        if (random.below(3) == 0) joint.joint = HingeJoint{};
        world.create_joint(joint);
    }
    return island;
}

// One island, or all.
struct Together {
    World world;
    std::vector<Island> members;

    Together(const WorldDef& def, int first, int end, float restitution) : world(def) {
        add_ground(world, surface(0.5f, restitution));
        for (int i = first; i < end; ++i) members.push_back(add_island(world, i, restitution));
    }
};

struct Motion {
    Position x;
    Quat q;
    Vec3 v, w;
};
Motion motion_of(const World& world, BodyId id) {
    const Body body = world.body(id);
    return {body.position(), body.rotation(), body.linear_velocity(), body.angular_velocity()};
}
bool is_same(const Motion& a, const Motion& b) { return a.x == b.x && a.q == b.q && a.v == b.v && a.w == b.w; }

// The first step after which an island is another than alone; -1: none.
int parts_at(const WorldDef& def, float restitution, int which) {
    Together all(def, 0, islands, restitution), alone(def, which, which + 1, restitution);
    const std::vector<BodyId>&one = alone.members[0].bodies, &same = all.members[std::size_t(which)].bodies;
    for (int step = 0; step < steps; ++step) {
        all.world.step(1.0f / 60);
        alone.world.step(1.0f / 60);
        for (std::size_t i = 0; i < one.size(); ++i)
            if (!is_same(motion_of(alone.world, one[i]), motion_of(all.world, same[i]))) return step;
    }
    return -1;
}

struct BlockMates : testing::TestWithParam<std::pair<Integrator, float>> {};

TEST_P(BlockMates, DoNotNoticeEachOther) {
    WorldDef def;
    def.enable_sleep = false;
    def.adaptive_substeps = false;
    def.integrator = GetParam().first;
    for (int which = 0; which < islands; ++which) EXPECT_EQ(parts_at(def, GetParam().second, which), -1) << which;
}

INSTANTIATE_TEST_SUITE_P(Physics, BlockMates,
                         testing::Values(std::pair(Integrator::semi_implicit_euler, 0.0f),
                                         std::pair(Integrator::semi_implicit_euler, 0.5f),
                                         std::pair(Integrator::rk4, 0.5f)));

} // namespace
} // namespace cairn_test
