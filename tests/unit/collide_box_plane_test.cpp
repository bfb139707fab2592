// Boxes against infinite planes and one-sided rectangles, in every backend, compared with double-precision references.
#include "box_box_oracle.h"

#include <algorithm>
#include <string>

using namespace collide_test;

namespace {

constexpr float usual_margin = 0.02f;

struct Corner {
    double height;
    Vec position;
};

// The vertices of a box with their heights above a plane, lowest first.
std::vector<Corner> corners_over(const Frame& box, const Frame& plane) {
    std::vector<Corner> r;
    for (int i = 0; i < 8; ++i) {
        const Vec local = {(i & 1) ? box.half[0] : -box.half[0], (i & 2) ? box.half[1] : -box.half[1],
                           (i & 4) ? box.half[2] : -box.half[2]};
        const Vec p = box.to_world(local);
        r.push_back({dot(plane.axis[1], p - plane.center), p});
    }
    std::sort(r.begin(), r.end(), [](const Corner& a, const Corner& b) { return a.height < b.height; });
    return r;
}

// A contact with the plane has its normal straight down, and every contact point is a vertex at its height, the deepest
// vertex among them.
std::string plane_disagreement(const Frame& a, const Frame& ground, const Manifold& m, double margin) {
    if (std::string s = flaw(m, margin); !s.empty()) return s;
    const std::vector<Corner> corners = corners_over(a, ground);
    const double tolerance = 2e-6 * (1 + length(a.center - ground.center) + length(a.half));
    int within = 0;
    for (const Corner& c : corners) {
        if (std::fabs(c.height - margin) < tolerance) return {}; // undecided because of rounding
        within += c.height < margin;
    }
    if (within == 0) return m.count == 0 ? "" : "contact out of reach";
    if (m.count == 0) return "no contact";
    if (m.count < std::min(within, 2)) return "too few points";
    if (dot(normal_of(m), ground.axis[1]) > -1 + 1e-6) return "normal";
    const double smallest = *std::min_element(a.half.begin(), a.half.end());
    if (std::fabs(deepest_of(m) - corners[0].height) > 1.01e-4 * smallest + tolerance) return "not the deepest";
    for (int k = 0; k < m.count; ++k) {
        const Vec p = a.center + point_of(m, k) - (0.5 * separation_of(m, k)) * normal_of(m);
        const bool found = std::any_of(corners.begin(), corners.end(), [&](const Corner& c) {
            return length(c.position - p) < 10 * tolerance && std::fabs(c.height - separation_of(m, k)) < tolerance;
        });
        if (!found) return "point " + std::to_string(k) + " is not a corner";
    }
    return {};
}

} // namespace

TEST(CollideBoxPlane, PointsAreTheDeepestCorners) {
    Random random(5);
    Pairs pairs;
    for (int i = 0; i < 10000; ++i) {
        const Vec half = {random.uniform(0.02, 1), random.uniform(0.02, 1), random.uniform(0.02, 1)};
        const ShapePose ground = plane({random.uniform(-5, 5), random.uniform(-5, 5), 1}, random.rotation());
        const Vec local = {random.uniform(-5, 5), random.uniform(-0.5, 1.2) * length(half), random.uniform(-5, 5)};
        pairs.add(box(frame_of(ground).to_world(local), random.rotation(), half), ground, usual_margin);
    }
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> manifolds = run(table->box_plane, pairs);
        for (int i = 0; i < pairs.count(); ++i)
            ASSERT_EQ(plane_disagreement(frame_of(pairs.first(i)), frame_of(pairs.second(i)),
                                         manifolds[static_cast<std::size_t>(i)], pairs.margin(i)),
                      "")
                << table->name << ", pair " << i;
    }
}

