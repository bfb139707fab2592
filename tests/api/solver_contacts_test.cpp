// World::solver_contacts: which contacts are solved side by side in lanes, and in how many substeps.
#include "test_world.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace cairn::test {
namespace {

TEST(SolverContacts, ThoseOfOneColorShareNoBodyThatMoves) {
    World world;
    add_ground(world);
    for (int i = 0; i < 60; ++i) add_crate(world, {0.7 * (i % 4), 0.5 + i / 4, 0.1 * (i % 3)});
    run(world, 30);
    const std::vector<SolverContact> order = world.solver_contacts();
    const std::vector<Contact> contacts = world.contacts();
    ASSERT_EQ(order.size(), contacts.size());
    ASSERT_GT(order.size(), 60u);
    std::set<std::pair<int, BodyId>> met;
    int greatest = 0, moving = 0, lowest_with_ground = 100;
    for (std::size_t i = 0; i < order.size(); ++i) {
        EXPECT_EQ(order[i].shape_a, contacts[i].shape_a);
        EXPECT_EQ(order[i].shape_b, contacts[i].shape_b);
        EXPECT_EQ(order[i].body_a, contacts[i].body_a);
        EXPECT_EQ(order[i].body_b, contacts[i].body_b);
        greatest = std::max(greatest, order[i].substeps);
        bool is_fixed = false;
        for (const BodyId body : {order[i].body_a, order[i].body_b}) {
            const bool moves = world.body(body).type() == BodyType::dynamic;
            is_fixed |= !moves;
            EXPECT_TRUE(!moves || order[i].color < 0 || met.emplace(order[i].color, body).second) << order[i].color;
        }
        if (is_fixed)
            lowest_with_ground = std::min(lowest_with_ground, order[i].color);
        else
            moving = std::max(moving, order[i].color);
    }
    EXPECT_LT(moving, lowest_with_ground) << "what stands on the ground has the last word";
    EXPECT_EQ(greatest, world.statistics().max_substeps);
}

TEST(SolverContacts, OfATallStackAreSolvedInMoreSubstepsThanThoseOfACrate) {
    World world;
    add_ground(world);
    const BodyId crate = add_crate(world, {20.0, 0.5, 0.0});
    for (int i = 0; i < 20; ++i) add_crate(world, {0.0, 0.5 + i, 0.0});
    run(world, 20);
    int of_crate = 0, of_stack = 0;
    for (const SolverContact& contact : world.solver_contacts()) {
        const bool is_crate = contact.body_a == crate || contact.body_b == crate;
        (is_crate ? of_crate : of_stack) = contact.substeps;
    }
    EXPECT_GE(of_crate, 1);
    EXPECT_GT(of_stack, of_crate);
}

TEST(SolverContacts, AreNoneInAnEmptyWorldAndUnsolvedBeforeTheFirstStep) {
    World world;
    EXPECT_TRUE(world.solver_contacts().empty());
    add_ground(world);
    add_crate(world, {0.0, 0.49, 0.0});
    for (const SolverContact& contact : world.solver_contacts()) EXPECT_EQ(contact.substeps, 0);
}

} // namespace
} // namespace cairn::test
