// Sorting of integers, compared with the standard library.
#include "core/order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace cairn {
namespace {

void expect_sorted(std::vector<std::int32_t> numbers, std::vector<std::uint64_t>& marks) {
    std::vector<std::int32_t> expected = numbers;
    std::sort(expected.begin(), expected.end());
    sort_distinct(numbers, marks);
    EXPECT_EQ(numbers, expected);
}

TEST(Order, DistinctNumbersAreSortedWhetherCloseTogetherOrFarApart) {
    std::mt19937 random(1);
    std::vector<std::uint64_t> marks;
    expect_sorted({}, marks);
    expect_sorted({63}, marks);
    expect_sorted({64, 63, 0, 127}, marks);
    expect_sorted({2147483647, 0, 2147483600}, marks);
    for (const std::int32_t stride : {1, 3, 40, 100, 4000}) {
        std::vector<std::int32_t> numbers(1000);
        for (std::int32_t i = 0; i < 1000; ++i)
            numbers[std::size_t(i)] = 777 + stride * i + std::int32_t(random() % unsigned(stride));
        expect_sorted(numbers, marks);
        std::shuffle(numbers.begin(), numbers.end(), random);
        expect_sorted(numbers, marks);
    }
}

} // namespace
} // namespace cairn
