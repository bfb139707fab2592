#include "collision/convex_contact.h"

#include "convex_test_support.h"
#include "shapes/epa.h"
#include "shapes/gjk.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;
using cairn::ContactMemory;
using cairn::Manifold;

// Without cached data of a previous step.
void collide_convex(const Convex& a, const Convex& b, double margin, DVec3 guess, Manifold& out) {
    ContactMemory memory = cairn::nothing_met;
    cairn::collide_convex(a, b, margin, guess, memory, out);
}

DVec3 point_of(const Manifold& m, int i) { return {m.points[i][0], m.points[i][1], m.points[i][2]}; }
double separation_along(const Convex& a, const Convex& b, DVec3 n) { return dot(n, support(b, -n) - support(a, n)); }
// The greatest separation over all directions, by sampling and hill climbing.
double greatest_separation(const Convex& a, const Convex& b, DVec3 hint, Random& random, DVec3& best) {
    struct Try {
        double s;
        DVec3 n;
    };
    std::vector<Try> tries{{separation_along(a, b, hint), hint}};
    for (int i = 0; i < 300; ++i) {
        const DVec3 n = random.direction();
        tries.push_back({separation_along(a, b, n), n});
    }
    std::sort(tries.begin(), tries.end(), [](const Try& p, const Try& q) { return p.s > q.s; });
    Try top = tries[0];
    for (int t = 0; t < 4; ++t) {
        Try at = tries[std::size_t(t)];
        for (double step = 0.3; step > 1e-6; step *= 0.7)
            for (int i = 0; i < 12; ++i) {
                const DVec3 n = normalized(at.n + step * random.direction());
                const double s = separation_along(a, b, n);
                if (s > at.s) at = {s, n};
            }
        if (at.s > top.s) top = at;
    }
    best = top.n;
    return top.s;
}
// Conditions that hold for every manifold; returns the first violation, or an empty string.
std::string flaw(const Manifold& m, double margin) {
    if (m.count < 0 || m.count > 4) return "count " + std::to_string(m.count);
    const double l = length(normal_of(m));
    if (!(std::fabs(l - 1.0) < 2e-6) && !(m.count == 0 && l == 0.0)) return "normal of length " + std::to_string(l);
    for (int k = 0; k < 4; ++k) {
        const bool used = k < m.count;
        for (int c = 0; c < 3; ++c)
            if (used ? !std::isfinite(m.points[k][c]) : m.points[k][c] != 0.0f) return "point " + std::to_string(k);
        const bool says_apart = m.count == 0 && k == 0 && m.points[k][3] > float(margin);
        if (used ? !(m.points[k][3] <= float(margin)) : !says_apart && m.points[k][3] != 1e30f)
            return "separation " + std::to_string(m.points[k][3]);
        if (!used && m.features[k] != 0) return "feature " + std::to_string(k);
        for (int i = 0; i < k && used; ++i)
            if (m.features[i] == m.features[k]) return "two points with one feature";
    }
    return {};
}

// The distance of a point outside a shape; 0 inside.
double outside(const Convex& c, DVec3 p) {
    const Convex point = ball(1e-12).at(p);
    const auto r = cairn::gjk_distance({exact_core(point), exact_core(c)}, {}, 1e300);
    if (r.state == cairn::GjkResult::State::overlapping) return 0;
    return std::max(0.0, r.distance - exact_core(c).radius);
}
// The test may prefer faces to a direction with a smaller overlap by at most the inset of the cores, or by a small
// tolerance where the cores are exact.
double preference(const Convex& a, const Convex& b) {
    return a.is_sharp && b.is_sharp ? std::min(a.radius, b.radius) : 2e-3 * std::min(a.extent, b.extent);
}

struct Pair {
    Solid first, second;
    DVec3 offset;
    DQuat qa, qb;
    Convex a() const { return first.at({}, qa); }
    Convex b() const { return second.at(offset, qb); }
};
Pair random_pair(Random& random, double size_a = 1, double size_b = 1) {
    Pair p{any_solid(random, size_a), any_solid(random, size_b), {}, {}, {}};
    p.offset = random.uniform(0, 1.25 * (size_a + size_b)) * random.direction();
    p.qa = random.rotation();
    p.qb = random.rotation();
    return p;
}

