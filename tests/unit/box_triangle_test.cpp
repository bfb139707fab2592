// A sharp box against a triangle: the specialized test, compared with the test for all convex shapes.
#include "collision/box_triangle.h"
#include "collision/contact_points.h"
#include "collision/convex_contact.h"
#include "convex_test_support.h"
#include "kernels/kernels.h"
#include "shapes/box_triangle_distance.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;
using cairn::BoxHit;
using cairn::BoxOnTriangles;
using cairn::Manifold;
using cairn::SurfaceContact;
using Verdict = BoxOnTriangles::Verdict;

struct Trial {
    Convex box;
    cairn::Triangle triangle;
    DVec3 center; // origin of the triangle's frame
    DMat3 axes;
    double margin;
};

// A box that touches or nearly touches a triangle, usually almost flat on it.
Trial any_trial(Random& random) {
    Trial t;
    const double size = random.below(4) == 0 ? 0.05 : 1;
    cairn::Geometry g;
    g.type = cairn::ShapeType::box;
    g.size = {float(size * random.uniform(0.1, 0.5)), float(size * random.uniform(0.1, 0.5)),
              float(size * random.uniform(0.1, 0.5))};
    t.margin = 0.02 * size;
    const double reach = std::array{0.3, 1.0, 10.0, 1000.0}[std::size_t(random.below(4))];
    const auto corner = [&] {
        const double distance = reach * random.uniform(0.1, 1);
        return distance * random.direction();
    };
    const DVec3 a = corner(), b = corner(), c = corner();
    t.triangle = {cairn::math::to_float(a), cairn::math::to_float(b), cairn::math::to_float(c)};
    t.axes = cairn::math::to_matrix(random.rotation());
    const auto placed = [&](cairn::math::Vec3 v) { return t.axes * cairn::math::to_double(v); };
    const DVec3 p = placed(t.triangle.a), q = placed(t.triangle.b), r = placed(t.triangle.c);
    const DVec3 normal = normalized(cross(q - p, r - p));
    // Rotated so that the box's y axis is the normal or along an edge, then perturbed by a small or arbitrary angle.
    DQuat rotation = random.rotation();
    if (random.below(4) != 0) {
        const DVec3 y = random.below(4) == 0 ? normalized(q - p) : normal;
        const DVec3 across = cross({0, 1, 0}, y);
        const double angle = std::atan2(length(across), y.y);
        rotation = about(length(across) > 0 ? normalized(across) : DVec3{1, 0, 0}, angle) *
                   about({0, 1, 0}, random.uniform(-3, 3));
        const double lean = std::array{0.0, 1e-6, 1e-3, 0.3}[std::size_t(random.below(4))];
        rotation = about(random.direction(), lean) * rotation;
    }
    t.box = make_convex(g, {}, {}, rotation);
    const double half = dot(support(t.box, normal), normal);
    double u = random.uniform(-0.3, 1.3), v = random.uniform(-0.3, 1.3);
    if (random.below(3) == 0) u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
    const double height = random.below(8) == 0 ? random.uniform(-1, 2) : 1 + random.uniform(-0.1, 0.1) * size;
    const DVec3 middle = p + u * (q - p) + v * (r - p) + height * half * normal;
    t.center = -middle;
    return t;
}

// The verdict for the trial's single triangle.
Verdict verdict_of(BoxOnTriangles& box, const Trial& t, BoxHit& hit) {
    box.add(0);
    box.look([&](std::uint32_t) { return t.triangle; });
    Verdict found = Verdict::apart;
    box.test([&](std::uint32_t, Verdict verdict, const BoxHit& at) { found = verdict, hit = at; });
    return found;
}

struct Found {
    Manifold manifold;
    SurfaceContact contact;
};
Convex triangle_of(const Trial& t) {
    const auto placed = [&](cairn::math::Vec3 v) { return t.center + t.axes * cairn::math::to_double(v); };
    return cairn::make_triangle(placed(t.triangle.a), placed(t.triangle.b), placed(t.triangle.c));
}
Found by_general_test(const Trial& t) {
    const Convex triangle = triangle_of(t);
    Found f;
    f.contact = collide_surface(t.box, triangle, t.margin, -triangle.axes.c1, f.manifold);
    return f;
}

double distance_to(const BoxHit& hit, const DMat3& axes, DVec3 p) {
    double least = 1e300;
    for (int i = 0; i < hit.count; ++i) least = std::min(least, length(axes * hit.points[i].position - p));
    return least;
}

