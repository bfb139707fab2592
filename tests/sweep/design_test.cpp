// Designs: the values of parameters are functions of the row number alone, and are evenly distributed.
#include "sweep/design.h"
#include "sweep/numbers.h"

#include <cairn/error.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace cairn::test {
namespace {

using sweep::Design;
using sweep::Parameter;
using sweep::Sampling;

Parameter uniform(const std::string& name, double low, double high) {
    return {name, Parameter::Kind::uniform, {}, low, high};
}

std::vector<double> row_of(const Design& design, std::uint64_t row) {
    std::vector<double> values(design.parameters().size());
    design.values(row, values);
    return values;
}

TEST(SweepNumbers, LogarithmAndExponentialAreThoseOfTheLibraryWithinAFewDigits) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        const double exponent = std::uniform_real_distribution<double>(-600.0, 600.0)(random), x = std::exp(exponent);
        ASSERT_NEAR(sweep::natural_log(x), std::log(x), 4e-16 * std::max(1.0, std::fabs(std::log(x)))) << x;
        ASSERT_NEAR(sweep::exponential(exponent) / x, 1.0, 4e-13) << exponent; // of the rounded exponent
    }
    EXPECT_EQ(sweep::natural_log(1.0), 0.0);
    EXPECT_EQ(sweep::exponential(0.0), 1.0);
}

TEST(SweepNumbers, NormalQuantilesUndoTheDistributionFunction) {
    for (double x = -8.0; x < 8.0; x += 0.01) {
        const double p = 0.5 * std::erfc(-x / std::sqrt(2.0));
        if (p < 1e-15 || p > 1.0 - 1e-9) continue; // p itself has too few digits there
        EXPECT_NEAR(sweep::normal_quantile(p), x, 1e-6 * std::max(1.0, std::fabs(x))) << p;
    }
    EXPECT_NEAR(sweep::normal_quantile(0.975), 1.959963984540054, 1e-14);
    EXPECT_EQ(sweep::normal_quantile(0.5), 0.0);
}

TEST(SweepDesign, AGridHasEveryCombinationOnceAndTheLastParameterChangesFastest) {
    const Design design(Sampling::grid,
                        {{"a", Parameter::Kind::list, {1, 2, 3}, 0, 0}, {"b", Parameter::Kind::list, {10, 20}, 0, 0}},
                        1, 0);
    ASSERT_EQ(design.rows(), 6u);
    EXPECT_EQ(row_of(design, 0), (std::vector<double>{1, 10}));
    EXPECT_EQ(row_of(design, 1), (std::vector<double>{1, 20}));
    EXPECT_EQ(row_of(design, 5), (std::vector<double>{3, 20}));
    std::set<std::vector<double>> all;
    for (std::uint64_t i = 0; i < 6; ++i) all.insert(row_of(design, i));
    EXPECT_EQ(all.size(), 6u);
}

TEST(SweepDesign, ASobolSequenceFillsEveryInterval) {
    for (const std::uint64_t seed : {0, 1, 77}) {
        std::vector<Parameter> parameters;
        for (int i = 0; i < 7; ++i) parameters.push_back(uniform(fmt::format("p{}", i), 0.0, 1.0));
        const Design design(Sampling::sobol, parameters, 1024, seed);
        std::vector<std::vector<int>> counts(7, std::vector<int>(64));
        for (std::uint64_t row = 0; row < 1024; ++row) {
            const std::vector<double> values = row_of(design, row);
            for (std::size_t i = 0; i < 7; ++i) ++counts[i][static_cast<std::size_t>(values[i] * 64.0)];
        }
        // Each interval has 16 points, except for the first point of the sequence, which is omitted, and the one that
        // follows 1024.
        for (const std::vector<int>& of_parameter : counts) {
            for (const int count : of_parameter) EXPECT_NEAR(count, 16, 1);
        }
    }
}

TEST(SweepDesign, RandomRowsAreIndependentAndMovedByTheSeed) {
    const Design design(Sampling::random, {uniform("a", -1, 3), {"b", Parameter::Kind::normal, {}, 5, 2}}, 200000, 3);
    double sum_a = 0, sum_b = 0, squares_b = 0, products = 0;
    const double n = static_cast<double>(design.rows());
    for (std::uint64_t row = 0; row < design.rows(); ++row) {
        const std::vector<double> v = row_of(design, row);
        ASSERT_GT(v[0], -1.0);
        ASSERT_LT(v[0], 3.0);
        sum_a += v[0], sum_b += v[1], squares_b += (v[1] - 5) * (v[1] - 5), products += (v[0] - 1) * (v[1] - 5);
    }
    EXPECT_NEAR(sum_a / n, 1.0, 0.01);
    EXPECT_NEAR(sum_b / n, 5.0, 0.02);
    EXPECT_NEAR(squares_b / n, 4.0, 0.05);
    EXPECT_NEAR(products / n, 0.0, 0.03);
    const Design other(Sampling::random, design.parameters(), 200000, 4);
    EXPECT_NE(row_of(design, 0), row_of(other, 0));
}

TEST(SweepDesign, SensitivityRowsDifferFromTheirPointInOneParameter) {
    const std::size_t d = 4;
    std::vector<Parameter> parameters;
    for (std::size_t i = 0; i < d; ++i) parameters.push_back(uniform(fmt::format("p{}", i), 0.0, 1.0));
    // The first points of an unshifted sequence have many coordinates in common.
    const Design design(Sampling::sensitivity, parameters, 50, 9);
    ASSERT_EQ(design.rows(), 50 * (d + 2));
    for (std::uint64_t point = 0; point < 50; ++point) {
        const std::uint64_t first = point * (d + 2);
        const std::vector<double> a = row_of(design, first), b = row_of(design, first + 1);
        for (std::size_t i = 0; i < d; ++i) {
            std::vector<double> expected = a;
            expected[i] = b[i];
            EXPECT_EQ(row_of(design, first + 2 + i), expected);
            EXPECT_NE(a[i], b[i]);
        }
    }
}

TEST(SweepDesign, TooManyRowsAndNoRowsAreRefused) {
    const std::vector<double> million(1000000, 1.0);
    const Parameter list{"a", Parameter::Kind::list, million, 0, 0};
    EXPECT_THROW(Design(Sampling::grid, {list, list}, 1, 0), Error);
    EXPECT_THROW(Design(Sampling::grid, {list, list, list, list, list}, 1, 0), Error); // beyond 64 bits
    EXPECT_THROW(Design(Sampling::grid, {{"a", Parameter::Kind::list, {}, 0, 0}}, 1, 0), Error);
    EXPECT_THROW(Design(Sampling::sensitivity, {}, 100, 0), Error);
    EXPECT_EQ(Design(Sampling::grid, {}, 1, 0).rows(), 1u);
}

} // namespace
} // namespace cairn::test
