// How much room lists have. Left to themselves, vectors double as they grow, and keep for ever what they once had.
#pragma once

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace cairn {

// A list that grows gets so much more room than it needs, as a part of that: in the mean a twentieth is unused, where
// vectors that double leave a quarter. All that it holds is moved some eight times as it grows, in place of once.
inline constexpr std::size_t spare_part = 8;

template <class T> void reserve_room(std::vector<T>& list, std::size_t size) {
    if (size > list.capacity()) list.reserve(size + size / spare_part);
}
template <class T> void set_size(std::vector<T>& list, std::size_t size, const T& value = {}) {
    reserve_room(list, size);
    list.resize(size, value);
}
// The same of a list that is written anew: what it holds is moved nowhere.
template <class T> void set_size_anew(std::vector<T>& list, std::size_t size) {
    if (size > list.capacity()) list = {};
    reserve_room(list, size);
    list.resize(size);
}
template <class T> void push(std::vector<T>& list, const T& value) {
    if (list.size() == list.capacity()) {
        const T copy = value; // it may be one of those that move
        reserve_room(list, list.size() + 1);
        list.push_back(copy);
    } else {
        list.push_back(value);
    }
}

// Bytes: a list with no more than that keeps it, so that small worlds allocate nothing, however their steps go up and
// down.
inline constexpr std::size_t kept_room = std::size_t(1) << 16;

// Of a list that each step writes anew: what it holds is all that the last step needed. If that is less than a quarter
// of its room, as after a fall, the rest is given back.
template <class T> void give_back_room(std::vector<T>& list) {
    const std::size_t room = list.capacity();
    if (room * sizeof(T) <= kept_room || list.size() >= room / 4) return;
    std::vector<T> less;
    reserve_room(less, list.size());
    less.assign(std::move_iterator(list.begin()), std::move_iterator(list.end()));
    list.swap(less);
}
// Of a list that few steps need.
template <class T> void give_back_all(std::vector<T>& list) {
    list.clear();
    if (list.capacity() * sizeof(T) > kept_room) list = std::vector<T>();
}

} // namespace cairn
