// States as memory images, each stored as its difference from the next one.
#pragma once

#include <cairn/error.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace cairn {

// A memory image of all that an archive was given, one part per call: the bytes of vectors, padded with zeros to a
// multiple of 8.
struct StateImage {
    struct Part {
        std::vector<std::uint64_t> words;
        std::size_t size = 0; // bytes
    };
    std::vector<Part> parts;
};

// The difference that turns an image into the one before.
using StateDelta = std::vector<std::byte>;

// Turns an image into that of the state being archived, and writes the difference that turns it back.
class ImageWriter {
  public:
    static constexpr bool reading = false;
    // Both must outlive the writer; `room`: the memory for the delta, reused between calls.
    ImageWriter(StateImage& image, std::vector<std::byte>& room) : image_(image), room_(room) {}

    StateDelta delta() const { return {room_.begin(), room_.begin() + std::ptrdiff_t(used_)}; }

    template <class T> void operator()(const std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        write(v.data(), v.size() * sizeof(T));
    }
    // Parts that nothing reads do not change from state to state, and so cost nothing here.
    template <class T, class F> void live_part(const std::vector<T>& v, const F&) { (*this)(v); }
    // Words equal to their prediction are 0 in the image, and so the same from state to state.
    template <class T, class F> void predicted(const std::vector<T>& v, const F& foretell) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 8 == 0);
        scratch_.resize(v.size() * (sizeof(T) / 8));
        for (std::size_t i = 0; i < v.size(); ++i) {
            const T expected = foretell(i);
            exclusive_or(&scratch_[i * (sizeof(T) / 8)], v[i], expected);
        }
        write(scratch_.data(), scratch_.size() * 8);
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(const T& value) { write(&value, sizeof value); }

    template <class T> static void exclusive_or(std::uint64_t* to, const T& a, const T& b) {
        std::uint64_t in_a[sizeof(T) / 8], in_b[sizeof(T) / 8];
        std::memcpy(in_a, static_cast<const void*>(&a), sizeof a);
        std::memcpy(in_b, static_cast<const void*>(&b), sizeof b);
        for (std::size_t k = 0; k < sizeof(T) / 8; ++k) to[k] = in_a[k] ^ in_b[k];
    }

  private:
    void write(const void* data, std::size_t size);

    StateImage& image_;
    std::vector<std::byte>& room_;
    std::size_t used_ = 0, part_ = 0;
    std::vector<std::uint64_t> scratch_;
};

// Turns an image into that of the state before.
void apply_delta(StateImage& image, const StateDelta& back);

// Restores the state of an image.
class ImageReader {
  public:
    static constexpr bool reading = true;
    explicit ImageReader(const StateImage& image) : image_(image) {}

    template <class T> void operator()(std::vector<T>& v) {
        const StateImage::Part& part = next();
        v.resize(part.size / sizeof(T));
        if (part.size > 0) std::memcpy(static_cast<void*>(v.data()), part.words.data(), part.size);
    }
    template <class T, class F> void live_part(std::vector<T>& v, const F&) { (*this)(v); }
    template <class T, class F> void predicted(std::vector<T>& v, const F& foretell) {
        const StateImage::Part& part = next();
        v.resize(part.size / sizeof(T));
        for (std::size_t i = 0; i < v.size(); ++i) {
            T found;
            std::uint64_t words[sizeof(T) / 8];
            std::memcpy(static_cast<void*>(&found), &part.words[i * (sizeof(T) / 8)], sizeof found);
            ImageWriter::exclusive_or(words, found, foretell(i));
            std::memcpy(static_cast<void*>(&v[i]), words, sizeof found);
        }
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(T& value) { std::memcpy(static_cast<void*>(&value), next().words.data(), sizeof value); }

  private:
    const StateImage::Part& next() { return image_.parts[part_++]; }
    const StateImage& image_;
    std::size_t part_ = 0;
};

} // namespace cairn
