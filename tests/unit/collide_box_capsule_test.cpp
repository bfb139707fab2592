// The box-capsule kernel of every backend, compared with the distance from GJK in double precision where the capsule's
// axis is outside the box, and with the separating axes where it intersects the box. The number of points is compared
// with the convex test.
#include "box_box_oracle.h"
#include "collide_convex_support.h"
#include "shapes/gjk.h"

#include <algorithm>
#include <limits>
#include <string>

using namespace collide_test;
using cairn::ShapeType;

namespace {

constexpr double rounding = 1e-6;   // of lengths, relative to the size
constexpr double preference = 2e-3; // for faces, relative to the smaller half width
// Relative to the size: nearer than this, rounding dominates the direction between the axis and the box.
constexpr double meeting = 2e-5;

// The relative placement of a box and a capsule, relative to the center of the box.
struct Placed {
    Frame box, capsule;
    double radius = 0, size = 0, extent = 0;
    double distance = 0;   // signed distance of the capsule's axis from the box; negative where they intersect
    double separation = 0; // of the surfaces
    double sine = 1;       // of the least angle between the axis and a box edge that is not parallel to it

    Placed(const ShapePose& a, const ShapePose& b) : box(frame_of(a)), capsule(frame_of(b)) {
        const cairn::math::DVec3 offset = offset_between(a, b);
        box.center = {0, 0, 0}, capsule.center = {offset.x, offset.y, offset.z};
        radius = capsule.half[0];
        size = box.half[0] + box.half[1] + box.half[2] + capsule.half[1] + radius;
        extent = std::min({radius, box.half[0], box.half[1], box.half[2]});
        const cairn::Convex core_a = convex_of(a, ShapeType::box, {}),
                            core_b = convex_of(b, ShapeType::capsule, offset);
        const auto r =
            cairn::gjk_distance({exact_core(core_a), exact_core(core_b)}, {}, std::numeric_limits<double>::infinity());
        distance = r.state == cairn::GjkResult::State::apart ? r.distance : greatest_overlap();
        separation = distance - radius;
        for (const Vec& e : box.axis)
            if (const double l = length(cross(capsule.axis[1], e)); l > 1e-6) sine = std::min(sine, l);
    }
    // The separation of the capsule's axis and the box along a unit direction from the box.
    double along(const Vec& n) const {
        double reach = std::fabs(dot(n, capsule.axis[1])) * capsule.half[1];
        for (std::size_t i = 0; i < 3; ++i) reach += std::fabs(dot(n, box.axis[i])) * box.half[i];
        return dot(n, capsule.center) - reach;
    }
    double greatest_overlap() const {
        double best = -1e300;
        for (const Vec& e : box.axis)
            for (const Vec& v : {e, cross(capsule.axis[1], e)}) {
                if (length(v) < 1e-9) continue;
                const Vec n = (1 / length(v)) * v;
                best = std::max({best, along(n), along(-1.0 * n)});
            }
        return best;
    }
    // The index of the face axis that is parallel to a normal, or -1.
    int face_of(const Vec& n) const {
        for (int i = 0; i < 3; ++i)
            if (length(cross(n, box.axis[std::size_t(i)])) < 2e-6) return i;
        return -1;
    }
};

// A contact point is midway between the surfaces: the surface of the capsule is on one side of it, that of the box on
// the other.
std::string point_flaw(const Placed& at, const Manifold& m, int k, double tolerance) {
    const Vec n = normal_of(m), p = point_of(m, k);
    const Vec on_axis = p + (at.radius + 0.5 * separation_of(m, k)) * n, on_box = p - 0.5 * separation_of(m, k) * n;
    // The capsule's axis may cross an edge at a small angle; the contact points are on the edge.
    const double oblique = m.count == 2 && at.face_of(n) < 0 ? 1e-2 * (2 * at.capsule.half[1] + at.radius) : 0;
    if (length(on_axis - nearest_on(at.capsule, on_axis)) > tolerance + oblique + preference * at.extent)
        return "point beside the axis";
    const double outside = distance_to_box(at.box, on_box);
    const double wider = 1.1e-4 * *std::max_element(at.box.half.begin(), at.box.half.end());
    if (outside > tolerance + wider + preference * at.extent) return "point beside the box";
    return outside < -tolerance - preference * at.extent ? "point in the box" : "";
}

// Describes an error of the kernel that exceeds rounding; empty if there is none.
std::string disagreement(const Placed& at, double margin, const Manifold& m) {
    if (std::string s = flaw(m, margin); !s.empty()) return s;
    const double uncertain = std::fabs(at.distance) < meeting * at.size ? meeting * at.size : 0;
    // Where the axis intersects the box, a small angle between the axis and an edge makes their cross product
    // uncertain.
    const double askew = at.distance < meeting * at.size ? rounding * at.size / at.sine : 0;
    const double tolerance = rounding * at.size + uncertain + askew, prefers = preference * at.extent;
    const bool is_near = at.separation <= margin;
    if (std::fabs(at.separation - margin) > tolerance && (m.count > 0) != is_near) return "touching";
    if (m.count == 0) return std::fabs(reported_distance(m) - at.separation) <= tolerance ? "" : "distance";
    if (deepest_of(m) < at.separation - tolerance) return "too deep";
    if (deepest_of(m) > at.separation + prefers + tolerance) return "not deep enough";
    // Where the axis is near the box, rounding rotates the direction between them.
    const double turned = at.distance > 0 ? 1 + at.size / std::max(at.distance, meeting * at.size) : 1;
    if (at.along(normal_of(m)) < at.distance - prefers - tolerance * turned) return "another direction is better";
    for (int k = 0; k < m.count; ++k)
        if (std::string s = point_flaw(at, m, k, 3 * tolerance * turned); !s.empty()) return s;
    return {};
}

// Whether the kernel's manifold is worse than that of the convex test. Single points are verified by the distance
// (above); on nearly parallel edges the convex test has only one.
bool falls_short(const Placed& at, const Manifold& m, const Manifold& other) {
    if (length(normal_of(m) - normal_of(other)) > 1e-4) return true;
    if (m.count < other.count) return true;
    for (int k = 0; k < other.count && other.count == 2; ++k) {
        double nearest = 1e300;
        for (int l = 0; l < m.count; ++l)
            nearest = std::min(nearest, length(point_of(m, l) - point_of(other, k)) +
                                            std::fabs(separation_of(m, l) - separation_of(other, k)));
        if (nearest > 1e-3 * at.size) return true;
    }
    return false;
}

double any_scale(Random& random) {
    return std::array{1e-3, 0.1, 1.0, 1.0, 1000.0}[static_cast<std::size_t>(random.below(5))];
}

enum Lie {
    anyhow,
    over_face,
    tilted_on_face,
    on_edge,
    nearly_along_edge,
    over_corner,
    inside,
    standing,
    in_middle,
    lies
};

void add_pair(Random& random, Pairs& pairs, int lie) {
    const double scale = any_scale(random);
    const double other = random.below(4) == 0 ? scale * std::pow(10.0, random.uniform(-2, 2)) : scale;
    const double flat = random.below(8) == 0 ? 0.02 : 1; // a thin plate
    const Vec h = {other * random.uniform(0.1, 2), flat * other * random.uniform(0.1, 2),
                   other * random.uniform(0.1, 2)};
    const double r = scale * random.uniform(0.1, 1), half = random.below(16) == 0 ? 0 : scale * random.uniform(0.02, 3);
    const Vec place = (random.below(2) == 0 ? 1.0 : 1e5) * random.direction();
    const Quat q = random.rotation();
    const Frame f = frame_of(box(place, q, h));

    // In the frame of the box: the capsule's y axis along x, y or z.
    const double s = std::sqrt(0.5);
    const std::array<Quat, 3> turns = {Quat{0, 0, s, s}, no_rotation, Quat{s, 0, 0, s}};
    const std::size_t i = std::size_t(random.below(3)), j = (i + 1) % 3, k = (i + 2) % 3;
    const double small = std::pow(10.0, random.uniform(-9, -1));
    Quat turn = random.rotation();
    if (lie == on_edge || lie == standing || lie == in_middle) turn = turns[i];
    if (lie == tilted_on_face || lie == nearly_along_edge) turn = times(about(random.direction(), small), turns[i]);
    if (lie == over_face)
        turn =
            times(about({i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0, i == 0 ? 1.0 : 0.0}, random.uniform(0, 3)), turns[j]);
    const Vec u = axis_of(turn);
    const double gap = r * random.uniform(random.below(2) == 0 ? -0.5 : 0.85, 1.04);
    const double side = random.below(2) == 0 ? -1 : 1;

    Vec p = random.uniform(0, 1) * (length(h) + half + r) * random.direction(); // the center of the capsule
    const auto beside = [&](std::size_t e) { return random.uniform(-1.05, 1.05) * (h[e] + std::fabs(u[e]) * half); };
    if (lie == over_face || lie == tilted_on_face || lie == standing) {
        const std::size_t out = lie == standing ? i : lie == over_face ? i : j;
        for (std::size_t e = 0; e < 3; ++e) p[e] = e == out ? side * (h[e] + std::fabs(u[e]) * half + gap) : beside(e);
    }
    if (lie == on_edge || lie == nearly_along_edge) {
        const double angle = random.uniform(-0.1, 1.67);
        p[i] = beside(i), p[j] = side * (h[j] + gap * std::cos(angle)), p[k] = h[k] + gap * std::sin(angle);
    }
    if (lie == over_corner) {
        const Vec d = random.direction(), corner = {h[0], side * h[1], h[2]};
        p = corner + gap * d + (random.below(2) == 0 ? half : random.uniform(-1, 1) * half) * u;
    }
    if (lie == inside) {
        const Vec in = {random.uniform(-1, 1) * h[0], random.uniform(-1, 1) * h[1], random.uniform(-1, 1) * h[2]};
        p = in + random.uniform(-1, 1) * half * u;
    }
    if (lie == in_middle) p = {0, 0, 0};
    pairs.add(box(place, q, h), capsule(f.to_world(p), times(q, turn), r, half), float(random.below(2) * 0.05 * r));
}

} // namespace

