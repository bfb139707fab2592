// The proxies of the broad phase: their boxes, and which tree they are in.
#include "collision/broad_phase.h"

#include "core/order.h"
#include "core/room.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace cairn {

namespace {

constexpr int leaves_per_chunk = 64, shapes_per_chunk = 64; // that a thread takes at a time

float float_from_bits(std::uint32_t bits) {
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}
std::uint32_t bits_of(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

// The greatest float that is not above x, for |x| <= largest_bound.
float float_below(double x) {
    const float nearest = float(x);
    if (double(nearest) <= x) return nearest;
    const std::uint32_t bits = bits_of(nearest);
    if (nearest > 0) return float_from_bits(bits - 1);
    return nearest < 0 ? float_from_bits(bits + 1) : -float_from_bits(1);
}

double clamped(double x) {
    constexpr double limit = largest_bound;
    return x < -limit ? -limit : x > limit ? limit : x;
}

// Bounds in order and within the largest bound; an axis whose bounds are not a valid range becomes unbounded.
DBounds sane(const DBounds& bounds) {
    DBounds out;
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_range = bounds.lo[axis] <= bounds.hi[axis];
        out.lo[axis] = is_range ? clamped(bounds.lo[axis]) : -double(largest_bound);
        out.hi[axis] = is_range ? clamped(bounds.hi[axis]) : double(largest_bound);
    }
    return out;
}

} // namespace

TreeBox BroadPhase::to_box(const DBounds& bounds) const { return relative(sane(bounds)); }

TreeBox BroadPhase::relative(const DBounds& bounds) const {
    TreeBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = float_below(clamped(bounds.lo[axis] - origin_[axis]));
        box.hi[axis] = -float_below(-clamped(bounds.hi[axis] - origin_[axis]));
    }
    return box;
}

TreeRay BroadPhase::to_ray(math::DVec3 origin, math::DVec3 direction, math::DVec3 half) const {
    constexpr std::uint32_t to_lo = offsetof(Node8, lo) / sizeof(float), to_hi = offsetof(Node8, hi) / sizeof(float);
    constexpr double rounding = 0x1p-23;
    const math::DVec3 place = origin - origin_, size = math::abs(place);
    const double slack = rounding * std::max(size.x, std::max(size.y, size.z));
    TreeRay ray;
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = clamped(1 / direction[axis]); // finite also for a component of 0
        const bool is_forward = rate > 0;
        const double reach = half[axis] * (1 + rounding) + slack, outward = is_forward ? reach : -reach;
        const std::uint32_t row = 8 * std::uint32_t(axis);
        ray.entered[axis] = row + (is_forward ? to_lo : to_hi);
        ray.left[axis] = row + (is_forward ? to_hi : to_lo);
        ray.entered_place[axis] = float(place[axis] + outward);
        ray.left_place[axis] = float(place[axis] - outward);
        ray.rate[axis] = -float(rate);
    }
    return ray;
}

// How far the tight bounds may still change before the fat box no longer contains the required bounds or is far larger
// than a new one would be, m; -1 if it is so already, or if a bound is NaN.
double BroadPhase::fat_box_clearance(const DBounds& fat, const DBounds& tight, math::Vec3 displacement) {
    const math::DVec3 extent = tight.hi - tight.lo, motion = math::to_double(displacement);
    const double size = std::max(std::max(extent.x, extent.y), extent.z);
    const double margin = std::min(fat_margin, fat_fraction * size);
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double lo = tight.lo[axis] - required_margin + std::min(motion[axis], 0.0);
        const double hi = tight.hi[axis] + required_margin + std::max(motion[axis], 0.0);
        const double room = (fat.hi[axis] - fat.lo[axis]) - (hi - lo);
        // The threshold for "too large" changes with both bounds, with twice the displacement, and with the margin,
        // which depends on the size.
        const double until_too_large = 0.2 * (6 * margin + 2 * std::fabs(motion[axis]) - room);
        for (const double way : {lo - fat.lo[axis], fat.hi[axis] - hi, until_too_large}) {
            if (!(way >= 0)) return -1;
            least = std::min(least, way);
        }
    }
    return least;
}