TEST(ConvexContact, RandomPairsTouchByTheirTrueSeparation) {
    Random random(1);
    int touching = 0, said = 0;
    for (int k = 0; k < 20000; ++k) {
        const Pair p = random_pair(random);
        const Convex a = p.a(), b = p.b();
        const double margin = random.below(2) ? 0.02 : 0.3;
        Manifold m;
        collide_convex(a, b, margin, {}, m);
        ASSERT_EQ(flaw(m, margin), "") << k;
        if (m.count == 0) {
            const double s = separation_along(a, b, normal_of(m));
            EXPECT_GT(s, margin - 1e-3) << k << ": the normal shows it";
            if (m.points[0][3] == 1e30f) continue;
            EXPECT_NEAR(double(m.points[0][3]), s, 1e-5) << k;
            ++said;
            continue;
        }
        ++touching;
        const DVec3 n = normal_of(m);
        EXPECT_NEAR(deepest(m), separation_along(a, b, n), 2 * preference(a, b) + 1e-6) << k;
        for (int i = 0; i < m.count; ++i) {
            const double z = m.points[i][3], slack = z < -0.4 ? 0.18 : 0.035; // m
            EXPECT_LT(outside(a, point_of(m, i) - (0.5 * z) * n), slack) << k;
            EXPECT_LT(outside(b, point_of(m, i) + (0.5 * z) * n), slack) << k;
        }
    }
    EXPECT_GT(touching, 10000);
    EXPECT_GT(said, 5000);
}

TEST(ConvexContact, NoOtherDirectionPartsTheShapesMuchBetter) {
    Random random(2);
    double sum = 0;
    int touching = 0;
    for (int k = 0; k < 3000; ++k) {
        const Pair p = random_pair(random);
        const Convex a = p.a(), b = p.b();
        Manifold m;
        collide_convex(a, b, 0.1, {}, m);
        // Pairs without a contact must truly be separated.
        DVec3 hint = m.count == 0 ? random.direction() : normal_of(m), best;
        const double truth = greatest_separation(a, b, hint, random, best);
        if (m.count == 0) {
            EXPECT_GT(truth, 0.099) << k;
            continue;
        }
        ++touching;
        EXPECT_LT(truth, 0.1 + 0.03) << k;
        const double less = truth - separation_along(a, b, normal_of(m));
        EXPECT_LT(less, truth < -0.1 ? 0.05 : preference(a, b) + 0.002) << k << " true " << truth;
        sum += std::max(0.0, less);
    }
    EXPECT_LT(sum / touching, 1e-3);
}

TEST(ConvexContact, ExchangingTheShapesTurnsTheNormalRound) {
    Random random(3);
    for (int k = 0; k < 5000; ++k) {
        const Pair p = random_pair(random);
        const Convex a = p.a(), b = p.b();
        const Convex a2 = p.first.at(-p.offset, p.qa), b2 = p.second.at({}, p.qb);
        Manifold m, swapped;
        collide_convex(a, b, 0.05, {}, m);
        collide_convex(b2, a2, 0.05, {}, swapped);
        if ((m.count == 0) != (swapped.count == 0)) {
            EXPECT_GT(std::min(deepest(m), deepest(swapped)), 0.045) << k;
            continue;
        }
        if (m.count == 0) continue;
        const double tolerance = 2 * preference(a, b) + 1e-4 + (deepest(m) < -0.1 ? 0.02 : 0);
        EXPECT_NEAR(deepest(m), deepest(swapped), tolerance) << k;
        EXPECT_NEAR(separation_along(a, b, normal_of(m)), separation_along(a, b, -normal_of(swapped)), tolerance) << k;
    }
}

TEST(ConvexContact, ACommonMotionChangesNothing) {
    Random random(4);
    for (int k = 0; k < 5000; ++k) {
        const Pair p = random_pair(random);
        const DQuat turn = random.rotation();
        Pair moved = p;
        moved.offset = rotate(turn, p.offset);
        moved.qa = turn * p.qa;
        moved.qb = turn * p.qb;
        Manifold m, other;
        collide_convex(p.a(), p.b(), 0.05, {}, m);
        collide_convex(moved.a(), moved.b(), 0.05, {}, other);
        if (m.count == 0 || other.count == 0) {
            EXPECT_GT(std::min(deepest(m), deepest(other)), 0.0499) << k;
            continue;
        }
        const double tolerance = 2e-4 + (deepest(m) < -0.1 ? 0.02 : 0);
        EXPECT_NEAR(deepest(m), deepest(other), tolerance + preference(p.a(), p.b())) << k;
    }
}

