// A world of random boxes for tests of the broad phase, with a brute-force list of the pairs that must be found.
#pragma once

#include "collision/broad_phase.h"
#include "kernels/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace cairn {

using math::DVec3;
using math::Vec3;
using Mobility = BroadPhase::Mobility;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

inline Pair ordered(std::uint32_t a, std::uint32_t b) { return a < b ? Pair{a, b} : Pair{b, a}; }

// Generates the same numbers on every machine.
struct Random {
    std::uint64_t state;
    std::uint32_t next() {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        return std::uint32_t(state >> 33);
    }
    double between(double low, double high) { return low + (high - low) * (next() * 0x1p-31); }
    std::uint32_t below(std::uint32_t count) { return next() % count; }
};

// Checks the reported pairs against the known ones, and logs them.
struct Recorder final : PairSink {
    std::map<Pair, std::uint32_t> live;
    std::set<Pair> lost_now;        // pairs that were lost in this update
    std::vector<std::uint32_t> log; // groups of four numbers: 1 (found) or 2 (lost), a, b, contact
    std::uint32_t next_contact = 0;
    bool lost_after_found = false, in_found = false;
    bool refuse_some = false, refilters = false;

    bool pair_found(std::uint32_t a, std::uint32_t b, std::uint32_t& contact) override {
        in_found = true;
        log.insert(log.end(), {1u, a, b, next_contact});
        EXPECT_TRUE(refilters || !lost_now.count(ordered(a, b))) << "lost and found in one update: " << a << " " << b;
        if (refuse_some && (a + b) % 7 == 0) return false;
        contact = next_contact++;
        EXPECT_TRUE(live.emplace(ordered(a, b), contact).second) << "new twice: " << a << " " << b;
        return true;
    }
    void pair_lost(std::uint32_t a, std::uint32_t b, std::uint32_t contact) override {
        lost_after_found |= in_found;
        log.insert(log.end(), {2u, a, b, contact});
        const auto at = live.find(ordered(a, b));
        ASSERT_TRUE(at != live.end()) << "ended unknown: " << a << " " << b;
        EXPECT_EQ(at->second, contact);
        lost_now.insert(at->first);
        live.erase(at);
    }
};

struct CountingSink final : PairSink {
    std::uint32_t found = 0, lost = 0;
    bool pair_found(std::uint32_t, std::uint32_t, std::uint32_t& contact) override {
        contact = found++;
        return true;
    }
    void pair_lost(std::uint32_t, std::uint32_t, std::uint32_t) override { ++lost; }
};

inline bool overlap(const DBounds& a, const DBounds& b, double slack) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.lo[axis] > b.hi[axis] + slack || b.lo[axis] > a.hi[axis] + slack) return false;
    return true;
}

// A world of boxes with a broad phase and a plain list of its expected contents.
struct Scene {
    enum class Kind { none, fixed, plane, awake, asleep };
    struct Shape {
        Kind kind = Kind::none;
        bool kinematic = false, trigger = false;
        DVec3 center, half;
        Vec3 velocity; // m per step
        std::uint32_t island = 0;
        DVec3 point, normal;
        bool is_sheet = false;
    };

    Random random;
    BroadPhase broad;
    Recorder sink;
    ThreadPool* thread_pool = nullptr;
    bool moves_together = false; // whether to move shapes in parallel, on all threads of the pool
    std::vector<Shape> shapes;
    DVec3 offset;
    double extent, slack = 1e-3;
    std::vector<std::uint32_t> pending_free, free_indices;

    explicit Scene(std::uint64_t seed, double extent, DVec3 offset = {}, const char* isa = nullptr)
        : random{seed}, broad(isa ? kernels_named(isa)->broad : kernels().broad), offset(offset), extent(extent) {}