DBounds BroadPhase::new_fat(const DBounds& tight, math::Vec3 displacement) {
    const DBounds bounds = sane(tight);
    const math::DVec3 extent = bounds.hi - bounds.lo;
    const double size = std::max(std::max(extent.x, extent.y), extent.z);
    const double margin = required_margin + std::min(fat_margin, fat_fraction * size);
    DBounds fat;
    for (int axis = 0; axis < 3; ++axis) {
        const double motion = std::isfinite(displacement[axis]) ? double(displacement[axis]) : 0.0;
        // One step is required, one more is for the next.
        const double ahead = motion + std::min(std::max(motion, -size), size);
        fat.lo[axis] = clamped(bounds.lo[axis] - margin + std::min(ahead, 0.0));
        fat.hi[axis] = clamped(bounds.hi[axis] + margin + std::max(ahead, 0.0));
    }
    return fat;
}

// If the first shape is far from the world's origin, the trees get an origin near it from the start.
void BroadPhase::choose_first_origin(const DBounds& bounds) {
    const DBounds ordered = sane(bounds);
    math::DVec3 origin;
    bool is_far = false;
    for (int axis = 0; axis < 3; ++axis) {
        const double center = 0.5 * (ordered.lo[axis] + ordered.hi[axis]);
        origin[axis] = std::floor(center / 1024.0 + 0.5) * 1024.0;
        is_far |= std::fabs(center) > origin_distance;
    }
    origin_ = is_far ? origin : math::DVec3{};
    all_dirty_ = 1;
}

void BroadPhase::make_room(std::uint32_t shape) {
    if (shape < proxies_.size()) return;
    set_size(proxies_, shape + 1);
    set_size(fat_, shape + 1);
}

BroadPhase::Proxy& BroadPhase::make_proxy(std::uint32_t shape) {
    make_room(shape);
    ++shape_count_;
    return proxies_[shape] = Proxy{};
}

void BroadPhase::note_change(std::uint32_t shape, const TreeBox& before) {
    Proxy& proxy = proxies_[shape];
    if (proxy.moved) return; // in this period already: the box before the first change is recorded
    proxy.moved = 1;
    push(changes_, {before, shape, proxy.place, proxy.home});
}

void BroadPhase::place_awake(std::uint32_t shape) {
    const TreeBox box = relative(fat_[shape]);
    const float size = std::max({box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]});
    Proxy& proxy = proxies_[shape];
    proxy.state = State::awake;
    proxy.home = size >= large_size_;
    proxy.place = awake_[proxy.home].append(shape, box);
    proxy.moved = 0;
    note_change(shape, empty_box);
}

void BroadPhase::add(std::uint32_t shape, const DBounds& tight, Mobility mobility, bool kinematic, bool trigger) {
    if (shape_count_ == 0) choose_first_origin(tight);
    make_proxy(shape);
    fat_[shape] = new_fat(tight, {});
    Proxy& proxy = proxies_[shape];
    if (mobility == Mobility::fixed || kinematic) proxy.crowd = immovable_group_of(trigger);
    if (mobility == Mobility::awake) {
        has_kinematic_ |= std::uint32_t(kinematic);
        place_awake(shape);
        return;
    }
    const TreeBox box = relative(fat_[shape]);
    proxy.state = State::fixed;
    proxy.place = fixed_.append(shape, box);
    note_touched(box);
}

void BroadPhase::add_plane(std::uint32_t shape, math::DVec3 point, math::Vec3 normal, bool is_sheet, bool trigger) {
    if (shape_count_ == 0) choose_first_origin({point, point});
    Proxy& proxy = make_proxy(shape);
    proxy.state = State::plane;
    proxy.crowd = immovable_group_of(trigger);
    proxy.place = std::uint32_t(planes_.size());
    planes_.push_back({point, math::to_double(normal), shape, is_sheet});
    all_dirty_ = 1;
}

void BroadPhase::move_plane(std::uint32_t shape, math::DVec3 point, math::Vec3 normal) {
    Plane& plane = planes_[proxies_[shape].place];
    plane.point = point;
    plane.normal = math::to_double(normal);
    all_dirty_ = 1;
}