TEST(ConvexContact, TheNormalOfTheLastStepOnlySavesTime) {
    Random random(5);
    int touching = 0;
    for (int k = 0; k < 20000; ++k) {
        Pair p = random_pair(random);
        Manifold last, cold, warm;
        collide_convex(p.a(), p.b(), 0.02, {}, last);
        // The pair one step later, or with a wrong guess of the normal.
        p.offset += 0.01 * random.direction();
        p.qa = about(random.direction(), 0.02) * p.qa;
        const DVec3 guess = random.below(4) == 0 ? random.direction() : normal_of(last);
        const Convex a = p.a(), b = p.b();
        collide_convex(a, b, 0.02, {}, cold);
        collide_convex(a, b, 0.02, guess, warm);
        ASSERT_EQ(flaw(warm, 0.02), "") << k;
        // Deeply overlapping shapes may have different reference faces; for shallow contacts the separation is the
        // same.
        const double tolerance = 2 * preference(a, b) + 1e-5;
        if (deepest(cold) > 0.02 - tolerance || deepest(warm) > 0.02 - tolerance || deepest(cold) < -0.1) continue;
        ++touching;
        EXPECT_NEAR(deepest(cold), deepest(warm), tolerance) << k << " kinds " << int(a.kind) << " " << int(b.kind);
    }
    EXPECT_GT(touching, 500);
}

TEST(ConvexContact, WhatMetInTheLastStepOnlySavesTime) {
    Random random(15);
    int touching = 0, faces = 0, edges = 0;
    for (int k = 0; k < 4000; ++k) {
        Pair p = random_pair(random);
        const DVec3 way = 0.01 * random.direction(), axis = random.direction();
        ContactMemory memory = cairn::nothing_met;
        DVec3 guess;
        for (int step = 0; step < 8; ++step) {
            const Convex a = p.a(), b = p.b();
            // Cached data of other shapes, or none.
            if (random.below(16) == 0) memory = ContactMemory(random.below(1 << 30));
            const ContactMemory last = memory;
            Manifold cold, warm;
            collide_convex(a, b, 0.02, {}, cold);
            cairn::collide_convex(a, b, 0.02, guess, memory, warm);
            ASSERT_EQ(flaw(warm, 0.02), "") << k;
            if (warm.count > 0 && memory == last && memory != cairn::nothing_met)
                ++(a.kind == Convex::Kind::hull && b.kind == Convex::Kind::hull && memory >> 28 == 3 ? edges : faces);
            guess = normal_of(warm);
            p.offset += way;
            p.qa = about(axis, 0.02) * p.qa;
            const double tolerance = 2 * preference(a, b) + 1e-5;
            if (deepest(cold) > 0.02 - tolerance || deepest(warm) > 0.02 - tolerance || deepest(cold) < -0.1) continue;
            ++touching;
            EXPECT_NEAR(deepest(cold), deepest(warm), tolerance) << k << " kinds " << int(a.kind) << " " << int(b.kind);
        }
    }
    EXPECT_GT(touching, 1000);
    EXPECT_GT(faces, 200);
    EXPECT_GT(edges, 20);
}

// A shape on a floor of a given kind, `gap` above it, rotated by `q`.
Manifold on_floor(const Solid& s, const Solid& floor, double half, double gap, DQuat q = {}, DVec3 guess = {}) {
    Manifold m;
    collide_convex(s.at({}, q), floor.at({0.1, -half - gap - 0.5, -0.05}), 0.02, guess, m);
    return m;
}
constexpr DVec3 y_axis{0, 1, 0};