TEST(CollideBoxCapsule, PushesApartByTheTrueDistance) {
    Random random(21);
    Pairs pairs;
    for (int i = 0; i < 120000; ++i) add_pair(random, pairs, i % lies);
    std::vector<Placed> placed;
    for (int i = 0; i < pairs.count(); ++i) placed.emplace_back(pairs.first(i), pairs.second(i));
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> manifolds = run(table->box_capsule, pairs);
        int touching = 0, doubles = 0, met = 0, wrong = 0;
        for (int i = 0; i < pairs.count(); ++i) {
            const Manifold& m = manifolds[static_cast<std::size_t>(i)];
            const Placed& at = placed[static_cast<std::size_t>(i)];
            touching += m.count > 0;
            doubles += m.count == 2;
            met += at.distance < 0;
            const std::string s = disagreement(at, pairs.margin(i), m);
            if (s.empty() || ++wrong > 5) continue;
            ADD_FAILURE() << table->name << ", pair " << i << " of kind " << i % lies << ": " << s << " (" << m.count
                          << " points, distance " << at.distance << ", separation " << at.separation << ", size "
                          << at.size << ", deepest " << deepest_of(m) << ", margin " << pairs.margin(i) << ")";
        }
        EXPECT_EQ(wrong, 0) << table->name;
        EXPECT_GT(touching, 70000) << table->name;
        EXPECT_GT(doubles, 25000) << table->name;
        EXPECT_GT(met, 20000) << table->name;
    }
}