    static DBounds tight(const Shape& s) { return {s.center - s.half, s.center + s.half}; }
    DBounds required(const Shape& s) const {
        DBounds b = tight(s);
        for (int axis = 0; axis < 3; ++axis) {
            b.lo[axis] += std::min(double(s.velocity[axis]), 0.0) - BroadPhase::required_margin;
            b.hi[axis] += std::max(double(s.velocity[axis]), 0.0) + BroadPhase::required_margin;
        }
        return b;
    }
    DVec3 random_point() {
        const double x = random.between(-extent, extent), y = random.between(-extent, extent);
        return offset + DVec3{x, y, random.between(-extent, extent)};
    }
    std::uint32_t new_index() {
        if (free_indices.empty()) {
            shapes.push_back({});
            return std::uint32_t(shapes.size() - 1);
        }
        const std::uint32_t index = free_indices.back();
        free_indices.pop_back();
        return index;
    }
    std::uint32_t add(Kind kind, double smallest, double largest, bool kinematic = false, bool trigger = false) {
        const std::uint32_t index = new_index();
        Shape& s = shapes[index];
        s = {};
        s.kind = kind;
        s.kinematic = kinematic;
        s.trigger = trigger;
        s.center = random_point();
        const double x = random.between(smallest, largest), y = random.between(smallest, largest);
        s.half = {x, y, random.between(smallest, largest)};
        broad.add(index, tight(s), kind == Kind::fixed ? Mobility::fixed : Mobility::awake, kinematic, trigger);
        return index;
    }
    std::uint32_t add_plane(DVec3 point, DVec3 normal, bool is_sheet = false, bool trigger = false) {
        const std::uint32_t index = new_index();
        shapes[index] = {};
        shapes[index].kind = Kind::plane;
        shapes[index].point = point;
        shapes[index].normal = normal;
        shapes[index].is_sheet = is_sheet;
        shapes[index].trigger = trigger;
        broad.add_plane(index, point, math::to_float(normal), is_sheet, trigger);
        return index;
    }
    void remove(std::uint32_t index) {
        broad.remove(index);
        shapes[index].kind = Kind::none;
        pending_free.push_back(index);
    }
    // Moves a share of the awake shapes, sometimes very fast, and keeps them within the bounds of the scene.
    void move(double share, double speed) {
        std::vector<NewBounds> moved;
        for (std::uint32_t i = 0; i < shapes.size(); ++i) {
            Shape& s = shapes[i];
            if (s.kind != Kind::awake) continue;
            if (random.between(0, 1) < share) {
                const double factor = random.below(50) == 0 ? 20 : 1;
                const DVec3 d = {random.between(-speed, speed), random.between(-speed, speed),
                                 random.between(-speed, speed)};
                s.velocity = math::to_float(factor * d);
            } else {
                s.velocity = {};
            }
            s.center += math::to_double(s.velocity);
            for (int axis = 0; axis < 3; ++axis) {
                if (std::fabs(s.center[axis] - offset[axis]) > extent) s.center[axis] = offset[axis];
            }
            moved.push_back({i, tight(s), s.velocity});
        }
        if (moves_together)
            broad.set_bounds(moved, *thread_pool);
        else
            for (const NewBounds& shape : moved) broad.set_bounds(shape.shape, shape.tight, shape.displacement);
    }
    void sleep(std::uint32_t key, const std::vector<std::uint32_t>& members) {
        for (const std::uint32_t i : members) shapes[i].kind = Kind::asleep, shapes[i].island = key;
        broad.put_to_sleep(key, members);
    }
    void wake(std::uint32_t key) {
        for (Shape& s : shapes)
            if (s.kind == Kind::asleep && s.island == key) s.kind = Kind::awake;
        broad.wake(key);
    }
    void update() {
        sink.in_found = false;
        sink.lost_now.clear();
        broad.update(sink, thread_pool);
        free_indices.insert(free_indices.end(), pending_free.begin(), pending_free.end());
        pending_free.clear();
    }

    bool pairs_up(const Shape& a, const Shape& b) const {
        if (a.kind != Kind::awake && b.kind != Kind::awake) return false;
        const auto immovable = [](const Shape& s) {
            return s.kinematic || s.kind == Kind::fixed || s.kind == Kind::plane;
        };
        return !(immovable(a) && immovable(b) && a.trigger == b.trigger);
    }
    bool meet(const Shape& a, const Shape& b, const DBounds& box_a, const DBounds& box_b, double by) const {
        const Shape* plane = a.kind == Kind::plane ? &a : b.kind == Kind::plane ? &b : nullptr;
        if (!plane) return overlap(box_a, box_b, by);
        const DBounds& box = plane == &a ? box_b : box_a;
        const DVec3& n = plane->normal;
        const DVec3 deepest = {n.x > 0 ? box.lo.x : box.hi.x, n.y > 0 ? box.lo.y : box.hi.y,
                               n.z > 0 ? box.lo.z : box.hi.z};
        const DVec3 highest = {n.x > 0 ? box.hi.x : box.lo.x, n.y > 0 ? box.hi.y : box.lo.y,
                               n.z > 0 ? box.hi.z : box.lo.z};
        return math::dot(n, deepest - plane->point) <= by &&
               (!plane->is_sheet || math::dot(n, highest - plane->point) >= -by);
    }
    void check() {
        EXPECT_FALSE(sink.lost_after_found);
        std::set<Pair> walked;
        broad.for_each_pair([&](std::uint32_t a, std::uint32_t b, std::uint32_t contact) {
            EXPECT_TRUE(walked.insert(ordered(a, b)).second) << "walked twice: " << a << " " << b;
            EXPECT_TRUE(shapes[a].kind == Kind::awake) << a;
            const auto at = sink.live.find(ordered(a, b));
            ASSERT_TRUE(at != sink.live.end()) << a << " " << b;
            EXPECT_EQ(at->second, contact);
            EXPECT_TRUE(pairs_up(shapes[a], shapes[b])) << a << " " << b;
            EXPECT_TRUE(meet(shapes[a], shapes[b], broad.fat_bounds(a), broad.fat_bounds(b), slack)) << a << " " << b;
        });
        for (const auto& [pair, contact] : sink.live) {
            const Shape &a = shapes[pair.first], &b = shapes[pair.second];
            EXPECT_TRUE(a.kind != Kind::none && b.kind != Kind::none)
                << "not lost: " << pair.first << " " << pair.second;
            EXPECT_EQ(walked.count(pair) != 0, a.kind == Kind::awake || b.kind == Kind::awake);
        }
        std::vector<DBounds> boxes(shapes.size());
        for (std::uint32_t i = 0; i < shapes.size(); ++i) {
            boxes[i] = required(shapes[i]);
            if (shapes[i].kind == Kind::none || shapes[i].kind == Kind::plane) continue;
            const DBounds& fat = broad.fat_bounds(i);
            EXPECT_TRUE(math::min(fat.lo, boxes[i].lo) == fat.lo && math::max(fat.hi, boxes[i].hi) == fat.hi) << i;
        }
        for (std::uint32_t i = 0; i < shapes.size(); ++i) {
            if (shapes[i].kind == Kind::none) continue;
            for (std::uint32_t j = i + 1; j < shapes.size(); ++j) {
                if (shapes[j].kind == Kind::none || !pairs_up(shapes[i], shapes[j])) continue;
                if (sink.refuse_some && (i + j) % 7 == 0) continue;
                const bool must = meet(shapes[i], shapes[j], boxes[i], boxes[j], 0) ||
                                  meet(shapes[i], shapes[j], broad.fat_bounds(i), broad.fat_bounds(j), -slack);
                EXPECT_TRUE(!must || walked.count({i, j})) << i << " " << j;
            }
        }
    }
};

