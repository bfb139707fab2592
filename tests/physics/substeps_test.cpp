// How many substeps islands take (docs/decisions/substeps.md).
#include "support.h"

namespace cairn_test {
namespace {

BodyId add_box(World& world, const Position& position, float mass) {
    BodyDef def;
    def.position = position;
    def.mass = mass;
    return add_body(world, Box{}, def, surface(0.6f));
}

// A deck of planks on balls, every fifth of them held by the ground, with a load on each.
int substeps_of_loaded_deck(float load) {
    World world(without_sleep());
    const BodyId ground = add_ground(world, surface(0.6f));
    constexpr int planks = 60;
    const auto join = [&](BodyId a, BodyId b, double x) {
        for (const double z : {-0.5, 0.5}) {
            JointDef joint = world.joint_at(a, b, {x, 3, z}, {1, 0, 0}, BallJoint{});
            joint.solver = JointSolver::iterative;
            world.create_joint(joint);
        }
    };
    BodyId last = ground;
    for (int i = 0; i < planks; ++i) {
        BodyDef def;
        def.position = {i, 3, 0};
        def.mass = 100;
        def.linear_damping = def.angular_damping = 2; // else it swings for long
        const BodyId next = add_body(world, Box{{0.45f, 0.1f, 0.5f}}, def, surface(0.6f));
        join(last, next, i - 0.5);
        if (i % 5 == 4) join(ground, next, i + 0.5);
        last = next;
        for (int k = 0; k < 3; ++k) add_box(world, {i, 3.6 + 1.001 * k, 0}, load / 3);
    }
    run(world, 1.0f / 60, 300);
    return world.statistics().max_substeps;
}

TEST(Substeps, OfADeckAtRestGrowWithItsLoad) {
    EXPECT_EQ(substeps_of_loaded_deck(30), 6);
    EXPECT_EQ(substeps_of_loaded_deck(800), 9);
    EXPECT_EQ(substeps_of_loaded_deck(20000), 11);
}

// A net of so many rows that hangs from its upper edge; its last row pulls with that many times its weight.
World hanging_net(int rows, float pull) {
    World world(without_sleep());
    constexpr int columns = 24;
    std::vector<BodyId> above;
    for (int row = 0; row < rows; ++row) {
        std::vector<BodyId> now;
        for (int column = 0; column < columns; ++column) {
            BodyDef def;
            def.type = row == 0 ? BodyType::static_ : BodyType::dynamic;
            def.position = {column, -row, 0};
            def.gravity_scale = row + 1 == rows ? pull : 1.0f;
            now.push_back(add_body(world, Sphere{0.3f}, def, surface(0)));
            const auto join = [&](BodyId other, const Position& anchor) {
                world.create_joint(world.joint_at(other, now.back(), anchor, {1, 0, 0}, BallJoint{}));
            };
            if (row > 0) join(above[std::size_t(column)], {column, -row + 0.5, 0});
            if (column > 0 && row > 0) join(now[std::size_t(column) - 1], {column - 0.5, -row, 0});
        }
        above = now;
    }
    return world;
}

TEST(Substeps, OfManyJointsAreFewerUnlessTheyBearMuch) {
    const auto substeps = [](int rows, float pull) {
        World world = hanging_net(rows, pull);
        run(world, 1.0f / 60, 60);
        return world.statistics().max_substeps;
    };
    EXPECT_EQ(substeps(12, 1), 11);
    EXPECT_EQ(substeps(28, 1), 7);
    EXPECT_EQ(substeps(28, 200), 11);
}

// Blocks in five layers, each on four others: as they were put down, or thrown together.
TEST(Substeps, OfWhatFellIntoAHeapAreFewerThanOfWhatWasBuilt) {
    for (const bool is_tossed : {false, true}) {
        World world(without_sleep());
        add_ground(world, surface(0.6f));
        for (int i = 0; i < 200; ++i) {
            const double shift = i / 40 % 2 * 0.3;
            BodyDef def;
            def.position = {1.001 * (i % 8) + shift, 0.5 + i / 40 * (is_tossed ? 1.2 : 1), 1.001 * (i / 8 % 5) + shift};
            if (is_tossed) def.linear_velocity = {0.5f * float(i % 3 - 1), -5, 0};
            add_body(world, Box{}, def, surface(0.6f));
        }
        run(world, 1.0f / 60, 300);
        EXPECT_EQ(world.statistics().max_substeps, is_tossed ? 4 : 6);
        EXPECT_LT(world.statistics().max_penetration, 0.004);
        EXPECT_LT(world.kinetic_energy(), 0.001);
    }
}

// One body that is pressed hard is neither a tower nor what a heap needs more substeps for.
TEST(Substeps, OfAHeapAreNotThoseOfOneBodyThatIsSqueezed) {
    World world(without_sleep());
    add_ground(world, surface(0.6f));
    for (int i = 0; i < 100; ++i) { // each lies on four others: one heap
        const double shift = i / 25 % 2 * 0.5 - 2;
        add_box(world, {1.001 * (i % 5) + shift, 0.5 + i / 25, 1.001 * (i / 5 % 5) + shift}, 1000);
    }
    BodyDef def;
    def.position = {0, 4.1, 0};
    const BodyId pressed = add_body(world, Box{{0.1f, 0.1f, 0.1f}}, def, surface(0.6f));
    const float weight = 100 * 1000 * 9.81f, mass = world.body(pressed).mass();
    ASSERT_NEAR(mass, 8, 0.1);
    for (int i = 0; i < 120; ++i) {
        world.body(pressed).add_force({0, -0.038f * weight, 0});
        world.step(1.0f / 60);
    }
    EXPECT_EQ(world.statistics().max_substeps, WorldDef{}.substeps);
}

} // namespace
} // namespace cairn_test
