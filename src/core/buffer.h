// A list that starts on the stack and moves to the heap when it grows.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace cairn {

// A list of trivial elements; up to N are stored in the object itself.
template <class T, std::size_t N> class Buffer {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    Buffer() {}
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    ~Buffer() {
        if (data_ != in_place()) delete[] reinterpret_cast<Place*>(data_);
    }
    void add(const T& value) {
        if (size_ < room_)
            data_[size_++] = value;
        else
            add_beyond(value);
    }
    // Appends an element without a value.
    T& add_unset() {
        if (size_ == room_) grow();
        return data_[size_++];
    }
    void clear() { size_ = 0; }
    std::size_t size() const { return size_; }
    T* data() { return data_; }
    const T* data() const { return data_; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }

  private:
    struct alignas(T) Place {
        std::byte bytes[sizeof(T)];
    };
    T* in_place() { return reinterpret_cast<T*>(storage_); }
    [[gnu::noinline]] void add_beyond(const T value) { // a copy: the argument may be an element, which is moved
        grow();
        data_[size_++] = value;
    }
    [[gnu::noinline]] void grow() {
        T* const more = reinterpret_cast<T*>(new Place[2 * room_]);
        std::memcpy(static_cast<void*>(more), data_, size_ * sizeof(T));
        if (data_ != in_place()) delete[] reinterpret_cast<Place*>(data_);
        data_ = more, room_ *= 2;
    }

    alignas(T) std::byte storage_[N * sizeof(T)];
    T* data_ = in_place();
    std::size_t size_ = 0, room_ = N;
};

} // namespace cairn
