// Times of impact of shapes on their paths, compared with distances at many sampled times.
#include "collision/core_sweep.h"
#include "collision/sweep_search.h"

#include "convex_test_support.h"
#include "shapes/gjk.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;
using cairn::core_depth_of;
using cairn::RigidPath;

constexpr int looks = 200;

double distance(const Convex& a, const Convex& b) {
    const auto r = cairn::gjk_distance({exact_core(a), exact_core(b)}, {}, 1e300);
    if (r.state == cairn::GjkResult::State::overlapping) return -1;
    return r.distance - exact_core(a).radius - exact_core(b).radius;
}
Convex shrunk(Convex shape, double depth) {
    cairn::shrink(shape, depth);
    return shape;
}
Convex core_of(const Solid& s, RigidPath::Pose pose, double depths) {
    const Convex whole = s.at(pose.x, pose.q);
    return shrunk(whole, std::min(depths * core_depth_of(whole.extent), whole.extent));
}
cairn::SweptShape swept(const Solid& s, const RigidPath& path) { return {s.geometry, s.data, {}, path}; }

RigidPath random_path(Random& random, DVec3 start, double way, double turn) {
    const DQuat q = random.rotation();
    const DVec3 end = start + random.uniform(0, way) * random.direction();
    return RigidPath::between(start, q, end, about(random.direction(), random.uniform(0, turn)) * q);
}

TEST(CoreSweep, CoresAreApartUpToTheirMeeting) {
    Random random(1);
    int met = 0, missed = 0;
    for (int k = 0; k < 4000; ++k) {
        const double way = random.below(2) ? 3 : 0.1, turn = random.below(2) ? 1.5 : 0.1;
        const Solid a = any_solid(random, 1), b = any_solid(random, random.below(3) ? 1 : 0.1);
        const RigidPath path_a = random_path(random, {}, way, turn),
                        path_b = random_path(random, random.uniform(0.5, 2.5) * random.direction(), way, turn);
        const auto apart_at = [&](double t) {
            return distance(core_of(a, path_a.at(t), 1), core_of(b, path_b.at(t), 1));
        };
        const double radii = double(a.geometry.bounding_radius) + double(b.geometry.bounding_radius);
        const double moved = length(path_a.translation) + length(path_b.translation) +
                             radii * (length(path_a.turn) + length(path_b.turn));
        const double free = cairn::half_width_of(a.geometry, a.data, b.geometry, b.data); // shorter paths are not swept
        if (!(apart_at(0) > 1e-4) || !(moved > 4 * free)) continue;
        // The result must not depend on the start of the search.
        cairn::Separation known{random.below(2) ? DVec3{} : random.direction()};
        const double time = cairn::core_time_of_impact(swept(a, path_a), swept(b, path_b), false, 0, known);
        ++(time <= 1 ? met : missed);
        for (int i = 0; i <= looks; ++i) {
            const double t = double(i) / looks;
            if (t < time) {
                ASSERT_GT(apart_at(t), 0) << k << " at " << t << ", meets at " << time;
            }
        }
    }
    EXPECT_GT(met, 200);
    EXPECT_GT(missed, 500);
}

// Two shapes that are known to stay apart still do if a linear motion, from any time on, brings them nearer along the
// axis by less than the slack, and sideways by any distance.
TEST(CoreSweep, ShapesStayApartWithinTheirSlack) {
    Random random(5);
    int shifted = 0, met = 0;
    for (int k = 0; k < 20000; ++k) {
        const double way = random.below(2) ? 3 : 0.1, turn = random.below(2) ? 1.5 : 0.1;
        const Solid a = any_solid(random, 1), b = any_solid(random, random.below(3) ? 1 : 0.1);
        const RigidPath path_a = random_path(random, {}, way, turn);
        RigidPath path_b = random_path(random, random.uniform(0.5, 2.5) * random.direction(), way, turn);
        const auto search = [&](double from, cairn::Separation& known) {
            return cairn::time_of_impact(swept(a, path_a), swept(b, path_b), cairn::Held::perhaps, from, known);
        };
        cairn::Separation known;
        const double time = search(0, known);
        if (!(known.slack > 0)) continue;
        ASSERT_EQ(time, cairn::never);
        const double from = random.uniform(0, 1), share = random.below(2) ? 0.999 : random.uniform(1, 3);
        const double far = random.uniform(0, 2);
        const DVec3 sideways = far * cross(known.axis, random.direction());
        const DVec3 last = sideways - (share * known.slack) * known.axis, rate = (1 / (1 - from)) * last;
        path_b.start -= from * rate, path_b.translation += rate;
        cairn::Separation later;
        const double then = search(from, later);
        if (share > 1) {
            met += then <= 1;
            continue;
        }
        ++shifted;
        ASSERT_EQ(then, cairn::never) << k << ": slack " << known.slack << " from " << from;
    }
    EXPECT_GT(shifted, 500);
    EXPECT_GT(met, 50); // beyond the slack they may meet
}

