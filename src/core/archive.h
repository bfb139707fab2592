// Writing state to bytes and reading it back, with one `serialize(archive)` per class for both directions.
#pragma once

#include <cairn/error.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace cairn {

class ArchiveWriter {
  public:
    static constexpr bool reading = false;
    explicit ArchiveWriter(std::vector<std::byte>& out) : out_(out) {}

    template <class T> void operator()(const std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::uint64_t size = v.size();
        raw(&size, sizeof size);
        raw(v.data(), v.size() * sizeof(T));
    }
    void operator()(const std::string& s) {
        const std::uint64_t size = s.size();
        raw(&size, sizeof size);
        raw(s.data(), s.size());
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(const T& value) { raw(&value, sizeof value); }

  private:
    void raw(const void* data, std::size_t size) {
        if (size == 0) return;
        const std::size_t at = out_.size();
        out_.resize(at + size);
        std::memcpy(out_.data() + at, data, size);
    }
    std::vector<std::byte>& out_;
};

// Throws Error(invalid_file) rather than read past the end.
class ArchiveReader {
  public:
    static constexpr bool reading = true;
    ArchiveReader(const std::byte* data, std::size_t size) : data_(data), left_(size) {}

    template <class T> void operator()(std::vector<T>& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        v.resize(count(sizeof(T)));
        raw(v.data(), v.size() * sizeof(T));
    }
    void operator()(std::string& s) {
        s.resize(count(1));
        raw(s.data(), s.size());
    }
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(T& value) { raw(&value, sizeof value); }

    std::size_t bytes_left() const noexcept { return left_; }

  private:
    std::size_t count(std::size_t element) {
        std::uint64_t n = 0;
        raw(&n, sizeof n);
        if (n > left_ / element) throw_short();
        return std::size_t(n);
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
