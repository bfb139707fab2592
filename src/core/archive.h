// Writing state to bytes and reading it back, with one `serialize(archive)` per class for both directions. Elements of
// vectors are packed: of each only the 32-bit words that are others than foretold, by default those of the element
// before. That is exact whatever is foretold, as long as writing and reading foretell the same.
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

// Words come in groups with a mask each of those that differ, a bit for each word.
inline constexpr std::size_t group = 32;
constexpr std::size_t mask_size(std::size_t words) { return (words + 7) / 8; }
template <class T> inline constexpr std::size_t max_packed_size = sizeof(T) + 4 * ((sizeof(T) / 4 + group - 1) / group);

// Calls `f(first)` for the first word of each group, a constant: so are then the sizes of masks.
template <class T, class F> void for_groups(F&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (f(std::integral_constant<std::size_t, I * group>{}), ...); }
    (std::make_index_sequence<(sizeof(T) / 4 + group - 1) / group>{});
}
template <class T> constexpr std::size_t words_of_group(std::size_t first) {
    return std::min(sizeof(T) / 4 - first, group);
}

// Fails to compile, as no constant, where T has bytes that belong to no member: what they hold is left to chance.
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
            write(v, [&](std::size_t i) -> const T* { return i > 0 ? &v[i - 1] : nullptr; });
        } else {
            const std::uint64_t size = v.size();
            raw(&size, sizeof size);
            raw(v.data(), v.size() * sizeof(T));
        }
    }
    // `foretell(i)`: what element i will likely be, from what has been written before this vector.
    template <class T, class F> void foretold(const std::vector<T>& v, const F& foretell) {
        static_assert(std::is_trivially_copyable_v<T> && archive_detail::is_packed<T>);
        static_assert(archive_detail::has_no_gaps<T>());
        T expected;
        write(v, [&](std::size_t i) -> const T* {
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
        static_assert(requires { T::length(); } || archive_detail::has_no_gaps<T>()); // the former: a vector of GLM's
        raw(&value, sizeof value);
    }

    std::size_t size() const noexcept { return out_.size(); }

  private:
    template <class T, class Expected> void write(const std::vector<T>& v, Expected&& expected) {
        const std::uint64_t count = v.size();
        raw(&count, sizeof count);
        const std::size_t at = out_.size();
        out_.resize(at + v.size() * archive_detail::max_packed_size<T>);
        std::byte* to = out_.data() + at;
        for (std::size_t i = 0; i < v.size(); ++i) to = pack(v[i], expected(i), to);
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
                std::memcpy(to, &now[first + k], 4); // kept if the next one goes behind it
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

// Bytes of an archive, from front to back. Throws Error(invalid_file) rather than read past the end.
class ArchiveBytes {
  public:
    static constexpr bool reading = true;
    std::size_t bytes_left() const noexcept { return left_; }

  protected:
    ArchiveBytes(const std::byte* data, std::size_t size) : data_(data), left_(size) {}

    // Of elements that take so many bytes at least.
    std::size_t count(std::size_t element) {
        std::uint64_t n = 0;
        raw(&n, sizeof n);
        if (n > left_ / element) throw_short();
        return std::size_t(n);
    }
    // Of the next group of `count` words: which of them are there.
    template <std::size_t count> std::uint32_t mask() {
        std::uint32_t mask = 0;
        raw(&mask, archive_detail::mask_size(count));
        if (count < 32 && (mask >> (count % 32)) != 0) throw_short();
        if (left_ < 4 * count && left_ < 4 * std::size_t(std::popcount(mask))) throw_short();
        return mask;
    }
    const std::byte* next() const { return data_; }
    void pass(std::size_t size) {
        if (size > left_) throw_short();
        data_ += size;
        left_ -= size;
    }
    void raw(void* out, std::size_t size) {
        if (size > left_) throw_short();
        if (size > 0) std::memcpy(out, data_, size);
        data_ += size;
        left_ -= size;
    }

  private:
    [[noreturn]] static void throw_short() {
        throw Error(ErrorCode::invalid_file, "Snapshot", "", "is cut off or damaged");
    }
    const std::byte* data_;
    std::size_t left_;
};

class ArchiveReader : public ArchiveBytes {
  public:
    ArchiveReader(const std::byte* data, std::size_t size) : ArchiveBytes(data, size) {}

    template <class T> void operator()(std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        if constexpr (archive_detail::is_packed<T>) {
            v.resize(count(1));
            for (std::size_t i = 0; i < v.size(); ++i) unpack(v[i], i > 0 ? &v[i - 1] : nullptr);
        } else {
            v.resize(count(sizeof(T)));
            raw(v.data(), v.size() * sizeof(T));
        }
    }
    template <class T, class F> void foretold(std::vector<T>& v, const F& foretell) {
        static_assert(std::is_trivially_copyable_v<T> && archive_detail::is_packed<T>);
        v.resize(count(1));
        for (std::size_t i = 0; i < v.size(); ++i) {
            const T expected = foretell(i);
            unpack(v[i], &expected);
        }
    }
    void operator()(std::string& s) {
        s.resize(count(1));
        raw(s.data(), s.size());
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(T& value) { raw(&value, sizeof value); }

  private:
    template <class T> void unpack(T& value, const T* expected) {
        archive_detail::Words<T> words{};
        if (expected) std::memcpy(words.data(), static_cast<const void*>(expected), sizeof value);
        archive_detail::for_groups<T>([&](auto first) {
            std::uint32_t differ = mask<archive_detail::words_of_group<T>(first)>();
            const std::byte* from = next();
            for (; differ != 0; differ &= differ - 1, from += 4)
                std::memcpy(&words[first + std::size_t(std::countr_zero(differ))], from, 4);
            pass(std::size_t(from - next()));
        });
        std::memcpy(static_cast<void*>(&value), words.data(), sizeof value);
    }
};

// Goes through what a reader is to read, and keeps none of it: throws what the reader would throw, and makes room for
// what the vectors will hold, which stay as they are. What it has been through is then read without a throw.
class ArchiveChecker : public ArchiveBytes {
  public:
    ArchiveChecker(const std::byte* data, std::size_t size) : ArchiveBytes(data, size) {}

    // Returns how many elements there are.
    template <class T> std::size_t operator()(std::vector<T>& v) {
        const std::size_t n = count(archive_detail::is_packed<T> ? 1 : sizeof(T));
        v.reserve(n);
        if constexpr (archive_detail::is_packed<T>)
            for (std::size_t i = 0; i < n; ++i) pass_packed<T>();
        else
            pass(n * sizeof(T));
        return n;
    }
    template <class T, class F> void foretold(std::vector<T>& v, const F&) { (*this)(v); }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(const T&) { pass(sizeof(T)); }

  private:
    // As in a byte of it, times the size of a word: without an instruction for it a count of bits is a call.
    static constexpr std::array<std::uint8_t, 256> bits_of = [] {
        std::array<std::uint8_t, 256> bits{};
        for (unsigned i = 0; i < 256; ++i) bits[i] = std::uint8_t(4 * std::popcount(i));
        return bits;
    }();
    template <class T> void pass_packed() {
        archive_detail::for_groups<T>([&](auto first) {
            const std::uint32_t differ = mask<archive_detail::words_of_group<T>(first)>();
            std::size_t size = 0;
            for (std::size_t i = 0; i < archive_detail::mask_size(archive_detail::words_of_group<T>(first)); ++i)
                size += bits_of[(differ >> (8 * i)) & 255];
            pass(size);
        });
    }
};

} // namespace cairn
