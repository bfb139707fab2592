// Templates of BroadPhase (broad_phase.h includes this file).
#pragma once

#include "bvh/traverse.h"

#include <cmath>

namespace cairn {

template <class F> void BroadPhase::for_each_pair(F&& f) const {
    for (int home = 0; home < 2; ++home) {
        for (std::uint32_t leaf = 0; leaf < rows_[home].leaf_count(); ++leaf) {
            const LeafRows& rows = rows_[home].leaf(leaf);
            const PairEntry* entry = rows_[home].entries(leaf);
            for (std::uint32_t row = 0; row < 8; ++row)
                for (std::uint32_t k = 0; k < rows.count[row]; ++k, ++entry)
                    if (entry->contact != filtered_contact)
                        f(awake_[home].item(leaf * 8 + row), partner_shape(entry->key), entry->contact);
        }
    }
}

template <class F> void BroadPhase::for_each_sleeping_pair(std::uint32_t island_key, F&& f) const {
    if (!is_asleep(island_key)) return;
    for (std::uint32_t i = islands_[island_of_key_[island_key]].first_pair; i != none; i = kept_[i].next)
        if (kept_[i].contact != filtered_contact) f(kept_[i].shape_a, kept_[i].shape_b, kept_[i].contact);
}

template <class F> void BroadPhase::query_bounds(const DBounds& bounds, F&& visit) const {
    const TreeBox box = to_box(bounds);
    for (const SlotTree* tree : {&fixed_, &awake_[0], &awake_[1]})
        visit_box(kernels_, tree->view(), box, [&](std::uint32_t slot) { visit(tree->item(slot)); });
    visit_box(kernels_, top_.view(), box, [&](std::uint32_t top_slot) {
        const Island& island = islands_[top_.item(top_slot)];
        if (island.shape_count == 1) return visit(island_shapes_[island.shape_base]); // its box is the island's
        visit_box(kernels_, island_view(island), box,
                  [&](std::uint32_t slot) { visit(island_shapes_[island.shape_base + slot]); });
    });
    for (const Plane& plane : planes_)
        if (crosses(plane, box)) visit(plane.shape);
}

// Traverses several trees together: max = visit(shape, max) as in visit_by_distance.
template <std::size_t count, class Enter, class F>
float BroadPhase::query_trees(const SlotTree* const (&trees)[count], float max, Enter&& enter, F&& visit) const {
    return visit_by_distance(trees, max, enter, [&](std::uint32_t tree, std::uint32_t slot, float limit) {
        const std::uint32_t item = trees[tree]->item(slot);
        if (trees[tree] != &top_) return visit(item, limit);
        const Island& island = islands_[item];
        if (island.shape_count == 1) return visit(island_shapes_[island.shape_base], limit);
        const TreeView below = island_view(island);
        const TreeView* const alone[] = {&below};
        return visit_by_distance(alone, limit, enter, [&](std::uint32_t, std::uint32_t place, float least) {
            return visit(island_shapes_[island.shape_base + place], least);
        });
    });
}
// Traverses the trees one after another, for queries to which a shape costs about as much as a node. The trees with few
// shapes come first, as their hits limit the search in the others.
template <class Enter, class F> void BroadPhase::query_by_distance(float max, Enter&& enter, F&& visit) const {
    for (const SlotTree* tree : {&fixed_, &awake_[1], &awake_[0], &top_}) {
        if (tree->slot_count() == 0) continue;
        const SlotTree* const one[] = {tree};
        max = query_trees(one, max, enter, visit);
        if (max < 0.0f) return;
    }
}

// The trees measure distances in float, so their limit is a little greater than the exact one.
inline float widened(double distance) {
    return distance < double(largest_bound) ? float(distance * (1.0 + 1e-6)) : largest_bound;
}

template <class F>
void BroadPhase::query_ray(math::DVec3 origin, math::DVec3 direction_unit, double max_distance, F&& visit) const {
    const TreeRay ray = to_ray(origin, direction_unit, {});
    double max = max_distance;
    if (!(max > 0.0)) return;
    for (const Plane& plane : planes_) {
        if (math::dot(plane.normal, origin - plane.point) > 0.0 && math::dot(plane.normal, direction_unit) >= 0.0)
            continue;
        max = visit(plane.shape, max);
        if (!(max > 0.0)) return;
    }
    query_by_distance(
        widened(max),
        [&](const Node8& node, float limit, float* entry) { return kernels_.hit_ray(node, ray, limit, entry); },
        [&](std::uint32_t shape, float) {
            max = visit(shape, max);
            return max > 0.0 ? widened(max) : -1.0f;
        });
}

// Whether a moving box stays on one side of a plane, where it does not touch it, by more than rounding errors.
inline bool BroadPhase::passes(const Plane& plane, math::DVec3 center, math::DVec3 half, math::DVec3 way) {
    constexpr double rounding = 0x1p-50;
    const math::DVec3 n = math::abs(plane.normal);
    const double height = math::dot(plane.normal, center - plane.point), change = math::dot(plane.normal, way);
    const math::DVec3 sizes = math::abs(center) + math::abs(way) + math::abs(plane.point);
    const double reach = math::dot(n, half) + rounding * math::dot(n, sizes);
    if (height > reach && height + change > reach) return true;
    return plane.is_sheet && height < -reach && height + change < -reach;
}

template <class F> void BroadPhase::query_sweep(const DBounds& bounds, math::DVec3 translation, F&& visit) const {
    const double length = math::length(translation);
    const math::DVec3 direction = length > 0 ? (1 / length) * translation : math::DVec3{};
    const math::DVec3 half = 0.5 * (bounds.hi - bounds.lo);
    const TreeRay ray = to_ray(bounds.lo + half, direction, half);
    double max = 1;
    for (const Plane& plane : planes_) {
        if (passes(plane, bounds.lo + half, half, translation)) continue;
        max = visit(plane.shape, max);
        if (max < 0.0) return;
    }
    // A sweep of a shape costs more than many nodes: traversing all trees together by distance avoids sweeps beyond the
    // nearest hit.
    const SlotTree* const all[] = {&awake_[0], &awake_[1], &fixed_, &top_};
    query_trees(
        all, widened(max * length),
        [&](const Node8& node, float limit, float* entry) { return kernels_.hit_ray(node, ray, limit, entry); },
        [&](std::uint32_t shape, float) {
            max = visit(shape, max);
            return max < 0.0 ? -1.0f : widened(max * length);
        });
}

template <class F> void BroadPhase::query_near(math::DVec3 point, double max_distance, F&& visit) const {
    const math::DVec3 relative = point - origin_;
    TreePoint place;
    math::put(place.position, math::to_float(relative));
    place.slack = float(0x1p-23 * std::max({std::fabs(relative.x), std::fabs(relative.y), std::fabs(relative.z)}));
    double max = max_distance;
    for (const Plane& plane : planes_) {
        max = visit(plane.shape, max);
        if (max < 0.0) return;
    }
    query_by_distance(
        widened(max * max),
        [&](const Node8& node, float limit, float* square) { return kernels_.hit_near(node, place, limit, square); },
        [&](std::uint32_t shape, float) {
            max = visit(shape, max);
            return max < 0.0 ? -1.0f : widened(max * max);
        });
}

template <class Archive> void BroadPhase::serialize(Archive& archive) {
    archive(origin_), archive(proxies_), archive(fat_);
    for (int home = 0; home < 2; ++home) awake_[home].serialize(archive), rows_[home].serialize(archive);
    fixed_.serialize(archive), top_.serialize(archive);
    archive(planes_), archive(islands_), archive(free_islands_), archive(island_of_key_);
    archive(island_nodes_), archive(island_shapes_), archive(kept_);
    archive(first_free_kept_), archive(first_cross_pair_);
    archive(dead_island_nodes_), archive(dead_island_shapes_), archive(kept_count_);
    archive(changes_), archive(touched_), archive(removed_), archive(refiltered_), archive(returned_);
    archive(all_dirty_), archive(transfers_), archive(removals_), archive(shape_count_), archive(sleeping_count_);
    archive(steps_since_sort_), archive(moved_since_sort_), archive(large_size_), archive(has_kinematic_);
}

} // namespace cairn
