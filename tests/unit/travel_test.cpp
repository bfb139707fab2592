// Travel: sums of lengths that wrap around, and results that are valid until the travel reaches an end.
#include "state/travel.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using cairn::budget_of;
using cairn::is_before;
using cairn::Travel;
using cairn::travelled;

TEST(Travel, SmallMotionsAreNotLostBesideLongOnes) {
    Travel travel = 0;
    for (int i = 0; i < 1000; ++i) travel += travelled(1e12); // teleports
    const Travel end = travel + budget_of(1e-6);
    int steps = 0;
    while (is_before(travel, end)) travel += travelled(1e-9), ++steps;
    EXPECT_GE(steps, 800); // rounded up, by at most a quarter of a nanometer
    EXPECT_LE(steps, 1000);
}

TEST(Travel, WhatHoldsUntilAnEndHoldsWhereTheSumRunsOver) {
    const Travel travel = std::numeric_limits<Travel>::max() - travelled(0.5);
    const Travel end = travel + budget_of(1.0);
    EXPECT_LT(end, travel);
    EXPECT_TRUE(is_before(travel, end));
    EXPECT_TRUE(is_before(travel + travelled(0.9), end));
    EXPECT_FALSE(is_before(travel + travelled(1.1), end));
}

TEST(Travel, ALeapSpendsEveryBudget) {
    for (const double budget : {0.0, 1.0, 1e4, 1e30, std::numeric_limits<double>::infinity()})
        for (const double leap :
             {1e4, 1e12, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
            EXPECT_FALSE(is_before(travelled(leap), budget_of(budget))) << budget << " " << leap;
    EXPECT_EQ(budget_of(-1.0), Travel(0));
    EXPECT_GT(travelled(0.0), Travel(0)); // a counted length is never zero
}

} // namespace
