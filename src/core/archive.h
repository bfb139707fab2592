// Serialization of state to bytes and back, with one `serialize(archive)` per class for both directions. Elements of
// vectors are packed: only those 32-bit words are stored that differ from a prediction, by default the element before.
// This is lossless for any prediction, as long as writer and reader predict the same.
#pragma once

#include "core/bit_cast.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace cairn {

namespace archive_detail {

template <class T> inline constexpr bool is_packed = sizeof(T) % 4 == 0 && sizeof(T) > 8;
template <class T> using Words = std::array<std::uint32_t, sizeof(T) / 4>;

// Words are stored in groups, each with a bit mask of the words that differ from the prediction.
inline constexpr std::size_t group = 32;
constexpr std::size_t mask_size(std::size_t words) { return (words + 7) / 8; }
template <class T> inline constexpr std::size_t max_packed_size = sizeof(T) + 4 * ((sizeof(T) / 4 + group - 1) / group);

// Calls `f(first)` for the first word of each group as a compile-time constant, so that the sizes of masks are
// constant, too.
template <class T, class F> void for_groups(F&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (f(std::integral_constant<std::size_t, I * group>{}), ...); }
    (std::make_index_sequence<(sizeof(T) / 4 + group - 1) / group>{});
}
template <class T> constexpr std::size_t words_of_group(std::size_t first) {
    return std::min(sizeof(T) / 4 - first, group);
}
// Bytes: only the masks.
template <class T> inline constexpr std::size_t min_packed_size = (sizeof(T) / 4 + 7) / 8;

// Fails to compile if T has padding bytes, whose values would be indeterminate.
template <class T> constexpr bool has_no_gaps() {
    unsigned sum = 0;
    for (const unsigned char byte : bit_cast<std::array<unsigned char, sizeof(T)>>(T{})) sum += byte;
    return sum < sizeof(T) * 256;
}

} // namespace archive_detail

class ArchiveWriter {
  public:
    static constexpr bool reading = false;
    explicit ArchiveWriter(std::vector<std::byte>& out) : out_(out) {}

    template <class T> void operator()(const std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T> && archive_detail::has_no_gaps<T>());
        if constexpr (archive_detail::is_packed<T>) {
            write(v, element_of(v), [&](std::size_t i) -> const T* { return i > 0 ? &v[i - 1] : nullptr; });
        } else {
            const std::uint64_t size = v.size();
            raw(&size, sizeof size);
            raw(v.data(), v.size() * sizeof(T));
        }
    }
    // Writes elements without the parts that nothing reads. `used(i, room)` returns element i without them: the element
    // itself, or a copy in `room`.
    template <class T, class F> void live_part(const std::vector<T>& v, const F& used) {
        static_assert(std::is_trivially_copyable_v<T> && archive_detail::is_packed<T>);
        T rooms[2];
        const T *before = nullptr, *now = nullptr;
        write(
            v,
            [&](std::size_t i) -> const T& {
                before = now;
                return *(now = &used(i, rooms[i % 2]));
            },
            [&](std::size_t) { return before; });
    }
    // Writes elements relative to a prediction. `foretell(i)`: the likely value of element i, given what has been
    // written before this vector.
    template <class T, class F> void predicted(const std::vector<T>& v, const F& foretell) {
        static_assert(std::is_trivially_copyable_v<T> && archive_detail::is_packed<T>);
        static_assert(archive_detail::has_no_gaps<T>());
        T expected;
        write(v, element_of(v), [&](std::size_t i) -> const T* {
            expected = foretell(i);
            return &expected;
        });
    }
    void operator()(const std::string& s) {
        const std::uint64_t size = s.size();
        raw(&size, sizeof size);
        raw(s.data(), s.size());
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(const T& value) {
        static_assert(requires { T::length(); } || archive_detail::has_no_gaps<T>()); // the former: a vector of GLM
        raw(&value, sizeof value);
    }

    std::size_t size() const noexcept { return out_.size(); }

  private:
    template <class T> static auto element_of(const std::vector<T>& v) {
        return [&v](std::size_t i) -> const T& { return v[i]; };
    }
    template <class T, class Element, class Expected>
    void write(const std::vector<T>& v, Element&& element, Expected&& expected) {
        const std::uint64_t count = v.size();
        raw(&count, sizeof count);
        const std::size_t at = out_.size();
        out_.resize(at + v.size() * archive_detail::max_packed_size<T>);
        std::byte* to = out_.data() + at;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const T& now = element(i);
            to = pack(now, expected(i), to);
        }
        out_.resize(std::size_t(to - out_.data()));
    }
    // `expected`: null for zeros.
    template <class T> static std::byte* pack(const T& value, const T* expected, std::byte* to) {
        archive_detail::Words<T> now, before{};
        std::memcpy(now.data(), static_cast<const void*>(&value), sizeof value);
        if (expected) std::memcpy(before.data(), static_cast<const void*>(expected), sizeof value);
        for (std::size_t first = 0; first < now.size(); first += archive_detail::group) {
            const std::size_t count = std::min(now.size() - first, archive_detail::group);
            std::byte* const place = to;
            to += archive_detail::mask_size(count);
            std::uint32_t mask = 0;
            for (std::size_t k = 0; k < count; ++k) {
                const std::uint32_t differs = now[first + k] != before[first + k];
                mask |= differs << k;
                std::memcpy(to, &now[first + k], 4); // overwritten by the next word if this one does not differ
                to += 4 * differs;
            }
            std::memcpy(place, &mask, archive_detail::mask_size(count));
        }
        return to;
    }
    void raw(const void* data, std::size_t size) {
        if (size == 0) return;
        const std::size_t at = out_.size();
        out_.resize(at + size);
        std::memcpy(out_.data() + at, data, size);
    }
    std::vector<std::byte>& out_;
};

