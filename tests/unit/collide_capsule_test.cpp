// The capsule kernels of every backend, compared with the closest points of the axes in double precision. The number of
// contact points is compared with the convex test.
#include "collide_convex_support.h"

#include <algorithm>
#include <string>

using namespace collide_test;
using cairn::ShapeType;

namespace {

// The relative placement of two capsules (or balls, whose half length is 0).
struct Placed {
    Frame a, b;
    double reach = 0;          // sum of the radii
    double size = 0;           // of both and the offset between them: errors are relative to it
    double sine = 0;           // of the angle between the axes
    double start = 0, end = 0; // the interval of the first axis that is beside the second
    double distance = 0;       // between the axes
    Vec normal = {};           // from the first to the second, at the closest points

    Placed(const Frame& first, const Frame& second) : a(first), b(second) {
        const Vec d = b.center - a.center;
        a.center = {0, 0, 0}, b.center = d; // relative positions, so that a double keeps more digits of the distance
        reach = a.half[0] + b.half[0];
        size = reach + a.half[1] + b.half[1] + length(d);
        sine = length(cross(a.axis[1], b.axis[1]));
        const double along = dot(d, a.axis[1]), cover = b.half[1] * std::fabs(dot(a.axis[1], b.axis[1]));
        start = std::max(-a.half[1], along - cover), end = std::min(a.half[1], along + cover);
        // The distance to the other segment is convex along each segment: golden-section search.
        double low = -a.half[1], high = a.half[1], nearest = low;
        const auto offer = [&](double s) { nearest = distance_at(s) < distance_at(nearest) ? s : nearest; };
        offer(high);
        for (int i = 0; i < 90; ++i) {
            const double s = high - 0.6180339887 * (high - low), t = low + 0.6180339887 * (high - low);
            (distance_at(s) < distance_at(t) ? high : low) = distance_at(s) < distance_at(t) ? t : s;
        }
        offer(low);
        distance = distance_at(nearest);
        const Vec p = a.center + nearest * a.axis[1];
        if (distance > 0) normal = (1 / distance) * (nearest_on(b, p) - p);
    }
    double distance_at(double s) const {
        const Vec p = a.center + s * a.axis[1];
        return length(nearest_on(b, p) - p);
    }
};

constexpr double rounding = 1e-6; // of lengths, relative to the size

// A contact point is midway between the surfaces; along the normal, the axes are at the radii plus half the separation.
std::string point_flaw(const Placed& at, const Manifold& m, int k, double tolerance) {
    const Vec n = normal_of(m), p = at.a.center + point_of(m, k);
    const Vec on_a = p - (at.a.half[0] + 0.5 * separation_of(m, k)) * n;
    const Vec on_b = p + (at.b.half[0] + 0.5 * separation_of(m, k)) * n;
    if (length(on_b - nearest_on(at.b, on_b)) > tolerance) return "point beside the second axis";
    // For capsules side by side, the points are at the second axis, which the first may cross at a small angle.
    const double oblique = m.features[k] != 0 ? at.sine * (at.distance + at.end - at.start) : 0;
    if (length(on_a - nearest_on(at.a, on_a)) > tolerance + oblique) return "point beside the first axis";
    if (m.features[k] == 0) return {};
    const double s = dot(at.a.axis[1], on_a - at.a.center), expected = m.features[k] == 1 ? at.start : at.end;
    return std::fabs(s - expected) > 2 * tolerance + oblique ? "not at the end" : "";
}

// Where the axes cross, translating along the normal by the depth must separate the capsules.
std::string crossing_flaw(const Placed& at, const Manifold& m, double tolerance) {
    Frame moved = at.b;
    moved.center = at.b.center - deepest_of(m) * normal_of(m);
    return Placed(at.a, moved).distance < at.reach - 20 * tolerance ? "the push does not part them" : "";
}

// Describes an error of the kernel that exceeds rounding; empty if there is none.
std::string disagreement(const Placed& at, double margin, const Manifold& m, const Manifold& other) {
    if (std::string s = flaw(m, margin); !s.empty()) return s;
    const double separation = at.distance - at.reach, tolerance = rounding * at.size;
    const bool is_near = separation <= margin;
    if (std::fabs(separation - margin) > tolerance && (m.count > 0) != is_near) return "touching";
    if (m.count == 0) return std::fabs(reported_distance(m) - separation) <= tolerance ? "" : "distance";
    const bool is_crossing = at.distance < 1e-5 * at.size;
    if (deepest_of(m) < separation - tolerance - (is_crossing ? at.distance : 0)) return "too deep";
    if (m.features[0] == 0 && deepest_of(m) > separation + tolerance) return "not deep enough";
    if (is_crossing) return crossing_flaw(at, m, tolerance);
    for (int k = 0; k < m.count; ++k)
        if (std::string s = point_flaw(at, m, k, 2 * tolerance * (1 + at.reach / at.distance)); !s.empty()) return s;

    // For nearly parallel lines the closest points are ill-conditioned: the slightest rotation decides.
    const double uncertain = at.sine > 0 ? std::min(rounding / at.sine, at.sine * at.size / at.distance) : 0;
    if (length(normal_of(m) - at.normal) > 2 * tolerance / at.distance + 1e-6 + uncertain) return "normal";
    // The double-precision test gives the number of points, except where rounding decides.
    if (other.count == 0) return {};
    const double least = 1e-3 * std::min(at.a.half[0], at.b.half[0]), shift = 1e-2 * at.reach + tolerance;
    if (std::fabs(at.sine - 1e-2) < 1e-5 || std::fabs(at.end - at.start - least) < 2 * least + shift) return {};
    for (const Manifold* some : {&m, &other})
        for (int k = 0; k < some->count; ++k)
            if (std::fabs(separation_of(*some, k) - margin) < 0.01 * shift + 10 * tolerance) return {};
    return m.count == other.count ? "" : "count";
}

// Millimeters, meters, hundreds of meters; slender and stout; the second capsule may have another size.
struct Size {
    double radius, half;
};
Size any_size(Random& random) {
    const double scale = std::array{1e-3, 0.3, 1.0, 1.0, 100.0}[static_cast<std::size_t>(random.below(5))];
    return {scale * random.uniform(0.1, 1), random.below(16) == 0 ? 0.0 : scale * random.uniform(0.02, 3)};
}

enum Lie { anyhow, parallel, nearly_parallel, side_by_side, crossing, end_to_end, same_pose, in_line, lies };

void add_pair(Random& random, Pairs& pairs, int lie) {
    const Size a = any_size(random), b = random.below(3) == 0 ? any_size(random) : a;
    const double reach = a.radius + b.radius, all = reach + a.half + b.half;
    const Vec place = (random.below(2) == 0 ? 1.0 : 1e5) * random.direction();
    const Quat qa = random.rotation();
    Quat qb = random.rotation();
    if (lie == parallel || lie == side_by_side || lie == in_line) qb = random.below(2) ? qa : times(qa, {1, 0, 0, 0});
    const double small = std::pow(10.0, random.uniform(-9, -1.3));
    if (lie == nearly_parallel) qb = times(qa, about({1, 0, 0}, random.below(2) ? small : 3.14159265358979 - small));
    const Vec e = axis_of(qa), f = axis_of(qb), side = cross(e, random.direction());
    const Vec on_a = random.uniform(-1, 1) * a.half * e, on_b = random.uniform(-1, 1) * b.half * f;
    Vec offset = random.uniform(0, 1) * all * random.direction();
    const double gap = reach * random.uniform(0.9, 1.05);
    if (lie == nearly_parallel || lie == side_by_side) offset = on_a - on_b + (gap / length(side)) * side;
    if (lie == crossing) offset = on_a - on_b;
    if (lie == end_to_end) offset = a.half * e + gap * random.direction() + b.half * f;
    if (lie == same_pose) qb = qa, offset = {0, 0, 0};
    if (lie == in_line) offset = random.uniform(0, 1.02) * all * e;
    pairs.add(capsule(place, qa, a.radius, a.half), capsule(place + offset, qb, b.radius, b.half),
              float(random.below(2) * 0.05 * reach));
}

void expect_agreement(cairn::CollideKernel cairn::KernelTable::*kernel, const Pairs& pairs, ShapeType first,
                      int min_touching, int min_double) {
    std::vector<Manifold> truth;
    for (int i = 0; i < pairs.count(); ++i) truth.push_back(scalar_result(pairs, i, first));
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> manifolds = run(table->*kernel, pairs);
        int touching = 0, doubles = 0, wrong = 0;
        for (int i = 0; i < pairs.count(); ++i) {
            const Manifold &m = manifolds[static_cast<std::size_t>(i)], &other = truth[static_cast<std::size_t>(i)];
            touching += m.count > 0;
            doubles += m.count == 2;
            const Placed at(frame_of(pairs.first(i)), frame_of(pairs.second(i)));
            const std::string s = disagreement(at, pairs.margin(i), m, other);
            if (s.empty() || ++wrong > 5) continue;
            ADD_FAILURE() << table->name << ", pair " << i << ": " << s << " (" << m.count << " points, expected "
                          << other.count << ", distance " << at.distance << ", size " << at.size << ", sine " << at.sine
                          << ", side by side " << at.end - at.start << ", deepest " << deepest_of(m) << ", expected "
                          << deepest_of(other) << ", margin " << pairs.margin(i) << ")";
        }
        EXPECT_EQ(wrong, 0) << table->name;
        EXPECT_GT(touching, min_touching) << table->name;
        EXPECT_GE(doubles, min_double) << table->name;
    }
}

} // namespace