using Kind = Scene::Kind;

inline void fill(Scene& scene) {
    for (int i = 0; i < 250; ++i) scene.add(Kind::awake, 0.1, 0.6);
    for (int i = 0; i < 60; ++i) scene.add(Kind::fixed, 0.1, 1.5);
    for (int i = 0; i < 12; ++i) scene.add(Kind::awake, 0.3, 0.8, true);
    for (int i = 0; i < 12; ++i) scene.add(i % 2 ? Kind::awake : Kind::fixed, 0.3, 1.5, true, true);
    scene.add_plane(scene.offset - DVec3{4, 0, 0}, {1, 0, 0}, false, true);
    for (int i = 0; i < 4; ++i) scene.add(Kind::awake, 5, 6);
    scene.add_plane(scene.offset - DVec3{0, 6, 0}, {0, 1, 0});
}

// Everything at once: motion, adding and removing shapes, sleep, wake, and statics that move.
inline void stir(Scene& scene, int step, std::map<std::uint32_t, std::vector<std::uint32_t>>& asleep) {
    Random& random = scene.random;
    scene.move(step % 10 < 4 ? 0.03 : 0.8, 0.1);
    const auto pick = [&](Kind kind) {
        for (int tries = 0; tries < 200; ++tries) {
            const std::uint32_t i = random.below(std::uint32_t(scene.shapes.size()));
            if (scene.shapes[i].kind == kind) return i;
        }
        return 0xffffffffu;
    };
    const auto near_box = [&](std::uint32_t i, double reach) {
        std::vector<std::uint32_t> members;
        for (std::uint32_t j = 0; j < scene.shapes.size(); ++j)
            if (scene.shapes[j].kind == Kind::awake &&
                math::length(scene.shapes[j].center - scene.shapes[i].center) < reach)
                members.push_back(j);
        return members;
    };
    const std::uint32_t key = std::uint32_t(step % 23);
    if (step % 3 == 0 && !asleep.count(key)) {
        if (const std::uint32_t i = pick(Kind::awake); i != 0xffffffffu) {
            asleep[key] = near_box(i, random.between(0.5, 4));
            scene.sleep(key, asleep[key]);
        }
    }
    if (step % 5 == 1 && !asleep.empty()) {
        auto at = asleep.begin();
        std::advance(at, random.below(std::uint32_t(asleep.size())));
        scene.wake(at->first);
        asleep.erase(at);
    }
    for (const Kind kind : {Kind::awake, Kind::fixed, Kind::asleep}) {
        if (random.below(4) != 0) continue;
        if (const std::uint32_t i = pick(kind); i != 0xffffffffu) scene.remove(i);
    }
    if (random.below(3) == 0) scene.add(random.below(2) ? Kind::awake : Kind::fixed, 0.1, 0.6);
    if (random.below(3) == 0)
        if (const std::uint32_t i = pick(Kind::fixed); i != 0xffffffffu) {
            scene.shapes[i].center = scene.random_point();
            scene.broad.set_bounds(i, Scene::tight(scene.shapes[i]));
        }
    if (step == 40) scene.add_plane(scene.offset - DVec3{4, 0, 0}, {0.6, 0.8, 0});
    if (step == 55) scene.add_plane(scene.offset + DVec3{1, 0, 0}, {0, 0.6, -0.8}, true);
    if (step == 70)
        if (const std::uint32_t i = pick(Kind::plane); i != 0xffffffffu) scene.remove(i);
}

} // namespace cairn
