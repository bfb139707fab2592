// A 64-bit hash of a sequence of words: multiply and rotate, the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace cairn {

class Hash64 {
  public:
    void add(std::uint64_t word) {
        state_ ^= word * 0x9e3779b97f4a7c15ull;
        state_ = ((state_ << 27) | (state_ >> 37)) * 0xff51afd7ed558ccdull + 0x52dce729ull;
    }
    void add_bytes(const void* data, std::size_t size) {
        const auto* p = static_cast<const unsigned char*>(data);
        for (; size >= 8; p += 8, size -= 8) {
            std::uint64_t word;
            std::memcpy(&word, p, 8);
            add(word);
        }
        std::uint64_t word = size;
        for (std::size_t i = 0; i < size; ++i) word = (word << 8) | p[i];
        add(word);
    }
    std::uint64_t value() const {
        std::uint64_t x = state_;
        x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdull;
        x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ull;
        return x ^ (x >> 33);
    }

  private:
    std::uint64_t state_ = 0x243f6a8885a308d3ull;
};

} // namespace cairn