TEST(CollideCapsule, CapsulesTouchWhereTheirAxesAreNearest) {
    Random random(11);
    Pairs pairs;
    for (int i = 0; i < 160000; ++i) add_pair(random, pairs, i % lies);
    expect_agreement(&cairn::KernelTable::capsule_capsule, pairs, ShapeType::capsule, 80000, 40000);
}

TEST(CollideCapsule, SpheresTouchWhereTheAxisIsNearest) {
    Random random(12);
    Pairs capsules, pairs;
    for (int i = 0; i < 40000; ++i) add_pair(random, capsules, i % lies);
    for (int i = 0; i < capsules.count(); ++i) {
        ShapePose ball = capsules.first(i); // the ball's center may be on the axis, or just beside it
        ball.size[1] = 0;
        ball.size[3] = ball.size[0];
        pairs.add(ball, capsules.second(i), capsules.margins[static_cast<std::size_t>(i)]);
    }
    expect_agreement(&cairn::KernelTable::sphere_capsule, pairs, ShapeType::sphere, 15000, 0);
}

// Also where the axes have no length, or coincide.
TEST(CollideCapsule, WhatLiesInEachOtherIsPushedAcross) {
    const Quat q = about({0.6, 0, 0.8}, 0.7);
    for (const cairn::KernelTable* table : backends())
        for (const double half : {0.0, 0.5}) {
            const ShapePose c = capsule({1, 2, 3}, q, 0.25, half);
            const Manifold m = run_one(table->capsule_capsule, c, c, 0),
                           s = run_one(table->sphere_capsule, sphere({1, 2, 3}, 0.25), c, 0);
            ASSERT_EQ(flaw(m, 0), "");
            ASSERT_EQ(flaw(s, 0), "");
            EXPECT_EQ(m.count, half > 0 ? 2 : 1);
            EXPECT_EQ(s.count, 1);
            EXPECT_NEAR(dot(normal_of(m), axis_of(q)), 0, 1e-6);
            EXPECT_NEAR(dot(normal_of(s), axis_of(q)), 0, 1e-6);
            EXPECT_FLOAT_EQ(m.points[0][3], -0.5f);
            EXPECT_FLOAT_EQ(s.points[0][3], -0.5f);
        }
}
