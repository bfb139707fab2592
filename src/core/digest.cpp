#include "core/digest.h"

#include "core/hash.h"

namespace cairn {

namespace {

__extension__ using Wide = unsigned __int128;
constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;

constexpr std::uint64_t add(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t sum = a + b;
    return sum >= prime ? sum - prime : sum;
}
constexpr std::uint64_t subtract(std::uint64_t a, std::uint64_t b) { return a >= b ? a - b : a + prime - b; }
constexpr std::uint64_t multiply(std::uint64_t a, std::uint64_t b) {
    const Wide product = Wide(a) * b;
    return add(std::uint64_t(product & prime), std::uint64_t(product >> 61));
}
constexpr std::uint64_t inverse(std::uint64_t a) { // a^(prime - 2)
    std::uint64_t result = 1;
    for (std::uint64_t exponent = prime - 2; exponent != 0; exponent >>= 1, a = multiply(a, a))
        if (exponent & 1) result = multiply(result, a);
    return result;
}
static_assert(multiply(inverse(12345678901234567u), 12345678901234567u) == 1);

} // namespace

void add_to_digest(StateDigest& digest, std::uint32_t slot, const void* state, std::size_t size) {
    Hash64 hash;
    hash.add(slot);
    hash.add_bytes(state, size);
    std::uint64_t term = hash.value() % prime;
    for (std::uint64_t& sum : digest.sums) {
        sum = add(sum, term);
        term = multiply(term, std::uint64_t{slot} + 1);
    }
}

std::vector<std::uint32_t> differing_slots(const StateDigest& a, const StateDigest& b, std::uint32_t slots) {
    std::uint64_t d[4];
    bool differ = false;
    for (int k = 0; k < 4; ++k) {
        d[k] = subtract(b.sums[std::size_t(k)] % prime, a.sums[std::size_t(k)] % prime);
        differ |= d[k] != 0;
    }
    if (!differ) return {};
    const std::uint64_t determinant = subtract(multiply(d[0], d[2]), multiply(d[1], d[1]));
    if (determinant == 0) { // one body differs, or many
        if (d[0] == 0) return {};
        const std::uint64_t place = multiply(d[1], inverse(d[0]));
        if (place == 0 || place > slots || multiply(d[2], place) != d[3]) return {};
        return {std::uint32_t(place - 1)};
    }
    // Two bodies differ: the roots of x^2 - e1 x + e2.
    const std::uint64_t over = inverse(determinant);
    const std::uint64_t e1 = multiply(subtract(multiply(d[0], d[3]), multiply(d[1], d[2])), over);
    const std::uint64_t e2 = multiply(subtract(multiply(d[1], d[3]), multiply(d[2], d[2])), over);
    std::vector<std::uint32_t> found;
    for (std::uint64_t x = 1; x <= slots; ++x)
        if (add(multiply(x, subtract(x, e1)), e2) == 0) found.push_back(std::uint32_t(x - 1));
    if (found.size() != 2) found.clear();
    return found;
}

} // namespace cairn