void BroadPhase::remove(std::uint32_t shape) {
    Proxy& proxy = proxies_[shape];
    switch (proxy.state) {
    case State::none:
    case State::removed:
        return;
    case State::fixed: {
        const TreeBox box = fixed_.box(proxy.place);
        note_touched(box);
        flag_removal(box);
        fixed_.kill(proxy.place);
        break;
    }
    case State::plane:
        planes_.erase(planes_.begin() + proxy.place);
        for (std::uint32_t i = proxy.place; i < planes_.size(); ++i) proxies_[planes_[i].shape].place = i;
        for (Island& island : islands_) island.removal = 1;
        removals_ = 1;
        all_dirty_ = 1;
        break;
    case State::awake:
        note_change(shape, awake_[proxy.home].box(proxy.place));
        awake_[proxy.home].kill(proxy.place);
        break;
    case State::sleeping:
        remove_sleeping(shape);
        break;
    }
    proxy.state = State::removed;
    removed_.push_back(shape);
    --shape_count_;
}

void BroadPhase::write_box(std::uint32_t shape) {
    const Proxy& proxy = proxies_[shape];
    const TreeBox box = relative(fat_[shape]);
    if (proxy.state == State::awake) {
        note_change(shape, awake_[proxy.home].box(proxy.place));
        awake_[proxy.home].set_box(proxy.place, box);
    } else if (proxy.state == State::fixed) {
        const TreeBox before = fixed_.box(proxy.place);
        note_touched(before);
        note_touched(box);
        flag_removal(before);
        fixed_.set_box(proxy.place, box);
        fixed_.count_unsorted();
    } else if (proxy.state == State::sleeping) {
        write_sleeping_box(shape, box);
    }
}

void BroadPhase::set_bounds(std::uint32_t shape, const DBounds& tight, math::Vec3 displacement) {
    if (room(shape, tight, displacement) < 0) renew_bounds(shape, tight, displacement);
}

void BroadPhase::renew_bounds(std::uint32_t shape, const DBounds& tight, math::Vec3 displacement) {
    fat_[shape] = new_fat(tight, displacement);
    write_box(shape);
}

void BroadPhase::set_bounds(std::span<const NewBounds> all, ThreadPool& thread_pool) {
    if (all.empty()) return;
    moved_shapes_.clear();
    new_of_shape_.resize(proxies_.size());
    for (std::uint32_t k = 0; k < all.size(); ++k) {
        moved_shapes_.push_back(std::int32_t(all[k].shape));
        new_of_shape_[all[k].shape] = k;
    }
    sort_distinct(moved_shapes_, shape_marks_);
    const auto write = [&](int begin, int end, Change* next) {
        for (int k = begin; k < end; ++k) {
            const auto shape = std::uint32_t(moved_shapes_[std::size_t(k)]);
            const NewBounds& bounds = all[new_of_shape_[shape]];
            Proxy& proxy = proxies_[shape];
            if (proxy.state != State::awake || room(shape, bounds.tight, bounds.displacement) >= 0) continue;
            SlotTree& tree = awake_[proxy.home];
            if (!proxy.moved) *next++ = {tree.box(proxy.place), shape, proxy.place, proxy.home};
            proxy.moved = 1;
            fat_[shape] = new_fat(bounds.tight, bounds.displacement);
            tree.set_leaf_box(proxy.place, relative(fat_[shape]));
        }
        return next;
    };
    list_in_order(&thread_pool, int(all.size()), shapes_per_chunk, new_changes_, parts_, write);
    changes_.insert(changes_.end(), new_changes_.begin(), new_changes_.end());
    for (SlotTree& tree : awake_) {
        tree.note_change();
        tree.refit(kernels_);
    }
    // Shapes that are not awake: they wake at the next update.
    for (const NewBounds& bounds : all)
        if (proxies_[bounds.shape].state != State::awake) set_bounds(bounds.shape, bounds.tight, bounds.displacement);
}

void BroadPhase::refilter(std::uint32_t shape) {
    Proxy& proxy = proxies_[shape];
    if (proxy.refilter || !contains(shape)) return;
    proxy.refilter = 1;
    refiltered_.push_back(shape);
    if (proxy.state == State::plane)
        all_dirty_ = 1;
    else
        note_touched(relative(fat_[shape]));
}