TEST(ConvexContact, ShapesAtRestHaveAllTheirPointsAndTheExactSeparation) {
    const Solid floors[] = {box(3, 0.5, 3), hull(box_hull({3, 0.5, 3})), cylinder(0.5, 3)};
    struct Rest {
        const char* name;
        Solid solid;
        double half;
        DQuat q;
        int count;
    };
    const Rest rests[] = {{"box", box(0.5, 0.4, 0.3), 0.4, {}, 4},
                          {"hull", hull(box_hull({0.5, 0.4, 0.3})), 0.4, {}, 4},
                          {"hexagonal prism", hull(prism(6, 0.5, 0.25)), 0.25, {}, 4},
                          {"prism on its side", hull(prism(4, 0.5, 0.25)), 0.5 * std::sqrt(0.5),
                           about({0, 0, 1}, 0.78539816339744831) * about({1, 0, 0}, 1.5707963267948966), 4},
                          {"cylinder", cylinder(0.5, 0.25), 0.5, {}, 4},
                          {"cone", cylinder(0.5, 0.25, 0), 0.5, {}, 4},
                          {"lying cylinder", cylinder(0.5, 0.25), 0.25, lying, 2},
                          {"lying capsule", capsule(0.5, 0.25), 0.25, lying, 2},
                          {"standing capsule", capsule(0.5, 0.25), 0.75, {}, 1},
                          {"ball", ball(0.25), 0.25, {}, 1}};
    for (const Solid& floor : floors)
        for (const Rest& r : rests)
            for (double gap : {-0.005, -1e-4, 0.0, 1e-4, 0.01})
                for (double lean : {0.0, 1e-8, 1e-6, 1e-4}) {
                    const DQuat q = about(normalized(DVec3{0.6, 0, 0.8}), lean) * r.q;
                    const Manifold m = on_floor(r.solid, floor, r.half, gap, q);
                    ASSERT_EQ(flaw(m, 0.02), "");
                    EXPECT_EQ(m.count, r.count)
                        << r.name << " gap " << gap << " lean " << lean << " floor " << int(floor.geometry.type);
                    EXPECT_NEAR(m.normal[1], -1, 1e-6) << r.name << " gap " << gap << " lean " << lean;
                    EXPECT_NEAR(deepest(m), gap - lean * 0.4, 1e-6 + 0.4 * lean) << r.name << " gap " << gap;
                    for (int i = 0; i < m.count; ++i) {
                        EXPECT_NEAR(m.points[i][1], -r.half - 0.5 * gap, 1e-6 + lean) << r.name;
                    }
                }
}

TEST(ConvexContact, PointsAtRestDoNotJump) {
    Random random(6);
    const Solid solids[] = {hull(box_hull({0.5, 0.4, 0.3})), hull(prism(6, 0.5, 0.4)), cylinder(0.4, 0.5),
                            hull(dodecahedron(0.3))};
    const double halves[] = {0.4, 0.4, 0.4, 0};
    for (int s = 0; s < 3; ++s) {
        Manifold last;
        DVec3 guess;
        for (int k = 0; k < 200; ++k) {
            const DQuat q = about(random.direction(), random.uniform(0, 1e-6));
            const Manifold m =
                on_floor(solids[s], box(3, 0.5, 3), halves[s], -1e-4 + random.uniform(0, 1e-6), q, guess);
            guess = normal_of(m);
            ASSERT_EQ(m.count, 4);
            for (int i = 0; i < 4 && k > 0; ++i) {
                EXPECT_LT(length(point_of(m, i) - point_of(last, i)), 1e-5) << s << " step " << k;
                EXPECT_EQ(m.features[i], last.features[i]);
            }
            last = m;
        }
    }
}

TEST(ConvexContact, TheFourPointsOfACylinderDoNotTurnWithIt) {
    for (const Solid& floor : {box(3, 0.5, 3), hull(box_hull({3, 0.5, 3}))}) {
        const Manifold first = on_floor(cylinder(0.5, 0.25), floor, 0.5, 0);
        for (int k = 1; k < 50; ++k) {
            const Manifold m = on_floor(cylinder(0.5, 0.25), floor, 0.5, 0, about(y_axis, 0.1 * k));
            for (int i = 0; i < 4; ++i) EXPECT_LT(length(point_of(m, i) - point_of(first, i)), 1e-5);
        }
        // The points are the corners of a square on the rim.
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(std::hypot(first.points[i][0], first.points[i][2]), 0.25, 1e-5);
        EXPECT_NEAR(length(point_of(first, 0) - point_of(first, 1)), 0.5, 1e-5);
        EXPECT_NEAR(length(point_of(first, 2) - point_of(first, 3)), 0.5, 1e-5);
    }
}

TEST(ConvexContact, ALeaningCylinderTouchesFirstAtTheLowestPointOfItsRim) {
    for (double angle : {0.01, 0.1, 0.5, 1.0, 1.4}) {
        const DQuat q = about({0, 0, 1}, angle); // the axis leans to -x: the lowest point is at -x sin
        const double x = -0.25 * std::cos(angle) + 0.5 * std::sin(angle),
                     y = -0.25 * std::sin(angle) - 0.5 * std::cos(angle);
        const Manifold m = on_floor(cylinder(0.5, 0.25), box(3, 0.5, 3), -y, -0.001, q);
        ASSERT_GE(m.count, 1);
        EXPECT_NEAR(m.normal[1], -1, 1e-6);
        EXPECT_NEAR(m.points[0][0], x, 1e-5) << angle;
        EXPECT_NEAR(m.points[0][2], 0, 1e-5) << angle;
        EXPECT_NEAR(m.points[0][3], -0.001, 1e-6) << angle;
    }
}