TEST(CollideBoxPlane, FlatBoxRestsOnItsFourFaceCorners) {
    Random random(6);
    for (const cairn::KernelTable* table : backends())
        for (int i = 0; i < 500; ++i) {
            const std::size_t down = static_cast<std::size_t>(random.below(3));
            Vec half = {random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)};
            if (i % 2 == 0) half[down] = 0.004; // so thin that the upper vertices are within the margin too
            const Vec axes[] = {{0, 0, 1}, {1, 0, 0}, {1, 0, 0}};
            const double turns[] = {std::acos(0.0), 0.0, std::acos(0.0)};
            Quat q = about(axes[down], turns[down]);
            const double tilt = random.uniform(-1e-4, 1e-4);
            for (double& c : q) c += 0.5 * tilt * random.uniform(-1, 1);
            const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
            for (double& c : q) c /= norm;
            const ShapePose crate = box({3, half[down] - 0.001, -2}, q, half);
            const ShapePose ground = plane({0, 0, 0}, about({0, 1, 0}, random.uniform(0, 6)));
            const Manifold m = run_one(table->box_plane, crate, ground, usual_margin);
            ASSERT_EQ(plane_disagreement(frame_of(crate), frame_of(ground), m, usual_margin), "");
            ASSERT_EQ(m.count, 4);
            Polygon points;
            for (int k = 0; k < 4; ++k) points.push_back(across({0, 1, 0}, point_of(m, k)));
            ASSERT_GT(area_of(convex_hull(points)), 0.999 * 4 * half[(down + 1) % 3] * half[(down + 2) % 3]);
        }
}

TEST(CollideBoxRectangle, OverTheMiddleItIsAPlane) {
    Random random(8);
    Pairs pairs;
    for (int i = 0; i < 6000; ++i) {
        const Vec half = {random.uniform(0.05, 1), random.uniform(0.05, 1), random.uniform(0.05, 1)};
        const ShapePose floor = rectangle({random.uniform(-5, 5), 2, 1}, random.rotation(), 8, 6);
        const Quat q = random.rotation();
        ShapePose crate = box({0, 0, 0}, q, half);
        // Depths from just touching to half below the surface.
        const Frame f = frame_of(floor);
        Frame c = frame_of(crate);
        c.center = f.center;
        const double reach = -corners_over(c, f)[0].height;
        const Vec local = {random.uniform(-2, 2), random.uniform(0.01, 1.1) * reach, random.uniform(-2, 2)};
        crate = box(f.to_world(local), q, half);
        pairs.add(crate, floor, usual_margin);
    }
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> manifolds = run(table->box_rectangle, pairs);
        int touching = 0, sideways = 0;
        for (int i = 0; i < pairs.count(); ++i) {
            const Manifold& m = manifolds[static_cast<std::size_t>(i)];
            const Frame a = frame_of(pairs.first(i)), b = frame_of(pairs.second(i));
            ASSERT_EQ(flaw(m, usual_margin), "");
            const double lowest = corners_over(a, b)[0].height;
            if (std::fabs(lowest - usual_margin) < 1e-5) continue;
            ASSERT_EQ(m.count > 0, lowest < usual_margin) << table->name << ", pair " << i;
            if (m.count == 0) continue;
            ++touching;
            // A box that penetrates almost to its center has a shorter way out along one of its own axes; otherwise the
            // normal is vertical.
            if (dot(normal_of(m), b.axis[1]) > -1 + 1e-6) {
                ++sideways;
                EXPECT_GT(deepest_of(m), lowest - 1e-5);
                continue;
            }
            EXPECT_NEAR(deepest_of(m), lowest, 5e-2 * *std::min_element(a.half.begin(), a.half.end()) + 3e-5)
                << table->name << ", pair " << i;
        }
        EXPECT_GT(touching, 4000);
        EXPECT_LT(sideways, touching / 10);
    }
}

namespace {

// Checks the penetration depth of a box and a rectangle as two convex shapes, and whether the minimal translation leads
// up or sideways.
std::string rectangle_disagreement(const Frame& a, const Frame& b, const Manifold& m, double margin) {
    if (std::string s = flaw(m, margin); !s.empty()) return s;
    const Vec center = b.to_local(a.center);
    const double tolerance =
        5e-5 + 5.5e-2 * std::min(*std::min_element(a.half.begin(), a.half.end()), std::min(b.half[0], b.half[2]));
    if (m.count > 0 && -dot(normal_of(m), b.axis[1]) < -2e-3) return "pushed down";
    if (center[1] < -1e-5) {
        const double over = std::min(b.half[0] - std::fabs(center[0]), b.half[2] - std::fabs(center[2]));
        double room = center[1]; // height of the box's highest point above the rectangle
        for (std::size_t i = 0; i < 3; ++i) room += a.half[i] * std::fabs(dot(a.axis[i], b.axis[1]));
        if (std::fabs(over) < 1e-5 || std::fabs(room) < 1e-5) return {};
        if (over < 0 || room < 0) return m.count == 0 ? "" : "contact below";
        // The box's lower face may miss the rectangle although its center is over it: then there is no contact that
        // lifts it.
        if (m.count == 0) return corners_over(a, b)[0].height < 0 ? "not lifted" : "";
        return dot(normal_of(m), b.axis[1]) < -1 + 1e-6 ? "" : "not lifted straight";
    }
    if (center[1] < 1e-5) return {};
    const SeparatingAxis truth = greatest_separation(a, b);
    if (truth.separation > margin + 1e-5) return m.count == 0 ? "" : "contact out of reach";
    const double push = -dot(truth.normal, b.axis[1]);
    if (truth.separation > 0 || truth.sine < 0.05) return {};
    if (push > 0.01) { // the usual case: the minimal translation is up or sideways
        if (m.count == 0) return truth.separation < -2 * tolerance ? "no contact" : "";
        if (deepest_of(m) < truth.separation - 5e-5) return "deeper than the truth";
        if (deepest_of(m) > truth.separation + tolerance) return "less deep than the truth";
    }
    if (m.count > 0) {
        const Vec n = normal_of(m);
        Frame moved = a;
        moved.center = a.center + (deepest_of(m) - 2 * tolerance) * n;
        if (greatest_separation(moved, b).separation < 0) return "moving by the depth does not separate";
    }
    return {};
}

} // namespace

