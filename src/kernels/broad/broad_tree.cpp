// Broad-phase kernels on one tree: box and ray tests, refit, listing and marking of leaves.
#include "kernels/broad/broad_wide.h"

namespace cairn::CAIRN_ISA {

namespace {

constexpr float e = empty_bound;
constexpr Node8 nothing = {
    {{e, e, e, e, e, e, e, e}, {e, e, e, e, e, e, e, e}, {e, e, e, e, e, e, e, e}},
    {{-e, -e, -e, -e, -e, -e, -e, -e}, {-e, -e, -e, -e, -e, -e, -e, -e}, {-e, -e, -e, -e, -e, -e, -e, -e}}};

int hit_box(const Node8& node, const TreeBox& box) { return hits(node, splat(box)); }

// The slab test of Kay and Kajiya. The exit distance is increased by the rounding errors of entry and exit (Ize,
// "Robust BVH ray traversal", 2013), so that no box is missed.
int hit_ray(const Node8& node, const TreeRay& ray, float max_distance, float* entry) {
    const auto sides = reinterpret_cast<const float*>(&node);
    const auto distances = [&](const std::uint32_t* side, const float* place, int axis) {
        return (splat(place[axis]) - load(sides + side[axis])) * splat(ray.rate[axis]);
    };
    f32x8 near = distances(ray.entered, ray.entered_place, 0), far = distances(ray.left, ray.left_place, 0);
    for (int axis = 1; axis < 3; ++axis) {
        near = max(near, distances(ray.entered, ray.entered_place, axis));
        far = min(far, distances(ray.left, ray.left_place, axis));
    }
    far = min(splat(max_distance), far * splat(1.0000005f));
    store(entry, near);
    return 255 ^ bits((near > far) | (far < zero()));
}

// Squared distances are reduced by their rounding errors, so that no box is missed.
int hit_near(const Node8& node, const TreePoint& point, float max_square, float* square) {
    const f32x8 slack = splat(point.slack);
    f32x8 sum = zero();
    for (int axis = 0; axis < 3; ++axis) {
        const f32x8 p = splat(point.position[axis]);
        const f32x8 off = max(max(load(node.lo[axis]) - p, p - load(node.hi[axis])) - slack, zero());
        sum = sum + off * off;
    }
    sum = sum * splat(0.9999990f);
    store(square, sum);
    return 255 ^ bits(sum > splat(max_square));
}

// The eight lanes of each child are transposed into columns, so that the bounds of eight children are computed at once.
template <bool Lower> CAIRN_INLINE f32x8 bounds_of_rows(const float* const* row) {
    f32x8 c[8];
    const float* second[8];
    for (int k = 0; k < 8; ++k) second[k] = row[k] + 4;
    gather4(row, c[0], c[1], c[2], c[3]);
    gather4(second, c[4], c[5], c[6], c[7]);
    for (int stride = 4; stride > 0; stride /= 2)
        for (int k = 0; k < stride; ++k) c[k] = Lower ? min(c[k], c[k + stride]) : max(c[k], c[k + stride]);
    return c[0];
}

void refit(const Node8* children, std::uint32_t child_count, Node8* parents) {
    for (std::uint32_t first = 0; first < child_count; first += 8) {
        const Node8* child[8];
        for (std::uint32_t k = 0; k < 8; ++k) child[k] = first + k < child_count ? children + first + k : &nothing;
        Node8& parent = parents[first / 8];
        for (int axis = 0; axis < 3; ++axis) {
            const float *low[8], *high[8];
            for (int k = 0; k < 8; ++k) low[k] = child[k]->lo[axis], high[k] = child[k]->hi[axis];
            store(parent.lo[axis], bounds_of_rows<true>(low));
            store(parent.hi[axis], bounds_of_rows<false>(high));
        }
    }
}

// Visits, in ascending order, the leaves for which `lanes(node, level)` sets the bit in every ancestor.
template <class Lanes, class Visit>
CAIRN_INLINE void walk_leaves(const TreeView& tree, const Lanes& lanes, const Visit& visit) {
    if (tree.level_count < 2) return;
    std::uint32_t node[max_tree_levels];
    unsigned mask[max_tree_levels];
    std::uint32_t level = tree.level_count - 1;
    node[level] = 0;
    mask[level] = lanes(0u, level);
    for (;;) {
        if (mask[level] == 0) {
            if (++level == tree.level_count) return;
            continue;
        }
        const std::uint32_t child = node[level] * 8 + std::uint32_t(__builtin_ctz(mask[level]));
        mask[level] &= mask[level] - 1;
        if (level == 1) {
            visit(child);
            continue;
        }
        --level;
        node[level] = child;
        mask[level] = lanes(child, level);
    }
}

std::uint32_t list_leaves(const TreeView& tree, const TreeBox& box, std::uint32_t first_leaf, const LeafList& out) {
    const WideBox wide = splat(box);
    std::uint32_t count = 0;
    const auto lanes = [&](std::uint32_t node, std::uint32_t level) {
        const std::uint32_t first = first_leaf >> (3 * (level - 1)); // the lane that holds first_leaf
        const unsigned kept = first <= node * 8 ? 255u : first - node * 8 > 7 ? 0u : 255u << (first - node * 8);
        return unsigned(hits(tree.levels[level][node], wide)) & kept;
    };
    walk_leaves(tree, lanes, [&](std::uint32_t leaf) {
        const Node8& parent = tree.levels[1][leaf / 8];
        out.leaf[count] = leaf;
        for (int axis = 0; axis < 3; ++axis) {
            out.bounds[axis][count] = parent.lo[axis][leaf % 8];
            out.bounds[3 + axis][count] = parent.hi[axis][leaf % 8];
        }
        ++count;
    });
    for (std::uint32_t k = count; k % 8 != 0; ++k)
        for (int axis = 0; axis < 3; ++axis) out.bounds[axis][k] = empty_bound, out.bounds[3 + axis][k] = -empty_bound;
    return count;
}

void mark_changed(const TreeView& tree, const TreeBox& before, const TreeBox& after, std::uint32_t last_leaf,
                  std::uint8_t* flags) {
    const WideBox wide_before = splat(before), wide_after = splat(after);
    const auto lanes = [&](std::uint32_t node, std::uint32_t level) {
        const std::uint32_t last = last_leaf >> (3 * (level - 1));
        if (last < node * 8) return 0u;
        const unsigned kept = last - node * 8 >= 7 ? 255u : (2u << (last - node * 8)) - 1;
        const Node8& bounds = tree.levels[level][node];
        return unsigned(hits(bounds, wide_before) | hits(bounds, wide_after)) & kept;
    };
    walk_leaves(tree, lanes, [&](std::uint32_t leaf) {
        const Node8& items = tree.levels[0][leaf];
        if (hits(items, wide_before) != hits(items, wide_after)) flags[leaf] = 1;
    });
}

} // namespace

BroadKernels broad_kernels() {
    return {hit_box, hit_ray, hit_near, refit, list_leaves, find_rows, list_met, find_others, mark_changed};
}

} // namespace cairn::CAIRN_ISA