TEST(ConvexContact, CapsulesSideBySideTouchAtTwoPoints) {
    Manifold m;
    collide_convex(capsule(0.5, 0.2).at({}), capsule(0.4, 0.2).at({0.41, 0.3, 0}), 0.02, {}, m);
    ASSERT_EQ(m.count, 2);
    EXPECT_NEAR(m.normal[0], 1, 1e-7);
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(m.points[i][0], 0.205, 1e-7);
        EXPECT_NEAR(m.points[i][3], 0.01, 1e-7);
    }
    EXPECT_NEAR(std::max(m.points[0][1], m.points[1][1]), 0.5, 1e-6);
    EXPECT_NEAR(std::min(m.points[0][1], m.points[1][1]), -0.1, 1e-6);
}

TEST(ConvexContact, ABoxThatRestsOnALedgeByAMillimeterIsHeldFromBelow) {
    Manifold m;
    collide_convex(box(0.5, 0.5, 0.5).at({}), hull(box_hull({0.5, 0.5, 0.5})).at({0.999, -0.9999, 0}), 0.02, {}, m);
    EXPECT_NEAR(m.normal[1], -1, 1e-6);
    EXPECT_EQ(m.count, 4);
}

TEST(ConvexContact, ExtremeSizesAndPlacesGiveSoundManifolds) {
    Random random(7);
    for (int k = 0; k < 20000; ++k) {
        const double size_a = std::array{1e-3, 1.0, 1e3}[std::size_t(random.below(3))];
        const double size_b = random.below(3) == 0 ? size_a * 1e5 : size_a;
        Pair p = random_pair(random, size_a, size_b);
        switch (random.below(5)) {
        case 0:
            p.offset = {};
            break;
        case 1:
            p.second = p.first, p.offset = {}, p.qb = p.qa;
            break;
        case 2:
            p.qa = p.qb = {};
            break;
        case 3:
            p.offset = (0.01 + random.uniform(0, 1)) * p.offset;
            break;
        default:
            p.offset = random.uniform(0, 1e-9) * p.offset;
        }
        Manifold m;
        collide_convex(p.a(), p.b(), 0.02 * size_a, random.direction(), m);
        ASSERT_EQ(flaw(m, 0.02 * size_a), "") << k;
        if (p.offset == DVec3{}) {
            EXPECT_GE(m.count, 1) << k;
            EXPECT_LT(deepest(m), 0) << k;
        }
    }
}

// Where cylinders and capsules cross, the axis of least penetration is the cross product of both axes.
TEST(ConvexContact, CrossingSidesAreAsFarApartAsGjkAndEpaSay) {
    Random random(9);
    int beside = 0, overlapping = 0;
    for (int k = 0; k < 40000; ++k) {
        const double half_a = random.uniform(0.1, 1), half_b = random.uniform(0.1, 1), ra = random.uniform(0.02, 0.3),
                     rb = random.uniform(0.02, 0.3);
        const Solid sa = cylinder(half_a, ra), sb = random.below(2) ? cylinder(half_b, rb) : capsule(half_b, rb);
        const DVec3 offset = random.uniform(0, ra + rb + 0.1) * random.direction();
        const Convex a = sa.at({}, random.rotation()), b = sb.at(offset, random.rotation());
        Manifold m;
        collide_convex(a, b, 1, {}, m);
        if (m.count != 1) continue;
        const DVec3 n = cairn::math::to_double(cairn::math::to_vec(m.normal));
        if (std::fabs(dot(n, a.axes.c1)) > 1e-6 || std::fabs(dot(n, b.axes.c1)) > 1e-6) continue;
        const cairn::CorePair pair{exact_core(a), exact_core(b)};
        const auto r = gjk_distance(pair, offset, 1e300);
        const double radii = exact_core(a).radius + exact_core(b).radius;
        const bool is_over = r.state == cairn::GjkResult::State::overlapping;
        const double distance = is_over ? -epa_depth(pair, r.simplex).depth - radii : r.distance - radii;
        ASSERT_NEAR(double(m.points[0][3]), distance, 2e-3 * (ra + rb)) << k; // EPA's own error for round shapes
        if (!is_over) {
            ASSERT_NEAR(double(m.points[0][3]), distance, 1e-6) << k;
        }
        ++(is_over ? overlapping : beside);
    }
    EXPECT_GT(beside, 2000);
    EXPECT_GT(overlapping, 1000);
}

} // namespace
