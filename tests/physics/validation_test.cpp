// Every row of `cairn validate` passes, or is no worse than its known state; and rows are judged by their bars.
#include "validation/random_starts.h"
#include "validation/text.h"
#include "validation/validation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

using namespace cairn::validation;

namespace {

class Physics : public testing::TestWithParam<Case> {};

TEST_P(Physics, IsAsExpected) {
    const Result result = GetParam().measure();
    EXPECT_FALSE(result.rows.empty());
    for (const Row& row : result.rows)
        EXPECT_TRUE(row.is_no_worse_than_known())
            << row.quantity << " at steps of " << step_text(row.time_step) << " s: expected " << row.expected
            << ", measured " << row.measured << ", bar " << row.bar << " " << row.note;
    for (const Plot& plot : result.plots)
        for (const Curve& curve : plot.curves) EXPECT_EQ(curve.x.size(), curve.y.size()) << plot.title;
}

std::string case_name(const testing::TestParamInfo<Case>& info) { return std::string(info.param.name); }
INSTANTIATE_TEST_SUITE_P(Validation, Physics, testing::ValuesIn(cases().begin(), cases().end()), case_name);

bool passes(Bar kind, double expected, double measured, double bar) {
    Row row;
    row.kind = kind;
    row.expected = expected;
    row.measured = measured;
    row.bar = bar;
    return row.passes();
}

TEST(ValidationRow, RelativeBarIsAShareOfWhatIsExpected) {
    EXPECT_TRUE(passes(Bar::relative, -200, -201.9, 0.01));
    EXPECT_TRUE(passes(Bar::relative, -200, -198.1, 0.01));
    EXPECT_FALSE(passes(Bar::relative, -200, -202.1, 0.01));
    EXPECT_FALSE(passes(Bar::relative, -200, 200, 0.01));
}
TEST(ValidationRow, AbsoluteBarIsADistance) {
    EXPECT_TRUE(passes(Bar::absolute, 45, 45.4, 0.5));
    EXPECT_TRUE(passes(Bar::absolute, 45, 44.6, 0.5));
    EXPECT_FALSE(passes(Bar::absolute, 45, 44.4, 0.5));
    EXPECT_FALSE(passes(Bar::absolute, 0, -0.6, 0.5));
}
TEST(ValidationRow, BoundsAreOneSided) {
    EXPECT_TRUE(passes(Bar::at_most, 0, 0.01, 0.01));
    EXPECT_TRUE(passes(Bar::at_most, 0, -5, 0.01));
    EXPECT_FALSE(passes(Bar::at_most, 0, 0.011, 0.01));
    EXPECT_TRUE(passes(Bar::at_least, 60, 60, 60));
    EXPECT_FALSE(passes(Bar::at_least, 60, 59.9, 60));
}
TEST(ValidationRow, WhatIsNoNumberFails) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const Bar kind : {Bar::relative, Bar::absolute, Bar::at_most, Bar::at_least})
        for (const double value : {std::nan(""), infinity, -infinity})
            EXPECT_FALSE(passes(kind, 1, value, 0.5)) << int(kind) << " " << value;
}

TEST(ValidationCases, AreFoundByNameAndNumber) {
    for (const Case& entry : cases()) {
        EXPECT_EQ(find_case(entry.name), &entry);
        EXPECT_EQ(find_case(std::to_string(entry.number)), &entry);
    }
    for (const char* unknown : {"", "0", "99", "4 ", "04", "Pendulum", "pend"})
        EXPECT_EQ(find_case(unknown), nullptr) << unknown;
}
TEST(ValidationCases, AreNumberedInOrderAndNamedInSnakeCase) {
    std::set<std::string> names;
    int last = 0;
    for (const Case& entry : cases()) {
        EXPECT_GT(entry.number, last);
        last = entry.number;
        EXPECT_EQ(entry.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789"), std::string::npos);
        EXPECT_TRUE(names.insert(std::string(entry.name)).second) << entry.name;
        EXPECT_FALSE(entry.title.empty());
        EXPECT_FALSE(entry.law.empty());
    }
    EXPECT_GT(last, 0);
}

// Compilers evaluate the arguments of a call in different orders: clang once drew other rotations than GCC.
TEST(RandomStart, IsTheSameWithEveryCompiler) {
    RandomStart start(7);
    const glm::dquat turn = start.rotation();
    EXPECT_NEAR(turn.w, 0.814856119, 1e-9);
    EXPECT_NEAR(turn.x, 0.372984823, 1e-9);
    EXPECT_NEAR(turn.y, -0.153981783, 1e-9);
    EXPECT_NEAR(turn.z, 0.416150739, 1e-9);
    EXPECT_NEAR(start.uniform(0, 1), 0.716409, 1e-6);
}

} // namespace
