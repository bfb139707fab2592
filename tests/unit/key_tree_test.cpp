// The key tree, compared with brute force.
#include "core/key_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace cairn {
namespace {

using Tree = KeyTree<3>;

// Finds the items within a box of keys while some are removed; many have equal keys.
TEST(KeyTree, FindsWhatALookAtAllItemsFinds) {
    std::mt19937 random(3);
    Tree tree;
    for (const std::size_t n : {0u, 1u, 7u, 8u, 9u, 100u, 3000u}) {
        std::vector<Tree::Keys> keys(n);
        for (Tree::Keys& k : keys) k = {double(random() % 20), double(random() % 20), double(random() % 3)};
        tree.build(keys, {1, 1, 1e-3});
        std::vector<bool> removed(n);
        std::size_t found = 0, asked = 0;
        for (int round = 0; round < 2000; ++round) {
            Tree::Keys lo, hi;
            for (std::size_t k = 0; k < 3; ++k) lo[k] = double(random() % 25) - 2, hi[k] = lo[k] + double(random() % 3);
            const auto is_within = [&](std::size_t i) {
                bool within = !removed[i];
                for (std::size_t k = 0; k < 3; ++k) within = within && keys[i][k] >= lo[k] && keys[i][k] <= hi[k];
                return within;
            };
            bool expected = false;
            for (std::size_t i = 0; i < n; ++i) expected = expected || is_within(i);
            std::size_t at = n;
            const bool is_any = tree.any(
                [&](const Tree::Bounds& b) {
                    for (std::size_t k = 0; k < 3; ++k)
                        if (b.lo[k] > hi[k] || b.hi[k] < lo[k]) return false;
                    return true;
                },
                [&](std::uint32_t i) {
                    ++asked;
                    if (!is_within(i)) return false;
                    at = i;
                    return true;
                });
            ASSERT_EQ(is_any, expected) << n << ' ' << round;
            if (!is_any) continue;
            ++found;
            removed[at] = true;
            tree.remove(std::uint32_t(at));
        }
        if (n == 3000) {
            EXPECT_GT(found, 100u);
            EXPECT_LT(asked, 2000u * n / 10) << "most are not looked at";
        }
    }
}

// Nodes whose items are all removed are not visited again: removing one item after the other takes no quadratic time.
TEST(KeyTree, TakingAwayAllOfOnePlaceAsksOfFew) {
    Tree tree;
    const std::vector<Tree::Keys> keys(4096, Tree::Keys{1, 2, 3});
    tree.build(keys, {1, 1, 1});
    std::vector<bool> removed(keys.size());
    std::size_t asked = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        std::uint32_t at = 0;
        ASSERT_TRUE(tree.any([](const Tree::Bounds&) { return true; },
                             [&](std::uint32_t item) { return ++asked, at = item, !removed[item]; }));
        removed[at] = true;
        tree.remove(at);
    }
    EXPECT_LT(asked, 8 * keys.size());
    EXPECT_FALSE(tree.any([](const Tree::Bounds&) { return true; }, [](std::uint32_t) { return true; }));
}

} // namespace
} // namespace cairn
