// The kd order of slots: median splits whose lower halves are 8 x 2^k items.
#include "bvh/slot_tree.h"

#include <algorithm>

namespace cairn {

namespace {

struct ByIndex {
    template <class Item> bool operator()(const Item& a, const Item& b) const { return a.index < b.index; }
};

// A strict total order: equal centers are ordered by index, so that every selection algorithm gives the same halves.
struct ByCenter {
    int axis;
    template <class Item> bool operator()(const Item& a, const Item& b) const {
        return a.center[axis] < b.center[axis] || (a.center[axis] == b.center[axis] && a.index < b.index);
    }
};

} // namespace

std::span<const std::uint32_t> KdOrder::order(std::span<const TreeBox> boxes) {
    const std::uint32_t count = std::uint32_t(boxes.size());
    items_.resize(count);
    for (std::vector<Item>* part : {&low_, &middle_, &high_}) part->resize(count + 1);
    order_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) items_[i].center[axis] = boxes[i].lo[axis] + boxes[i].hi[axis];
        items_[i].index = i;
    }
    split(items_.data(), count);
    for (std::uint32_t i = 0; i < count; ++i) order_[i] = items_[i].index;
    return order_;
}

void KdOrder::split(Item* items, std::uint32_t count) {
    if (count <= 8) {
        std::sort(items, items + count, ByIndex{});
        return;
    }
    float low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) low[axis] = high[axis] = items[0].center[axis];
    for (std::uint32_t i = 1; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], items[i].center[axis]);
            high[axis] = std::max(high[axis], items[i].center[axis]);
        }
    }
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    std::uint32_t middle = 8;
    while (middle * 2 < count) middle *= 2;
    select(items, count, middle, axis, low[axis], high[axis]);
    split(items, middle);
    split(items + middle, count - middle);
}

// Moves the `middle` smallest items by (center, index) to the front. A histogram finds the bin that contains the
// boundary, so that only this bin needs a selection.
void KdOrder::select(Item* items, std::uint32_t count, std::uint32_t middle, int axis, float low, float high) {
    const float extent = high - low;
    if (count <= 24 || !(extent > 1e-20f)) {
        std::nth_element(items, items + middle, items + count, ByCenter{axis});
        return;
    }
    constexpr int max_bins = 256;
    const int bins = count > 1024 ? max_bins : 64;
    const float scale = float(bins - 1) / extent;
    std::uint32_t histogram[max_bins + 1] = {};
    for (std::uint32_t i = 0; i < count; ++i) ++histogram[int((items[i].center[axis] - low) * scale)];
    int boundary = 0;
    std::uint32_t before = 0;
    while (before + histogram[boundary] <= middle) before += histogram[boundary++];

    // Branch-free partition: each item is written to all three lists, and kept in one.
    Item *below = low_.data(), *inside = middle_.data(), *above = high_.data();
    std::uint32_t below_count = 0, inside_count = 0, above_count = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Item item = items[i];
        const int bin = int((item.center[axis] - low) * scale);
        below[below_count] = inside[inside_count] = above[above_count] = item;
        below_count += bin < boundary;
        inside_count += bin == boundary;
        above_count += bin > boundary;
    }
    if (middle > below_count && middle - below_count < inside_count)
        std::nth_element(inside, inside + (middle - below_count), inside + inside_count, ByCenter{axis});
    std::copy(below, below + below_count, items);
    std::copy(inside, inside + inside_count, items + below_count);
    std::copy(above, above + above_count, items + below_count + inside_count);
}

std::size_t KdOrder::bytes() const {
    return (items_.capacity() + low_.capacity() + middle_.capacity() + high_.capacity()) * sizeof(Item) +
           order_.capacity() * sizeof(std::uint32_t);
}

} // namespace cairn
