// Sorting by integer keys.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace cairn {

// The indices of the keys in ascending order of the keys, equal ones by index. Many keys are sorted by digits of 11
// bits, the lowest first (radix sort), which has no unpredictable branches.
inline std::vector<std::uint32_t> order_by(std::span<const std::uint64_t> keys) {
    constexpr int digit_bits = 11;
    constexpr std::size_t digits = std::size_t(1) << digit_bits, few = 512;
    using Entry = std::pair<std::uint64_t, std::uint32_t>;
    std::vector<Entry> entries;
    entries.reserve(keys.size());
    for (std::uint32_t i = 0; i < keys.size(); ++i) entries.emplace_back(keys[i], i);
    if (keys.size() <= few) std::sort(entries.begin(), entries.end());
    std::vector<Entry> sorted(keys.size() <= few ? 0 : keys.size());
    for (int shift = 0; shift < 64 && !sorted.empty(); shift += digit_bits) {
        std::array<std::size_t, digits> first{};
        auto digit = [shift](const Entry& e) { return std::size_t(e.first >> shift) & (digits - 1); };
        for (const Entry& e : entries) ++first[digit(e)];
        if (first[digit(entries[0])] == entries.size()) continue; // all keys have the same digit
        std::size_t sum = 0;
        for (std::size_t& f : first) sum += std::exchange(f, sum);
        for (const Entry& e : entries) sorted[first[digit(e)]++] = e;
        entries.swap(sorted);
    }
    std::vector<std::uint32_t> order;
    order.reserve(entries.size());
    for (const Entry& e : entries) order.push_back(e.second);
    return order;
}

// Sorts distinct numbers >= 0; `marks` is working memory. Dense numbers are sorted by a bit set.
inline void sort_distinct(std::vector<std::int32_t>& numbers, std::vector<std::uint64_t>& marks) {
    if (numbers.empty()) return;
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    const std::int32_t first = *least / 64;
    const std::size_t words = std::size_t(*most / 64 - first) + 1;
    if (words > numbers.size()) {
        std::sort(numbers.begin(), numbers.end());
        return;
    }
    marks.assign(words, 0);
    for (const std::int32_t n : numbers) marks[std::size_t(n / 64 - first)] |= std::uint64_t(1) << (n % 64);
    std::size_t k = 0;
    for (std::size_t word = 0; word < words; ++word)
        for (std::uint64_t bits = marks[word]; bits != 0; bits &= bits - 1)
            numbers[k++] = 64 * (first + std::int32_t(word)) + __builtin_ctzll(bits);
}

// Integer keys in the order of the floating-point numbers; -0 and 0 have the same key.
inline std::uint64_t order_key(double x) {
    std::uint64_t bits;
    const double sum = x + 0.0;
    std::memcpy(&bits, &sum, sizeof bits);
    const std::uint64_t sign = std::uint64_t(1) << 63;
    return bits & sign ? ~bits : bits | sign;
}
inline std::uint32_t order_key(float x) {
    std::uint32_t bits;
    const float sum = x + 0.0f;
    std::memcpy(&bits, &sum, sizeof bits);
    const std::uint32_t sign = std::uint32_t(1) << 31;
    return bits & sign ? ~bits : bits | sign;
}

} // namespace cairn
