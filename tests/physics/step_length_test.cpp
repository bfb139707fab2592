// Worlds behave alike whatever the length of their steps, at a cost that does not grow as steps become short
// (docs/decisions/substeps.md): what counts is how long a substep is.
#include "support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cairn_test {
namespace {

class StepLength : public testing::TestWithParam<int> {
  protected:
    int rate() const { return GetParam(); } // Hz
    float dt() const { return 1.0f / float(rate()); }
    // In a second, but for rounding up, as many as at 60 Hz; one in each step at least, or two.
    void expect_few_substeps(const World& world, int in_usual_step) const {
        EXPECT_LE(world.statistics().max_substeps * rate(), std::max(60 * in_usual_step * 1.6, double(2 * rate())));
    }
};

// 200 blocks thrown together in five layers.
TEST_P(StepLength, BlocksThatFellIntoAHeapOverlapAlike) {
    World world(without_sleep());
    add_ground(world, surface(0.6f));
    for (int i = 0; i < 200; ++i) {
        const double shift = i / 40 % 2 * 0.3;
        BodyDef def;
        def.position = {1.001 * (i % 8) + shift, 0.5 + i / 40 * 1.2, 1.001 * (i / 8 % 5) + shift};
        def.linear_velocity = {0.5f * float(i % 3 - 1), -5, 0};
        add_body(world, Box{}, def, surface(0.6f));
    }
    run(world, dt(), 5 * rate());
    EXPECT_LT(world.statistics().max_penetration, 0.0012);
    EXPECT_LT(world.kinetic_energy(), 1e-6);
    expect_few_substeps(world, 6);
}

// Loads that are measured in each step by itself had the number of substeps, and with it the stiffness, go up and down
// at 1,000 Hz: the tower shook.
TEST_P(StepLength, ATowerOf40Stands) {
    for (const double beside : {0.0, 0.01}) {
        World world(without_sleep());
        add_ground(world, surface(0.6f));
        BodyId top;
        for (int i = 0; i < 40; ++i) {
            BodyDef def;
            def.position = {beside * (i % 2), 0.5 + i, 0};
            top = add_body(world, Box{}, def, surface(0.6f));
        }
        run(world, dt(), 8 * rate());
        EXPECT_NEAR(world.body(top).position().y, 39.5, 0.02) << beside;
        EXPECT_LT(world.statistics().max_penetration, 0.001) << beside;
        EXPECT_LT(world.kinetic_energy(), 0.05) << beside;
        expect_few_substeps(world, 24);
    }
}

// Seven balls, let go when they are level.
TEST_P(StepLength, AChainThatWhipsHoldsTogether) {
    World world(without_sleep());
    BodyDef fixed;
    fixed.type = BodyType::static_;
    BodyId last = world.create_body(fixed);
    std::vector<JointId> joints;
    for (int i = 0; i < 7; ++i) {
        BodyDef def;
        def.position = {0.5 + i, 0, 0};
        const BodyId ball = add_body(world, Sphere{0.2f}, def, surface(0));
        joints.push_back(world.create_joint(world.joint_at(last, ball, {double(i), 0, 0}, {0, 0, 1}, BallJoint{})));
        last = ball;
    }
    float gap = 0;
    for (int i = 0; i < 5 * rate(); ++i) {
        world.step(dt());
        for (const JointId joint : joints) gap = std::max(gap, world.joint_state(joint).linear_error);
    }
    EXPECT_LT(gap, 0.012f);
    expect_few_substeps(world, 11);
}

INSTANTIATE_TEST_SUITE_P(Hz, StepLength, testing::Values(30, 60, 75, 90, 120, 144, 240, 500, 1000),
                         [](const auto& info) { return std::to_string(info.param); });

TEST(StepLength, GivesTheNumberOfSubstepsUnlessTheWorldDoes) {
    World world;
    for (const auto& [rate, substeps] : std::vector<std::pair<double, int>>{{1, 256},
                                                                            {10, 36},
                                                                            {30, 12},
                                                                            {50, 8},
                                                                            {60, 6},
                                                                            {100, 4},
                                                                            {120, 3},
                                                                            {144, 3},
                                                                            {240, 2},
                                                                            {360, 1},
                                                                            {1e4, 1},
                                                                            {1e30, 1}})
        EXPECT_EQ(world.usual_substeps(float(1 / rate)), substeps) << rate << " Hz";
    WorldDef own;
    own.substeps = 7;
    world.set_settings(own);
    for (const float dt : {1e-4f, 1.0f / 60, 1.0f}) EXPECT_EQ(world.usual_substeps(dt), 7);
    for (const float bad : {0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::nanf("")})
        EXPECT_THROW(world.usual_substeps(bad), Error) << bad;
}

} // namespace
} // namespace cairn_test