// Touching pairs, some of them pressed into each other. Until the time of sinking the inner cores (twice as deep as
// cores) must not come nearer than they are where faces touch, or slightly nearer than at the start; if the solver has
// the contact, not nearer than where cores touch. Shapes that sink deeper and return within a part of the step may be
// missed, but then the inner cores stay apart; for a contact of the solver, the shapes stay no deeper than the solver
// may press them.
TEST(CoreSweep, WhatTouchesGoesNoDeeperUnseen) {
    Random random(2);
    int sank = 0, stayed = 0, unseen = 0, met = 0;
    for (int k = 0; k < 24000; ++k) {
        const double way = random.below(2) ? 0.1 : 0.001, turn = random.below(2) ? 0.5 : 0.02;
        const bool is_known = random.below(2) != 0;
        const Solid a = any_solid(random, 1), b = any_solid(random, random.below(3) ? 1 : 0.1);
        RigidPath path_a = random_path(random, {}, way, turn),
                  path_b = random_path(random, 4.0 * random.direction(), way, turn);
        const Convex at_a = a.at(path_a.first().x, path_a.first().q), at_b = b.at(path_b.first().x, path_b.first().q);
        const auto r = cairn::gjk_distance({exact_core(at_a), exact_core(at_b)}, {}, 1e300);
        const double half_width = cairn::half_width_of(a.geometry, a.data, b.geometry, b.data),
                     pressed = random.below(2) ? random.uniform(0, core_depth_of(half_width)) : 0;
        path_b.start = path_b.start - (distance(at_a, at_b) + pressed) * r.normal;
        const auto apart_at = [&](double t) {
            return distance(core_of(a, path_a.at(t), 2), core_of(b, path_b.at(t), 2));
        };
        const auto cores_at = [&](double t) {
            const auto core = [&](const Solid& s, RigidPath::Pose pose) {
                const Convex whole = s.at(pose.x, pose.q);
                const double pressed = cairn::sweep::known_depth_part * std::min(whole.extent, half_width);
                return is_known ? shrunk(whole, pressed) : core_of(s, pose, 1);
            };
            return distance(core(a, path_a.at(t)), core(b, path_b.at(t)));
        };
        const auto depth_of = [](const Convex& c) { return std::min(2 * core_depth_of(c.extent), c.extent); };
        const double touch = depth_of(at_a) + depth_of(at_b), before = apart_at(0);
        if (!(before > 1e-3)) continue;
        // The search begins in any direction, or along the normal of the contact.
        cairn::Separation known{is_known ? r.normal : random.below(2) ? DVec3{} : random.direction()};
        const double time = cairn::time_of_sinking(swept(a, path_a), swept(b, path_b),
                                                   is_known ? cairn::Held::by_contact : cairn::Held::perhaps, 0, known);
        ++(time <= 1 ? sank : stayed);
        const double turned = double(a.geometry.bounding_radius) * length(path_a.turn) +
                              double(b.geometry.bounding_radius) * length(path_b.turn);
        const bool moves_far =
            length(path_a.translation - path_b.translation) + turned > cairn::free_share * half_width;
        const double floor = is_known ? (before > 0.5 * touch ? 0.5 * touch : 0)
                                      : std::min(touch, before - 0.25 * std::max(touch - before, 0.0)),
                     tolerance = 3 * cairn::sinking_part * core_depth_of(half_width);
        if (!(floor > tolerance)) continue; // nothing to check: the allowed depth is already reached
        const bool is_apart = time > 1 && moves_far && cores_at(0) > 0;
        bool went_deeper = false, has_met = false;
        for (int i = 0; i <= looks; ++i) {
            const double t = double(i) / looks;
            if (!(t < time)) break;
            went_deeper |= floor - apart_at(t) > tolerance;
            has_met |= is_apart && cores_at(t) < 0;
        }
        met += has_met;
        unseen += went_deeper;
    }
    EXPECT_GT(sank, 1500);
    EXPECT_GT(stayed, 1500);
    EXPECT_LE(unseen, 24);
    EXPECT_LE(met, 1);
}