// Compared where neither test prefers one feature to another.
TEST(CollideBoxCapsule, GivesThePointsOfTheConvexTest) {
    Random random(22);
    Pairs pairs;
    for (int i = 0; i < 60000; ++i) add_pair(random, pairs, i % lies);
    const std::vector<Manifold> manifolds = run(backends()[0]->box_capsule, pairs);
    int compared = 0, different = 0;
    for (int i = 0; i < pairs.count(); ++i) {
        const Manifold m = manifolds[static_cast<std::size_t>(i)], other = scalar_result(pairs, i, ShapeType::box);
        if (m.count == 0 || other.count == 0) continue;
        const Placed at(pairs.first(i), pairs.second(i));
        if (std::fabs(at.distance) < 1e-3 * at.size || at.extent < 1e-2 * at.size || i % lies == in_middle) continue;
        ++compared;
        different += falls_short(at, m, other);
    }
    EXPECT_GT(compared, 30000);
    EXPECT_LT(different, compared / 250);
}

// A capsule lying flat on a face, across its border, and at every angle around an edge, has two points; a standing one
// has one.
TEST(CollideBoxCapsule, LiesOnTwoPoints) {
    const ShapePose b = box({0, 0, 0}, no_rotation, {1, 0.5, 1});
    const double r = 0.1, half = 0.4, sunk = 0.001, s = std::sqrt(0.5);
    const Quat along_z = {s, 0, 0, s};
    for (const cairn::KernelTable* table : backends()) {
        const auto at = [&](const Vec& p, const Quat& q) {
            return run_one(table->box_capsule, b, capsule(p, q, r, half), 0.01f);
        };
        const Manifold over = at({0.3, 0.5 + r - sunk, 0.8}, along_z);
        ASSERT_EQ(over.count, 2) << table->name;
        EXPECT_EQ(over.normal[1], 1.0f);
        EXPECT_NEAR(std::max(over.points[0][2], over.points[1][2]), 1, 2e-4) << "where the face ends";
        EXPECT_NEAR(std::min(over.points[0][2], over.points[1][2]), 0.8 - half, 1e-5);
        for (int k = 0; k < 2; ++k) {
            EXPECT_NEAR(over.points[k][1], 0.5 - 0.5 * sunk, 1e-6) << "midway between the surfaces";
            EXPECT_NEAR(over.points[k][3], -sunk, 1e-6);
        }
        for (double angle = -0.1; angle < 1.68; angle += 1e-3) {
            const double turn = std::clamp(angle, 0.0, 0.5 * 3.14159265358979);
            const Vec n = {std::sin(turn), std::cos(turn), 0};
            const Vec beside = {angle < 0 ? 1 + angle : 1, turn < angle ? 0.5 + turn - angle : 0.5, 0};
            const Manifold m = at(beside + (r - sunk) * n, along_z);
            ASSERT_EQ(flaw(m, 0.01), "");
            ASSERT_EQ(m.count, 2) << table->name << ", " << angle << " around the edge";
            ASSERT_LT(length(normal_of(m) - n), 0.07) << "of a face that is about as good";
            ASSERT_NEAR(deepest_of(m), -sunk, 3e-4);
        }
        EXPECT_EQ(at({0.3, 0.5 + half + r - sunk, 0.2}, no_rotation).count, 1) << table->name;
    }
}
