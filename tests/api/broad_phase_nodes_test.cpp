// World::broad_phase_nodes: bounding volume trees whose boxes contain their children, with every shape except planes
// exactly once.
#include "test_world.h"

#include <map>
#include <set>
#include <vector>

namespace cairn::test {
namespace {

bool holds(const Bounds& outer, const Bounds& inner) {
    for (int i = 0; i < 3; ++i)
        if (!(inner.min[i] >= outer.min[i] && inner.max[i] <= outer.max[i])) return false;
    return true;
}

// Falling crates, two piles of sleeping crates, static boxes, and one large box.
void fill(World& world) {
    add_ground(world);
    for (int i = 0; i < 30; ++i)
        add_body(world, body_at({3.0 * i, -0.5, 20.0}, BodyType::static_), Box{{0.4f, 0.3f, 0.4f}});
    for (const double x : {0.0, 40.0})
        for (int i = 0; i < 6; ++i) add_crate(world, {x + 0.1 * (i % 2), 0.5 + i, 0.0});
    run(world, 360);
    for (int i = 0; i < 100; ++i) add_crate(world, {1.5 * (i % 10), 30.0 + 1.5 * (i / 10), 5.0});
    add_body(world, body_at({0.0, 60.0, 0.0}), Box{{20.0f, 1.0f, 20.0f}});
    run(world, 2);
}

std::vector<BroadPhaseNode> all_nodes(const World& world) { return world.broad_phase_nodes(1000, 1'000'000); }

TEST(BroadPhaseNodes, HoldWhatIsBelowThemAndEveryShapeOnce) {
    World world;
    fill(world);
    const std::vector<BroadPhaseNode> nodes = all_nodes(world);
    std::set<ShapeId> found;
    std::map<int, int> children;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const BroadPhaseNode& node = nodes[i];
        EXPECT_LE(nodes[i - (i > 0)].depth, node.depth);
        EXPECT_EQ(node.depth == 0, node.parent == -1);
        EXPECT_EQ(node.is_leaf, world.is_valid(node.shape));
        if (node.parent >= 0) {
            ASSERT_LT(node.parent, int(i));
            const BroadPhaseNode& above = nodes[std::size_t(node.parent)];
            EXPECT_FALSE(above.is_leaf);
            EXPECT_EQ(above.depth + 1, node.depth);
            EXPECT_EQ(above.tree, node.tree);
            EXPECT_TRUE(holds(above.bounds, node.bounds)) << i;
            EXPECT_LE(++children[node.parent], 8);
        }
        if (!node.is_leaf) continue;
        EXPECT_TRUE(found.insert(node.shape).second) << "twice";
        EXPECT_TRUE(holds(node.bounds, world.shape_bounds(node.shape)));
        const Body body = world.body(world.body_of(node.shape));
        const BroadPhaseTree tree = body.type() == BodyType::static_ ? BroadPhaseTree::fixed
                                    : !body.is_awake()               ? BroadPhaseTree::sleeping
                                    : body.position().y > 50.0       ? BroadPhaseTree::large
                                                                     : BroadPhaseTree::awake;
        EXPECT_EQ(node.tree, tree) << "shape " << node.shape.index();
    }
    std::map<BroadPhaseTree, int> leaves;
    for (const BroadPhaseNode& node : nodes) leaves[node.tree] += node.is_leaf;
    EXPECT_EQ(leaves[BroadPhaseTree::fixed], 30);
    EXPECT_EQ(leaves[BroadPhaseTree::sleeping], 12);
    EXPECT_EQ(leaves[BroadPhaseTree::awake], 100);
    EXPECT_EQ(leaves[BroadPhaseTree::large], 1);
}

TEST(BroadPhaseNodes, AreCutOffWhereTheyAreTooDeepOrTooMany) {
    World world;
    fill(world);
    const std::vector<BroadPhaseNode> nodes = all_nodes(world);
    ASSERT_GT(nodes.size(), 100u);
    for (const auto& [depth, count] : {std::pair(0, 1000), {1, 1000}, {2, 7}, {1000, 100}, {1000, 0}, {0, 2}}) {
        const std::vector<BroadPhaseNode> some = world.broad_phase_nodes(depth, count);
        std::size_t expected = 0;
        while (expected < nodes.size() && expected < std::size_t(count) && nodes[expected].depth <= depth) ++expected;
        ASSERT_EQ(some.size(), expected) << depth << ", " << count;
        for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i].bounds.min, nodes[i].bounds.min);
    }
    EXPECT_NE(refusal([&] { world.broad_phase_nodes(-1, 1); }), "");
    EXPECT_NE(refusal([&] { world.broad_phase_nodes(1, -1); }), "");
}

TEST(BroadPhaseNodes, OfAnEmptyWorldAreNone) {
    World world;
    add_ground(world);
    EXPECT_TRUE(all_nodes(world).empty());
    world.destroy_body(add_crate(world, {0.0, 5.0, 0.0}));
    EXPECT_TRUE(all_nodes(world).empty());
}

} // namespace
} // namespace cairn::test