// Without the fix the core of a capsule with two radii was the capsule itself: whatever touched it was taken to have
// hit its core, 64 times in a step.
TEST(CoreSweep, CoresAreAsDeepInsideAsTheyShouldBe) {
    Random random(4);
    for (int k = 0; k < 3000; ++k) {
        const Solid s = any_solid(random, 1);
        const Convex whole = s.at({}, random.rotation());
        const double depth = random.uniform(0.001, 0.5) * whole.extent;
        const Convex core = shrunk(whole, depth);
        const DVec3 d = random.direction();
        const double inside = dot(d, support(whole, d)) - dot(d, support(core, d));
        ASSERT_GT(inside, 0.4 * depth) << k << ", kind " << int(whole.kind);
    }
}

// The center of a flat hull's bounds may be outside the hull. Without the fix the cores were there too: they hit bodies
// beside the hull, and let bodies pass through the hull.
TEST(CoreSweep, CoresOfFlatHullsAreInsideOfThem) {
    Random random(5);
    int flat = 0;
    for (int k = 0; k < 3000; ++k) {
        std::vector<cairn::math::Vec3> corners(4);
        for (auto& corner : corners) corner = cairn::math::to_float(random.uniform(0, 1) * random.direction());
        const Solid s = hull(std::make_shared<const cairn::HullData>(cairn::build_hull(corners)));
        const Convex whole = s.at({}, random.rotation());
        const double depth = random.uniform(0.001, 0.5) * whole.extent;
        const Convex core = shrunk(whole, depth);
        bool is_flat = false;
        double least = depth;
        for (int f = 0; f < face_count(whole); ++f) {
            const DVec3 n = face_normal(whole, f), face = face_point(whole, f);
            is_flat |= dot(n, middle(whole) - face) > 0;
            least = std::min(least, dot(n, face - support(core, n)));
        }
        if (!is_flat) continue;
        ++flat;
        ASSERT_GT(least, 0.9 * depth) << k;
    }
    EXPECT_GT(flat, 1000);
}

// Without the fix a body that overlapped another beyond its core, and was leaving it while rotating, was reported as
// hitting it again at every time of the step at which the search began, 64 times, and then stood still for the rest of
// the step.
TEST(CoreSweep, WhatOverlapsAndPartsIsNotMetAnew) {
    Random random(3);
    int asked = 0, met = 0;
    for (int k = 0; k < 4000; ++k) {
        const double from = random.uniform(0.05, 0.9);
        const Solid a = any_solid(random, 1), b = any_solid(random, 1);
        const DQuat q = random.rotation();
        const RigidPath still = RigidPath::between({}, q, {}, q);
        const DQuat start = random.rotation();
        const DVec3 place = 4.0 * random.direction();
        const Convex at_a = a.at({}, q), at_b = b.at(place, start);
        const auto r = cairn::gjk_distance({exact_core(at_a), exact_core(at_b)}, {}, 1e300);
        const auto depth_of = [](const Convex& c) { return core_depth_of(c.extent); };
        const double pressed = 1.3 * (depth_of(at_a) + depth_of(at_b));
        const DVec3 pushed = place - (distance(at_a, at_b) + pressed) * r.normal;
        const DVec3 leaving = pushed + random.uniform(0.5, 2) * r.normal;
        const DQuat turned = about(random.direction(), random.uniform(0, 0.3)) * start;
        const RigidPath path = RigidPath::between(pushed, start, leaving, turned, from, 1);
        if (distance(core_of(a, {{}, q}, 1), core_of(b, {pushed, start}, 1)) >= 0) continue;
        cairn::Separation known{r.normal};
        const double time = cairn::time_of_sinking(swept(a, still), swept(b, path), cairn::Held::perhaps, from, known);
        ++asked, met += time <= from;
    }
    EXPECT_GT(asked, 1000);
    EXPECT_EQ(met, 0);
}

// A ball that overlaps a box beyond its core, and leaves it over an edge, has no new impact: neither when the box is at
// rest, nor when it rotates by micrometers, as bodies resting on contacts do.
TEST(CoreSweep, WhatLeavesOverAnEdgeMeetsNothing) {
    const Solid a = ball(0.05), b = box(0.5, 0.5, 0.5);
    const DQuat still{0, 0, 0, 1};
    for (const double turn : {0.0, 5e-7, 1e-5}) {
        const double from = 0.25;
        const DVec3 place{0.08, 0.533, 0.483}, way{1.1, -0.05, 0.37};
        const RigidPath leaving = RigidPath::between(place - from * way, still, place + (1 - from) * way, still),
                        rest = RigidPath::between({}, still, {}, about({0, 0, 1}, turn) * still);
        cairn::Separation known{{0, -1, 0}};
        EXPECT_EQ(cairn::time_of_sinking(swept(a, leaving), swept(b, rest), cairn::Held::perhaps, from, known),
                  cairn::never)
            << "turns by " << turn;
    }
}

} // namespace
