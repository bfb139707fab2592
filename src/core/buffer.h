// A list that begins on the stack.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

namespace cairn {

// A list of plain data; the first N are kept in place.
template <class T, std::size_t N> class Buffer {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    Buffer() {}
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    void add(const T& value) {
        if (size_ < N)
            new (storage_ + size_ * sizeof(T)) T(value);
        else {
            if (size_ == N) more_.assign(in_place(), in_place() + N);
            more_.push_back(value);
            data_ = more_.data();
        }
        ++size_;
    }
    void clear() { size_ = 0, more_.clear(), data_ = in_place(); }
    std::size_t size() const { return size_; }
    T* data() { return data_; }
    const T* data() const { return data_; }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }

  private:
    T* in_place() { return reinterpret_cast<T*>(storage_); }
    alignas(T) std::byte storage_[N * sizeof(T)];
    T* data_ = in_place();
    std::size_t size_ = 0;
    std::vector<T> more_;
};

} // namespace cairn