TEST(BoxOnTriangle, SaysWhatTheTestOfAllConvexShapesSays) {
    Random random(1);
    int verdicts[4] = {}, on_face = 0, on_edge = 0;
    for (int k = 0; k < 100000; ++k) {
        const Trial t = any_trial(random);
        BoxHit hit;
        BoxOnTriangles box(cairn::kernels().triangles, t.box, t.center, t.axes, t.margin);
        const Verdict verdict = verdict_of(box, t, hit);
        ++verdicts[int(verdict)];
        if (verdict != Verdict::apart && verdict != Verdict::touching) continue;
        const Found f = by_general_test(t);
        const Manifold& m = f.manifold;
        ASSERT_EQ(verdict == Verdict::touching, m.count > 0) << k;
        if (m.count == 0) continue;
        const DVec3 normal = t.box.axes * hit.normal;
        const DVec3 expected{m.normal[0], m.normal[1], m.normal[2]};
        ASSERT_LT(length(normal - expected), 1e-6) << k;
        const bool is_on_face = f.contact.part == SurfaceContact::Part::face;
        ++(is_on_face ? on_face : on_edge);
        ASSERT_EQ(hit.on_face, is_on_face) << k;
        // The contact points that the general test selects are among those of the specialized test, and none of these
        // is deeper.
        const double far = 1e-6 * (1 + length(t.center));
        double deepest = 1e300;
        for (int i = 0; i < m.count; ++i) {
            const DVec3 p{m.points[i][0], m.points[i][1], m.points[i][2]};
            ASSERT_LT(distance_to(hit, t.box.axes, p), far) << k << " point " << i;
            deepest = std::min(deepest, double(m.points[i][3]));
        }
        ASSERT_NEAR(hit.separation, deepest, 1e-6 + 1e-4 * t.box.extent) << k; // points of equal depth, up to that
        double least = 1e300;
        for (int i = 0; i < hit.count; ++i) {
            EXPECT_LE(hit.points[i].separation, t.margin);
            least = std::min(least, hit.points[i].separation);
        }
        ASSERT_EQ(least, hit.separation) << k;
    }
    // The trials cover the relevant cases: every verdict occurs often, and so do both kinds of contact.
    for (int v : verdicts) EXPECT_GT(v, 1000);
    EXPECT_GT(on_face, 5000);
    EXPECT_GT(on_edge, 1000);
}

TEST(BoxOnTriangle, WhatIsBeyondItsFacesIsFoundWithoutThem) {
    Random random(2);
    int found = 0, touching = 0;
    for (int k = 0; k < 100000; ++k) {
        const Trial t = any_trial(random);
        BoxOnTriangles box(cairn::kernels().triangles, t.box, t.center, t.axes, t.margin);
        BoxHit hit;
        if (verdict_of(box, t, hit) != Verdict::beyond_faces) continue;
        const Found f = by_general_test(t);
        const Convex triangle = triangle_of(t);
        Manifold m;
        const SurfaceContact c =
            collide_surface_beyond(box.best_face(), t.box, triangle, t.margin, -triangle.axes.c1, m);
        ++found;
        ASSERT_EQ(m.count, f.manifold.count) << k;
        ASSERT_EQ(c.part, f.contact.part) << k;
        touching += m.count > 0 ? 1 : 0;
        for (int i = 0; i < 3; ++i) ASSERT_EQ(m.normal[i], f.manifold.normal[i]) << k;
        for (int i = 0; i < m.count; ++i)
            for (int j = 0; j < 4; ++j) ASSERT_EQ(m.points[i][j], f.manifold.points[i][j]) << k;
    }
    EXPECT_GT(found, 5000);
    EXPECT_GT(touching, 2000);
}

// The lower bound of the distance, by which separated pairs may be skipped for some steps.
TEST(BoxOnTriangle, TellsHowFarApartAtLeast) {
    Random random(3);
    int apart = 0;
    double told = 0, all = 0;
    for (int k = 0; k < 30000; ++k) {
        Trial t = any_trial(random);
        t.center += random.uniform(0, 1) * random.direction();
        BoxOnTriangles box(cairn::kernels().triangles, t.box, t.center, t.axes, t.margin);
        box.add(0);
        const double least = box.look([&](std::uint32_t) { return t.triangle; });
        const Convex triangle = triangle_of(t);
        DVec3 corners[3], on_box, on_triangle;
        for (int i = 0; i < 3; ++i) corners[i] = to_local(t.box, triangle.corners[i] - t.box.center);
        double distance = 0;
        if (cairn::nearest_of_box_and_triangle(t.box.size, corners, on_box, on_triangle))
            distance = length(on_triangle - on_box);
        ASSERT_LE(least, distance + 1e-9 * (1 + length(t.center))) << k;
        if (distance < t.margin) continue;
        ++apart;
        told += std::max(least, 0.0), all += distance;
    }
    EXPECT_GT(apart, 5000);
    EXPECT_GT(told, 0.4 * all);
}

} // namespace