TEST(CollideBoxRectangle, FollowsItsRuleAnywhere) {
    Random random(9);
    Pairs pairs;
    for (int i = 0; i < 20000; ++i) {
        const Vec half = {random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)};
        const double hx = random.uniform(0.3, 3), hz = random.uniform(0.3, 3);
        const ShapePose floor = rectangle({random.uniform(-5, 5), 2, 1}, random.rotation(), hx, hz);
        const Vec local = {random.uniform(-1, 1) * (hx + 1), random.uniform(-0.5, 1), random.uniform(-1, 1) * (hz + 1)};
        pairs.add(box(frame_of(floor).to_world(local), random.rotation(), half), floor, usual_margin);
    }
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> manifolds = run(table->box_rectangle, pairs);
        int wrong = 0;
        for (int i = 0; i < pairs.count(); ++i) {
            const Frame a = frame_of(pairs.first(i)), b = frame_of(pairs.second(i));
            const Manifold& m = manifolds[static_cast<std::size_t>(i)];
            const std::string s = rectangle_disagreement(a, b, m, pairs.margin(i));
            if (s.empty() || ++wrong > 5) continue;
            const SeparatingAxis truth = greatest_separation(a, b);
            ADD_FAILURE() << table->name << ", pair " << i << ": " << s << " (center at height "
                          << b.to_local(a.center)[1] << ", true separation " << truth.separation << ", push up "
                          << -dot(truth.normal, b.axis[1]) << ", count " << m.count << ", deepest "
                          << (m.count ? deepest_of(m) : 0.0) << ")";
        }
        EXPECT_EQ(wrong, 0) << table->name;
    }
}

TEST(CollideBoxRectangle, RestsFlatOnFourPointsAndHangsOverTheRim) {
    const ShapePose table_top = rectangle({0, 0, 0}, no_rotation, 2, 1);
    for (const cairn::KernelTable* table : backends()) {
        const Manifold inside =
            run_one(table->box_rectangle, box({0, 0.5 - 1e-4, 0}, no_rotation, {0.5, 0.5, 0.5}), table_top, 0.01f);
        ASSERT_EQ(inside.count, 4);
        EXPECT_FLOAT_EQ(inside.normal[1], -1.0f);
        // Half beyond the border: the contact points end at the border of the rectangle.
        const Manifold over =
            run_one(table->box_rectangle, box({2, 0.5 - 1e-4, 0}, no_rotation, {0.5, 0.5, 0.5}), table_top, 0.01f);
        ASSERT_EQ(over.count, 4);
        for (int k = 0; k < 4; ++k) EXPECT_LT(over.points[k][0], 1e-3f);
        // The box is larger than the rectangle: the corners of the rectangle carry it.
        const Manifold wide =
            run_one(table->box_rectangle, box({0, 0.5 - 1e-4, 0}, no_rotation, {5, 0.5, 5}), table_top, 0.01f);
        ASSERT_EQ(wide.count, 4);
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(std::fabs(wide.points[k][0] * wide.points[k][2]), 2.0, 1e-3);
        // Beside the rectangle, with the center below it, and entirely below it.
        for (const Vec& at : {Vec{2.6, 0.1, 0}, Vec{2.3, -0.1, 0}, Vec{0, -0.51, 0}})
            EXPECT_EQ(run_one(table->box_rectangle, box(at, no_rotation, {0.5, 0.5, 0.5}), table_top, 0.01f).count, 0);
    }
}
