// Capacities of vectors, which by themselves double as they grow, and never shrink.
#pragma once

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace cairn {

// A growing list reserves this fraction (1 / spare_part) more than it needs, and each element is moved twice as the
// list grows. What it never uses of large reserved memory the operating system does not provide. (With an eighth, in a
// pile that lands, steps in which the lists of contacts grew took 10 ms more, most of it for new pages.)
inline constexpr std::size_t spare_part = 2;

template <class T> void reserve_room(std::vector<T>& list, std::size_t size) {
    if (size > list.capacity()) list.reserve(size + size / spare_part);
}
template <class T> void set_size(std::vector<T>& list, std::size_t size, const T& value = {}) {
    reserve_room(list, size);
    list.resize(size, value);
}
// The same for a list that is rewritten: its elements are not moved.
template <class T> void set_size_anew(std::vector<T>& list, std::size_t size) {
    if (size > list.capacity()) list = {};
    reserve_room(list, size);
    list.resize(size);
}
template <class T> void push(std::vector<T>& list, const T& value) {
    if (list.size() == list.capacity()) {
        const T copy = value; // a copy: the value may be an element, which is moved
        reserve_room(list, list.size() + 1);
        list.push_back(copy);
    } else {
        list.push_back(value);
    }
}

// Bytes: a list with at most this capacity keeps it, so that small worlds allocate nothing, however their steps vary.
inline constexpr std::size_t kept_room = std::size_t(1) << 16;

// For a list that is rewritten in each step, and still has the elements of the last one. If these are less than a
// quarter of its capacity, as after a collapse, the excess is freed.
template <class T> void shrink_capacity(std::vector<T>& list) {
    const std::size_t room = list.capacity();
    if (room * sizeof(T) <= kept_room || list.size() >= room / 4) return;
    std::vector<T> less;
    reserve_room(less, list.size());
    less.assign(std::move_iterator(list.begin()), std::move_iterator(list.end()));
    list.swap(less);
}
// For a list that few steps need.
template <class T> void release_memory(std::vector<T>& list) {
    list.clear();
    if (list.capacity() * sizeof(T) > kept_room) list = std::vector<T>();
}

} // namespace cairn