// Reads an archive from front to back. Throws Error(invalid_file) rather than read past the end.
class ArchiveReader {
  public:
    static constexpr bool reading = true;
    ArchiveReader(const std::byte* data, std::size_t size) : data_(data), left_(size) {}

    // Throws Error(invalid_file) if any bytes are left.
    void end() const {
        if (left_ > 0) throw_short();
    }
    template <class T> void operator()(std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        if constexpr (archive_detail::is_packed<T>) {
            v.resize(count(archive_detail::min_packed_size<T>));
            for (std::size_t i = 0; i < v.size(); ++i) unpack(v[i], i > 0 ? &v[i - 1] : nullptr);
        } else {
            v.resize(count(sizeof(T)));
            raw(v.data(), v.size() * sizeof(T));
        }
    }
    template <class T, class F> void live_part(std::vector<T>& v, const F&) { (*this)(v); }
    template <class T, class F> void predicted(std::vector<T>& v, const F& foretell) {
        static_assert(std::is_trivially_copyable_v<T> && archive_detail::is_packed<T>);
        v.resize(count(archive_detail::min_packed_size<T>));
        for (std::size_t i = 0; i < v.size(); ++i) {
            const T expected = foretell(i);
            unpack(v[i], &expected);
        }
    }
    void operator()(std::string& s) {
        s.resize(count(1));
        raw(s.data(), s.size());
    }
    void operator()(bool& value) { // not every byte is a valid bool
        std::uint8_t byte = 0;
        raw(&byte, sizeof byte);
        value = byte != 0;
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(T& value) { raw(&value, sizeof value); }

  private:
    // Reads the number of elements that take at least `element` bytes each.
    std::size_t count(std::size_t element) {
        std::uint64_t n = 0;
        raw(&n, sizeof n);
        if (n > left_ / element) throw_short();
        return std::size_t(n);
    }
    // Reads the mask of the words that are stored for the next group of `count` words.
    template <std::size_t count> std::uint32_t mask() {
        std::uint32_t mask = 0;
        raw(&mask, archive_detail::mask_size(count));
        if (count < 32 && (mask >> (count % 32)) != 0) throw_short();
        if (left_ < 4 * count && left_ < 4 * std::size_t(std::popcount(mask))) throw_short();
        return mask;
    }
    template <class T> void unpack(T& value, const T* expected) {
        auto* const words = reinterpret_cast<std::byte*>(&value);
        if (expected)
            std::memcpy(words, static_cast<const void*>(expected), sizeof value);
        else
            std::memset(words, 0, sizeof value);
        archive_detail::for_groups<T>([&](auto first) {
            std::uint32_t differ = mask<archive_detail::words_of_group<T>(first)>();
            const std::byte* from = data_;
            for (; differ != 0; differ &= differ - 1, from += 4)
                std::memcpy(words + 4 * (first + std::size_t(std::countr_zero(differ))), from, 4);
            left_ -= std::size_t(from - data_);
            data_ = from;
        });
    }
    void raw(void* out, std::size_t size) {
        if (size > left_) throw_short();
        if (size > 0) std::memcpy(out, data_, size);
        data_ += size;
        left_ -= size;
    }
    [[noreturn]] static void throw_short() {
        throw Error(ErrorCode::invalid_file, "Snapshot", "", "is cut off or damaged");
    }
    const std::byte* data_;
    std::size_t left_;
};

} // namespace cairn
