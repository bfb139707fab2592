// Undo and redo.
#include "random_changes.h"

#include <gtest/gtest.h>

#include <utility>

namespace cairn::test {
namespace {

class Histories : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Histories, OfAThousandChangesGiveTheHashesFromBeforeInAnyOrderOfUndoAndRedo) {
    World world;
    RandomChanges changes(GetParam());
    changes.populate(world);
    History history(world);
    struct Seen {
        std::uint64_t hash;
        std::vector<BodyId> bodies;
        std::vector<JointId> joints;
        WorldDef settings;
    };
    const auto look = [&] { return Seen{world.state_hash(), world.bodies(), world.joints(), world.settings()}; };
    std::vector<Seen> states{look()}; // before the first change, and after each change
    std::size_t at = 0;
    const auto expect_same = [&](int round) {
        const Seen now = look();
        ASSERT_EQ(now.hash, states[at].hash) << "round " << round << ", position " << at;
        ASSERT_EQ(now.bodies, states[at].bodies);
        ASSERT_EQ(now.joints, states[at].joints);
        ASSERT_EQ(now.settings.gravity, states[at].settings.gravity);
    };
    std::mt19937 random(GetParam());
    int made = 0, undone = 0, redone = 0;
    for (int round = 0; made < 1000; ++round) {
        const std::uint32_t kind = random() % 8;
        if (kind < 4) {
            for (std::uint32_t k = 1 + random() % 3; k > 0; --k) changes.change(world);
            if (!history.commit(world, "change " + std::to_string(made))) continue; // the whole change was rejected
            states.resize(++at);
            states.push_back(look());
            ++made;
        } else if (kind < 6) {
            if (at == 0) {
                ASSERT_FALSE(history.undo(world));
                continue;
            }
            if (random() % 4 == 0) world.step(dt); // steps are not committed, and are therefore lost
            ASSERT_TRUE(history.undo(world));
            --at, ++undone;
            expect_same(round);
        } else {
            const bool can_redo = at + 1 < states.size();
            ASSERT_EQ(history.redo(world), can_redo);
            if (can_redo) ++at, ++redone;
            expect_same(round);
        }
        ASSERT_EQ(history.undoable().size(), at);
        ASSERT_EQ(history.redoable().size(), states.size() - 1 - at);
    }
    EXPECT_GT(undone, 200);
    EXPECT_GT(redone, 50);
    while (history.undo(world)) {
        --at;
        expect_same(-1);
    }
    EXPECT_EQ(at, 0u);
    while (history.redo(world)) {
        ++at;
        expect_same(-2);
    }
    EXPECT_EQ(at + 1, states.size());
}
INSTANTIATE_TEST_SUITE_P(Seeds, Histories, testing::Range(1u, 3u));

TEST(History, KeepsTheNewestChangesWithinItsBudget) {
    World world;
    RandomChanges changes(2);
    changes.populate(world);
    History history(world, 300000);
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 600; ++i) {
        changes.change(world), world.step(dt);
        hashes.push_back(world.state_hash());
        history.commit(world, std::to_string(i));
    }
    EXPECT_LT(history.bytes(), 400000u);
    const std::vector<std::string> left = history.undoable();
    ASSERT_GT(left.size(), 20u);
    EXPECT_LT(left.size(), 600u);
    EXPECT_EQ(left.back(), "599");
    std::size_t at = 599;
    while (history.undo(world)) {
        ASSERT_EQ(world.state_hash(), hashes[--at]);
    }
    EXPECT_EQ(at + left.size(), 599u);
    EXPECT_EQ(history.redoable().size(), left.size());
}

TEST(History, OfNothingHasNothingToUndo) {
    World world;
    History history(world);
    EXPECT_FALSE(history.undo(world));
    EXPECT_FALSE(history.redo(world));
    EXPECT_FALSE(history.commit(world, "nothing"));
    const BodyId body = world.create_body();
    EXPECT_TRUE(history.commit(world, "create"));
    EXPECT_EQ(history.undoable(), std::vector<std::string>{"create"});
    EXPECT_TRUE(history.undo(world));
    EXPECT_FALSE(world.is_valid(body));
    EXPECT_EQ(history.redoable(), std::vector<std::string>{"create"});
    EXPECT_TRUE(history.redo(world));
    EXPECT_TRUE(world.is_valid(body)); // the same handle
    world.body(body).set_position({1, 2, 3});
    EXPECT_FALSE(history.redo(world));
    EXPECT_TRUE(history.commit(world, "move"));
    EXPECT_TRUE(history.undo(world));
    EXPECT_EQ(std::as_const(world).body(body).position(), Position(0, 0, 0));
}

} // namespace
} // namespace cairn::test
