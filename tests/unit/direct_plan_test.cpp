// Elimination order and fill of the direct joint solver, compared with elimination on a dense boolean matrix.
#include "joints/direct_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace cairn {
namespace {

std::vector<DirectEnds> random_ends(std::mt19937& random, int nodes, int bodies) {
    std::vector<DirectEnds> ends;
    for (int i = 0; i < nodes; ++i) {
        const int a = int(random() % unsigned(bodies)) - 1; // -1: a body that does not move
        int b = int(random() % unsigned(bodies)) - 1;
        if (a == b) b = a < 0 ? 0 : -1;
        ends.push_back({{a, b}});
    }
    return ends;
}

bool share_body(const DirectEnds& a, const DirectEnds& b) {
    for (const int i : a.body)
        for (const int j : b.body)
            if (i >= 0 && i == j) return true;
    return false;
}

TEST(DirectPlan, FillIsThatOfTheElimination) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        const int n = 1 + int(random() % 40u);
        const std::vector<DirectEnds> ends = random_ends(random, n, 2 + int(random() % 40u));
        DirectPlan plan;
        std::vector<std::uint32_t> order;
        ASSERT_TRUE(make_direct_plan(ends, 100000, 100000, plan, order));
        ASSERT_EQ(plan.node_count(), std::size_t(n));
        EXPECT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), std::size_t(n));

        const std::size_t size = std::size_t(n);
        std::vector<std::vector<bool>> full(size, std::vector<bool>(size, false));
        for (std::size_t i = 0; i < full.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) full[i][j] = full[j][i] = share_body(ends[order[i]], ends[order[j]]);
        const std::uint32_t* product = plan.products.data();
        for (std::size_t k = 0; k < full.size(); ++k) {
            auto degree = [&](std::size_t i) {
                return std::count(full[i].begin() + std::ptrdiff_t(k), full[i].end(), true);
            };
            for (std::size_t i = k + 1; i < full.size(); ++i) EXPECT_LE(degree(k), degree(i));
            std::vector<std::uint32_t> column;
            for (std::size_t i = k + 1; i < full.size(); ++i)
                if (full[i][k]) column.push_back(std::uint32_t(i));
            ASSERT_EQ(column, std::vector<std::uint32_t>(plan.rows.begin() + plan.first[k],
                                                         plan.rows.begin() + plan.first[k + 1]));
            for (std::size_t a = column.size(); a-- > 0;)
                for (std::size_t b = 0; b < a; ++b) {
                    full[column[a]][column[b]] = full[column[b]][column[a]] = true;
                    const std::uint32_t block = *product++;
                    EXPECT_EQ(plan.rows[block], column[a]);
                    EXPECT_GE(block, plan.first[column[b]]);
                    EXPECT_LT(block, plan.first[column[b] + 1]);
                }
        }
        EXPECT_EQ(product, plan.products.data() + plan.products.size());
        for (const DirectCoupling& c : plan.couplings) {
            EXPECT_EQ(plan.rows[c.block], c.row);
            EXPECT_EQ(ends[order[c.row]].body[c.row_side], ends[order[c.column]].body[c.column_side]);
        }
    }
}

TEST(DirectPlan, ChainHasOneBlockForEachJointAndRingsHaveTwo) {
    std::vector<DirectEnds> chain;
    for (int i = 0; i < 100; ++i) chain.push_back({{i - 1, i}});
    DirectPlan plan;
    std::vector<std::uint32_t> order;
    ASSERT_TRUE(make_direct_plan(chain, 100000, 100000, plan, order));
    EXPECT_EQ(plan.block_count(), 99u);
    chain[0].body[0] = 99; // a closed chain
    ASSERT_TRUE(make_direct_plan(chain, 100000, 100000, plan, order));
    EXPECT_LT(plan.block_count(), 200u);
}

TEST(DirectPlan, GivesUpOnWhatIsTooFull) {
    std::vector<DirectEnds> star;
    for (int i = 0; i < 50; ++i) star.push_back({{0, i + 1}});
    DirectPlan plan;
    std::vector<std::uint32_t> order;
    EXPECT_FALSE(make_direct_plan(star, 1000, 100000, plan, order));
    EXPECT_FALSE(make_direct_plan(star, 100000, 10000, plan, order));
    EXPECT_TRUE(make_direct_plan(star, 1225, 100000, plan, order));
}

} // namespace
} // namespace cairn