// Whether the box overlaps the half-space, or the plane of a sheet.
bool BroadPhase::crosses(const Plane& plane, const TreeBox& box) const {
    const math::DVec3& n = plane.normal;
    const math::DVec3 deepest = {n.x > 0 ? box.lo[0] : box.hi[0], n.y > 0 ? box.lo[1] : box.hi[1],
                                 n.z > 0 ? box.lo[2] : box.hi[2]};
    const double height = math::dot(n, plane.point - origin_);
    if (is_empty(box) || !(math::dot(n, deepest) <= height)) return false;
    if (!plane.is_sheet) return true;
    const math::DVec3 highest = {n.x > 0 ? box.hi[0] : box.lo[0], n.y > 0 ? box.hi[1] : box.lo[1],
                                 n.z > 0 ? box.hi[2] : box.lo[2]};
    return math::dot(n, highest) >= height;
}

void BroadPhase::list_contacts(std::vector<std::uint32_t>& contacts, std::vector<ListPart>& parts,
                               ThreadPool& thread_pool) const {
    const int small = int(rows_[0].leaf_count()), all = small + int(rows_[1].leaf_count());
    const auto for_leaves = [&](int begin, int end, auto&& f) {
        for (int k = begin; k < end; ++k) {
            const PairRows& rows = rows_[k < small ? 0 : 1];
            const auto leaf = std::uint32_t(k < small ? k : k - small);
            f(rows.entries(leaf), rows.leaf(leaf).total());
        }
    };
    const auto room = [&](int begin, int end) {
        std::size_t entries = 0;
        for_leaves(begin, end, [&](const PairEntry*, std::uint32_t total) { entries += total; });
        return entries;
    };
    const auto write = [&](int begin, int end, std::uint32_t* next) {
        for_leaves(begin, end, [&](const PairEntry* entries, std::uint32_t total) {
            for (std::uint32_t k = 0; k < total; ++k)
                if (entries[k].contact != filtered_contact) *next++ = entries[k].contact;
        });
        return next;
    };
    list_in_order(&thread_pool, all, leaves_per_chunk, contacts, parts, room, write);
}

BroadPhase::Counts BroadPhase::counts() const {
    Counts counts = last_;
    counts.awake = awake_[0].alive_count() + awake_[1].alive_count();
    counts.large = awake_[1].alive_count();
    counts.fixed = fixed_.alive_count();
    counts.sleeping = sleeping_count_;
    counts.islands = top_.alive_count();
    counts.planes = std::uint32_t(planes_.size());
    counts.sleeping_pairs = kept_count_;
    counts.pairs = 0;
    for (const PairRows& rows : rows_)
        for (std::uint32_t leaf = 0; leaf < rows.leaf_count(); ++leaf) counts.pairs += rows.leaf(leaf).total();
    return counts;
}

std::size_t BroadPhase::bytes() const {
    const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
    std::size_t sum = of(proxies_) + of(fat_) + of(planes_) + of(islands_) + of(free_islands_) + of(island_of_key_) +
                      of(island_nodes_) + of(island_shapes_) + of(kept_) + of(changes_) + of(touched_) + of(removed_) +
                      of(refiltered_) + of(returned_) + of(ended_) + of(found_) + of(order_) + of(merged_) +
                      of(sizes_) + of(boxes_) + of(items_) + of(flat_);
    for (int home = 0; home < 2; ++home)
        sum += awake_[home].bytes() + rows_[home].bytes() + of(dirty_[home]) + of(crowd_[home]);
    for (const Search& own : searches_) {
        sum += of(own.row_keys) + of(own.hits) + of(own.islands_hit) + of(own.met) + of(own.met_items) + of(own.others);
        for (int which = 0; which < 2; ++which) sum += of(own.list[which]) + of(own.list_bounds[which]);
    }
    for (const NewRows& rows : new_rows_) sum += of(rows.leaves) + of(rows.keys);
    return sum + fixed_.bytes() + top_.bytes() + kd_.bytes();
}

} // namespace cairn
