// Lists that several threads write together, in the order of their input.
#pragma once

#include "core/room.h"
#include "jobs/thread_pool.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cairn {

// The part of a list that one chunk of items has written.
struct ListPart {
    std::size_t begin, end;
};

// Sets `list` to the concatenated outputs of write(begin, end, next) for chunks of the items 0..count: it writes from
// `next` on, at most room(begin, end) entries, and returns the end of its output. `parts`: working memory. thread_pool
// may be null.
template <class T, class Room, class F>
void list_in_order(ThreadPool* thread_pool, int count, int grain, std::vector<T>& list, std::vector<ListPart>& parts,
                   const Room& room, const F& write) {
    if (!thread_pool) grain = std::max(count, 1);
    parts.clear();
    std::size_t size = 0;
    for (int begin = 0; begin < count; begin += grain) {
        parts.push_back({size, 0});
        size += room(begin, std::min(begin + grain, count));
    }
    set_size_anew(list, size);
    T* const first = list.data();
    for_chunks(thread_pool, count, grain, [&](int begin, int end, int) {
        ListPart& part = parts[std::size_t(begin / grain)];
        part.end = std::size_t(write(begin, end, first + part.begin) - first);
    });
    std::size_t filled = 0;
    for (const ListPart& part : parts) {
        if (part.begin != filled) std::copy(first + part.begin, first + part.end, first + filled);
        filled += part.end - part.begin;
    }
    list.resize(filled);
}

// The same with at most one entry per item.
template <class T, class F>
void list_in_order(ThreadPool* thread_pool, int count, int grain, std::vector<T>& list, std::vector<ListPart>& parts,
                   const F& write) {
    const auto room = [](int begin, int end) { return std::size_t(end - begin); };
    list_in_order(thread_pool, count, grain, list, parts, room, write);
}

// The number of keys that are tested, and skipped, together: in most lists, most keys have no items.
inline constexpr std::size_t keys_at_once = 16;
inline bool are_zero(const std::uint32_t* counts) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < keys_at_once; ++i) bits |= counts[i];
    return bits == 0;
}

// A stable counting sort: calls put(k, place) for each of the items 0..count, with places in the order of key_of(k) <
// `keys`, starting at `begin`. `ends`, if not null, receives the end of each key's places. `counts`: working memory.
template <class KeyOf, class Put>
void sort_in_order(ThreadPool* thread_pool, int count, int grain, std::size_t keys, std::uint32_t begin,
                   std::uint32_t* ends, std::vector<std::uint32_t>& counts, const KeyOf& key_of, const Put& put) {
    if (!thread_pool) grain = std::max(count, 1);
    counts.assign(std::size_t(std::max((count + grain - 1) / grain, 1)) * keys, 0);
    const auto counts_of = [&](int first) { return counts.data() + std::size_t(first / grain) * keys; };
    for_chunks(thread_pool, count, grain, [&](int from, int to, int) {
        std::uint32_t* const own = counts_of(from);
        for (int k = from; k < to; ++k) ++own[key_of(k)];
    });
    std::uint32_t place = begin;
    const bool is_one_chunk = counts.size() == keys;
    for (std::size_t key = 0; key < keys;) {
        if (is_one_chunk && keys - key >= keys_at_once && are_zero(counts.data() + key)) {
            if (ends) std::fill_n(ends + key, keys_at_once, place);
            key += keys_at_once;
            continue;
        }
        const std::size_t end = std::min(key + keys_at_once, keys);
        for (; key < end; ++key) {
            for (std::size_t at = key; at < counts.size(); at += keys) place += std::exchange(counts[at], place);
            if (ends) ends[key] = place;
        }
    }
    for_chunks(thread_pool, count, grain, [&](int from, int to, int) {
        std::uint32_t* const next = counts_of(from);
        for (int k = from; k < to; ++k) put(k, next[key_of(k)]++);
    });
}

} // namespace cairn
