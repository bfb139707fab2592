#include "core/image_archive.h"

namespace cairn {

namespace {

// Encoding of a delta: the number of equal groups of eight words; then, for the next group, a bit mask of the 16-bit
// quarters that differ, and the exclusive or of these; and so on.
constexpr std::size_t group = 8;
constexpr std::size_t most_of_group = 4 + group * 8 + 2, most_of_number = 10; // 2: an overwritten quarter

std::byte* put_number(std::byte* to, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) *to++ = std::byte(value | 0x80);
    *to++ = std::byte(value);
    return to;
}
std::uint64_t take_number(const std::byte*& from) {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
        const auto next = std::uint64_t(*from++);
        value |= (next & 0x7f) << shift;
        if (next < 0x80) return value;
    }
}

constexpr std::size_t words_of(std::size_t bytes) { return (bytes + 7) / 8; }

std::byte* put_group(std::byte* to, std::uint64_t* words, const std::uint64_t* now, std::size_t count) {
    std::byte* const place = to;
    to += 4;
    std::uint32_t mask = 0;
    for (std::size_t k = 0; k < count; ++k) {
        std::uint64_t difference = words[k] ^ now[k];
        words[k] = now[k];
        for (unsigned quarter = 0; difference != 0; ++quarter, difference >>= 16) {
            const auto part = std::uint16_t(difference);
            std::memcpy(to, &part, 2);
            const std::uint32_t differs = part != 0;
            mask |= differs << (4 * k + quarter);
            to += 2 * differs;
        }
    }
    std::memcpy(place, &mask, 4);
    return to;
}

} // namespace

void ImageWriter::write(const void* data, std::size_t size) {
    if (part_ == image_.parts.size()) image_.parts.emplace_back();
    StateImage::Part& part = image_.parts[part_++];
    const std::size_t before = part.size, common = std::max(words_of(before), words_of(size));
    part.words.resize(common); // the shorter one is extended by zeros
    const std::size_t most = 2 * most_of_number + (common / group + 1) * (most_of_group + most_of_number);
    if (room_.size() < used_ + most) room_.resize(2 * (used_ + most));
    std::byte* to = put_number(room_.data() + used_, before);
    const auto* from = static_cast<const std::byte*>(data);
    std::uint64_t now[group];
    std::uint64_t same = 0;
    const auto put = [&](std::size_t first, std::size_t count) {
        std::uint64_t differs = 0;
        for (std::size_t k = 0; k < count; ++k) differs |= now[k] ^ part.words[first + k];
        if (differs == 0) {
            ++same;
            return;
        }
        to = put_number(to, same);
        to = put_group(to, &part.words[first], now, count);
        same = 0;
    };
    std::size_t first = 0;
    for (; first + group <= common && 8 * (first + group) <= size; first += group) {
        std::memcpy(now, from + 8 * first, sizeof now);
        put(first, group);
    }
    for (; first < common; first += group) { // the group where one of the two ends
        std::memset(now, 0, sizeof now);
        if (8 * first < size) std::memcpy(now, from + 8 * first, std::min(sizeof now, size - 8 * first));
        put(first, std::min(group, common - first));
    }
    to = put_number(to, same);
    used_ = std::size_t(to - room_.data());
    part.words.resize(words_of(size));
    part.size = size;
}

void apply_delta(StateImage& image, const StateDelta& back) {
    const std::byte* from = back.data();
    for (StateImage::Part& part : image.parts) {
        const std::size_t before = std::size_t(take_number(from));
        const std::size_t common = std::max(words_of(before), words_of(part.size));
        part.words.resize(common);
        const std::size_t groups = (common + group - 1) / group;
        for (std::size_t g = std::size_t(take_number(from)); g < groups; g += 1 + std::size_t(take_number(from))) {
            std::uint32_t mask = 0;
            std::memcpy(&mask, from, 4);
            from += 4;
            for (; mask != 0; mask &= mask - 1, from += 2) {
                const unsigned at = unsigned(std::countr_zero(mask));
                std::uint16_t part_of_word = 0;
                std::memcpy(&part_of_word, from, 2);
                part.words[g * group + at / 4] ^= std::uint64_t(part_of_word) << (16 * (at % 4));
            }
        }
        part.words.resize(words_of(before));
        part.size = before;
    }
}

} // namespace cairn
