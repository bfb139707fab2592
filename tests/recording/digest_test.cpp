// State digests: they identify the bodies in which two worlds differ, given the digest of one of them.
#include "random_changes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cairn::test {
namespace {

class Digest : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Digest, TellsWhichOneOrTwoBodiesDiffer) {
    RandomChanges changes(GetParam());
    World world, other;
    changes.populate(world);
    for (int i = 0; i < 200; ++i) changes.change(world);
    std::mt19937 random(GetParam());
    const std::vector<BodyId> bodies = world.bodies();
    for (const BodyId id : bodies) world.body(id).wake(); // otherwise moving a body would wake, and so change, others
    for (int round = 0; round < 100; ++round) {
        other.restore(world.save());
        EXPECT_EQ(other.state_digest(), world.state_digest());
        EXPECT_TRUE(other.bodies_that_differ(world.state_digest()).empty());
        std::vector<BodyId> moved;
        for (std::size_t i = 0; i < 1 + std::size_t(round % 3); ++i) {
            const BodyId id = bodies[random() % bodies.size()];
            if (std::find(moved.begin(), moved.end(), id) == moved.end()) moved.push_back(id);
        }
        for (const BodyId id : moved) {
            Position at = other.body(id).position();
            at.x += 1e-6;
            other.body(id).set_position(at);
        }
        std::sort(moved.begin(), moved.end(), [](BodyId a, BodyId b) { return a.index() < b.index(); });
        EXPECT_NE(other.state_digest(), world.state_digest());
        if (moved.size() > 2) moved.clear(); // more than two cannot be identified
        EXPECT_EQ(other.bodies_that_differ(world.state_digest()), moved);
        EXPECT_EQ(world.bodies_that_differ(other.state_digest()), moved);
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, Digest, testing::Range(1u, 6u));

TEST(Digest, OfABodyThatOnlyOneWorldHasDiffers) {
    World world, other;
    for (int i = 0; i < 5; ++i) world.create_body(), other.create_body();
    const BodyId more = other.create_body();
    EXPECT_EQ(other.bodies_that_differ(world.state_digest()), std::vector{more});
    EXPECT_TRUE(world.bodies_that_differ(other.state_digest()).empty());
}

} // namespace
} // namespace cairn::test
