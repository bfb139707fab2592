// The box-box kernel of every backend, compared with the double-precision reference.
#include "box_box_oracle.h"

#include <algorithm>
#include <string>

using namespace collide_test;

namespace {

struct SizeClass {
    const char* name;
    Vec first, second;
};
const SizeClass size_classes[] = {
    {"cube-cube", {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}},
    {"cube-small cube", {0.5, 0.5, 0.5}, {0.1, 0.1, 0.1}},
    {"slab-slab", {1.0, 0.05, 1.0}, {1.0, 0.05, 1.0}},
    {"needle-cube", {0.02, 0.9, 0.02}, {0.5, 0.5, 0.5}},
    {"slab-needle", {1.0, 0.05, 1.0}, {0.02, 0.9, 0.02}},
    {"anisotropic", {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, // random sizes
};

constexpr float usual_margin = 0.02f;

double smallest_half(const Frame& a, const Frame& b) {
    double r = 1e300;
    for (std::size_t i = 0; i < 3; ++i) r = std::min({r, a.half[i], b.half[i]});
    return r;
}
double sum_of_halves(const Frame& a, const Frame& b) {
    double r = 0;
    for (std::size_t i = 0; i < 3; ++i) r += a.half[i] + b.half[i];
    return r;
}

// Half of the pairs are at random distances, half are moved along their axis of greatest separation until they just
// touch, overlap a little or are a little apart, as in a simulation. `tilt` > 0 limits the relative rotation to that
// angle (nearly parallel edges and faces).
Pairs random_pairs(const SizeClass& size, int count, std::uint32_t seed, double tilt = 0) {
    Random random(seed);
    Pairs pairs;
    for (int i = 0; i < count; ++i) {
        Vec ha = size.first, hb = size.second;
        if (ha[0] == 0.0)
            for (std::size_t k = 0; k < 3; ++k) {
                ha[k] = random.uniform(0.05, 1.0);
                hb[k] = random.uniform(0.05, 1.0);
            }
        const Vec center = {random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-10, 10)};
        const Quat qa = tilt > 0 ? about(random.direction(), random.uniform(0, tilt)) : random.rotation();
        const Quat qb = tilt > 0 ? about(random.direction(), random.uniform(0, tilt)) : random.rotation();
        const double reach = 0.7 * (length(ha) + length(hb));
        Vec offset = random.uniform(0, reach) * random.direction();
        const ShapePose a = box(center, qa, ha);
        ShapePose b = box(center + offset, qb, hb);
        if (i % 2 == 1) {
            const SeparatingAxis axis = greatest_separation(frame_of(a), frame_of(b));
            const double depth =
                0.2 * std::min(*std::min_element(ha.begin(), ha.end()), *std::min_element(hb.begin(), hb.end()));
            offset = offset + (random.uniform(-depth, 1.5 * usual_margin) - axis.separation) * axis.normal;
            b = box(center + offset, qb, hb);
        }
        pairs.add(a, b, usual_margin);
    }
    return pairs;
}

// The kernel prefers a face to an edge that is less deep by up to 5 % of the smallest half extent, and uses nearly
// parallel edges only if their cross product is well defined; the error of that axis is rounding / sine.
struct Tolerance {
    double rounding, choice;
};
Tolerance tolerance_for(const Frame& a, const Frame& b, const SeparatingAxis& truth) {
    const double rounding = 2e-6 * sum_of_halves(a, b) / truth.sine;
    return {rounding, 5.5e-2 * smallest_half(a, b) + 2 * rounding};
}

bool is_face_of(const Frame& box, const Vec& n) {
    return std::any_of(box.axis.begin(), box.axis.end(),
                       [&](const Vec& axis) { return std::fabs(dot(axis, n)) > 1 - 1e-6; });
}

// Describes how the manifold contradicts the true axis; empty if it does not.
std::string disagreement(const Frame& a, const Frame& b, const Manifold& m, double margin) {
    if (std::string s = flaw(m, margin); !s.empty()) return s;
    const SeparatingAxis truth = greatest_separation(a, b);
    const Tolerance tolerance = tolerance_for(a, b, truth);
    if (reported_distance(m) > truth.separation + tolerance.rounding) return "apart by more than the truth";
    if (truth.separation > margin + tolerance.rounding) return m.count == 0 ? "" : "contact of boxes out of reach";
    if (m.count == 0) return truth.separation < -tolerance.rounding ? "no contact of boxes that overlap" : "";

    const Vec n = normal_of(m);
    const bool by_edges = truth.edges || (!is_face_of(a, n) && !is_face_of(b, n));
    const double deepest = deepest_of(m);
    if (deepest < truth.separation - tolerance.rounding) return "deeper than the truth";
    if (truth.separation < 0) {
        if (deepest > truth.separation + tolerance.choice) return "less deep than the truth";
        Frame moved = b;
        moved.center = b.center - (deepest - tolerance.choice) * n;
        if (greatest_separation(a, moved).separation < 0) return "moving by the depth does not separate";
    }
    for (int k = 0; k < m.count; ++k) {
        const Vec p = a.center + point_of(m, k);
        const double half_gap = separation_of(m, k) / 2;
        const double on_a = distance_to_box(a, p - half_gap * n), on_b = distance_to_box(b, p + half_gap * n);
        // Separated edges may also miss each other sideways, by a total distance within the margin.
        const double sideways = by_edges && half_gap > 0 ? std::sqrt(margin * margin / 4 - half_gap * half_gap) : 0.0;
        const double allowed = tolerance.choice + sideways + 2e-4 * std::max(length(a.half), length(b.half));
        if (std::fabs(on_a) > allowed || std::fabs(on_b) > allowed)
            return "point " + std::to_string(k) + " is " + std::to_string(on_a) + " and " + std::to_string(on_b) +
                   " m off the surfaces";
    }
    return {};
}

void expect_agreement(const char* name, const Pairs& pairs, int min_touching) {
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> manifolds = run(table->box_box, pairs);
        int wrong = 0, touching = 0, apart = 0;
        for (int i = 0; i < pairs.count(); ++i) {
            const Manifold& m = manifolds[static_cast<std::size_t>(i)];
            touching += m.count > 0;
            apart += reported_distance(m) > 0;
            const Frame a = frame_of(pairs.first(i)), b = frame_of(pairs.second(i));
            const std::string s = disagreement(a, b, m, pairs.margin(i));
            if (s.empty()) continue;
            if (++wrong > 5) continue;
            const SeparatingAxis truth = greatest_separation(a, b);
            ADD_FAILURE() << name << ", " << table->name << ", pair " << i << ": " << s << " (true separation "
                          << truth.separation << (truth.edges ? ", edges" : ", face") << "; count " << m.count
                          << ", deepest " << (m.count ? deepest_of(m) : 0.0) << ")";
        }
        EXPECT_EQ(wrong, 0) << name << ", " << table->name;
        EXPECT_GE(touching, min_touching) << name << ", " << table->name;
        EXPECT_GT(apart, 50) << name << ", " << table->name << ": the distance is known";
    }
}

} // namespace

TEST(CollideBoxBox, AgreesWithTheOracleForRandomPoses) {
    std::uint32_t seed = 1;
    for (const SizeClass& size : size_classes) expect_agreement(size.name, random_pairs(size, 6000, seed++), 2000);
}

TEST(CollideBoxBox, AgreesWithTheOracleForNearlyParallelBoxes) {
    std::uint32_t seed = 100;
    for (const SizeClass& size : size_classes)
        for (const double tilt : {1e-6, 1e-4, 1e-2, 0.1})
            expect_agreement(size.name, random_pairs(size, 2000, seed++, tilt), 600);
}

TEST(CollideBoxBox, FacePointsSpanTheTruePolygon) {
    std::uint32_t seed = 200;
    for (const cairn::KernelTable* table : backends())
        for (const SizeClass& size : size_classes) {
            const Pairs pairs = random_pairs(size, 4000, seed++, 0.02);
            const std::vector<Manifold> manifolds = run(table->box_box, pairs);
            int compared = 0, poor = 0, short_of_points = 0;
            double covered = 0;
            for (int i = 0; i < pairs.count(); ++i) {
                const Manifold& m = manifolds[static_cast<std::size_t>(i)];
                const Frame a = frame_of(pairs.first(i)), b = frame_of(pairs.second(i));
                if (m.count == 0) continue;
                const Vec normal = (1.0 / length(normal_of(m))) * normal_of(m);
                const FaceContact face = face_contact(a, b, normal, pairs.margin(i) - 1e-5);
                if (!face.is_face || face.polygon.size() < 3) continue;
                const double area = area_of(face.polygon);
                double across_squared = 0;
                for (const auto& p : face.polygon)
                    for (const auto& q : face.polygon)
                        across_squared =
                            std::max(across_squared, (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
                if (area < 0.01 * across_squared) continue; // a sliver, which two points describe well enough
                Polygon points;
                for (int k = 0; k < m.count; ++k) points.push_back(across(normal, a.center + point_of(m, k)));
                const double share = area_of(convex_hull(points)) / area;
                ++compared;
                covered += std::min(share, 1.0);
                poor += share < 0.45;
                short_of_points += m.count < std::min(static_cast<int>(face.polygon.size()), 4);
            }
            EXPECT_GT(compared, 300) << size.name;
            EXPECT_GT(covered / compared, 0.9) << size.name << ", " << table->name;
            EXPECT_LE(poor, compared / 200) << size.name << ", " << table->name;
            EXPECT_LE(short_of_points, compared / 50) << size.name << ", " << table->name;
        }
}

TEST(CollideBoxBox, StackedUnitBoxesKeepFourPoints) {
    const Vec half = {0.5, 0.5, 0.5};
    const Vec offsets[] = {{0, 1, 0},           {1e-6, 1, 0},  {-1e-6, 1, 1e-6}, {1e-6, 1 + 1e-6, -1e-6},
                           {0, 1 - 1e-6, 1e-6}, {0, 0.999, 0}, {0, 1.001, 0},    {1e-5, 0.9999, -2e-5}};
    const Quat rotations[] = {no_rotation,
                              about({0, 1, 0}, 1e-6),
                              about({0, 1, 0}, 1e-3),
                              about({1, 0, 0}, 1e-5),
                              about({0, 0, 1}, -1e-4),
                              about({0.6, 0, 0.8}, 1e-3),
                              about({0, 1, 0}, 0.02)};
    for (const cairn::KernelTable* table : backends())
        for (const Vec& offset : offsets)
            for (const Quat& q : rotations)
                for (const int up : {0, 1, 2}) {
                    const auto turn = [&](const Vec& v) {
                        return Vec{v[static_cast<std::size_t>((3 - up + 1) % 3)],
                                   v[static_cast<std::size_t>((3 - up + 2) % 3)],
                                   v[static_cast<std::size_t>((3 - up) % 3)]};
                    };
                    const Vec moved = turn(offset), axis = turn({0, 1, 0});
                    const Vec q_axis = turn({q[0], q[1], q[2]});
                    const Manifold m = run_one(table->box_box, box({0, 0, 0}, no_rotation, half),
                                               box(moved, {q_axis[0], q_axis[1], q_axis[2], q[3]}, half), usual_margin);
                    ASSERT_EQ(flaw(m, usual_margin), "");
                    ASSERT_EQ(m.count, 4) << table->name;
                    ASSERT_GT(dot(normal_of(m), axis), 1 - 1e-5 - 1e-6);
                    Polygon points;
                    for (int k = 0; k < 4; ++k) points.push_back(across(axis, point_of(m, k)));
                    ASSERT_GT(area_of(convex_hull(points)), 0.9) << table->name;
                }
}

TEST(CollideBoxBox, AlignedNormalIsTheAxis) {
    const Vec half = {0.5, 0.5, 0.5};
    for (const cairn::KernelTable* table : backends())
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const double side : {1.0, -1.0}) {
                Vec offset = {1e-6, -1e-6, 1e-6};
                offset[axis] = side * (1.0 - 1e-4);
                const Manifold m = run_one(table->box_box, box({3, 4, 5}, no_rotation, half),
                                           box(Vec{3, 4, 5} + offset, no_rotation, half), usual_margin);
                ASSERT_EQ(m.count, 4);
                for (std::size_t i = 0; i < 3; ++i)
                    EXPECT_NEAR(m.normal[i], i == axis ? side : 0.0, 1e-5) << table->name;
                for (int k = 0; k < 4; ++k) EXPECT_NEAR(m.points[k][3], -1e-4, 2e-6);
            }
}

TEST(CollideBoxBox, IdenticalPosesGiveAUnitNormal) {
    Random random(7);
    for (const cairn::KernelTable* table : backends())
        for (int i = 0; i < 200; ++i) {
            const Vec half = {random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)};
            const ShapePose a = box({1, 2, 3}, i == 0 ? no_rotation : random.rotation(), half);
            const Manifold same = run_one(table->box_box, a, a, usual_margin);
            ASSERT_EQ(flaw(same, usual_margin), "");
            ASSERT_EQ(same.count, 4);
            EXPECT_NEAR(deepest_of(same), -2 * *std::min_element(half.begin(), half.end()), 1e-3);
            const Manifold centered =
                run_one(table->box_box, a, box({1, 2, 3}, random.rotation(), {0.3, 0.2, 0.4}), usual_margin);
            ASSERT_EQ(flaw(centered, usual_margin), "");
            ASSERT_GT(centered.count, 0);
        }
}

TEST(CollideBoxBox, FarFromTheOriginNothingChanges) {
    Random random(11);
    for (const cairn::KernelTable* table : backends())
        for (int i = 0; i < 500; ++i) {
            // Offsets that are exact in double precision far from the origin, so that the near and the far pair are the
            // same.
            const auto grid = [&](double low, double high) {
                return std::floor(random.uniform(low, high) * 1048576.0) / 1048576.0;
            };
            const Vec offset = {grid(-1, 1), grid(-1, 1), grid(-1, 1)}, half = {0.5, 0.4, 0.6};
            const Quat qa = random.rotation(), qb = random.rotation();
            const Vec far = {1e7, -1e7 + 0.25, 1e7};
            const Manifold near_m =
                run_one(table->box_box, box({0, 0, 0}, qa, half), box(offset, qb, half), usual_margin);
            const Manifold far_m =
                run_one(table->box_box, box(far, qa, half), box(far + offset, qb, half), usual_margin);
            ASSERT_EQ(near_m.count, far_m.count);
            for (int k = 0; k < near_m.count; ++k)
                for (int c = 0; c < 4; ++c) ASSERT_NEAR(near_m.points[k][c], far_m.points[k][c], 1e-6);
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(near_m.normal[c], far_m.normal[c], 1e-6);
        }
}

TEST(CollideBoxBox, ExtremeSizesStayFinite) {
    Random random(13);
    Pairs pairs;
    const Vec halves[] = {{1e3, 1e-3, 1e3},   {1e-3, 1e3, 1e-3}, {1e-3, 1e-3, 1e-3}, {1e3, 1e3, 1e3},
                          {5e-4, 5e-4, 5e-4}, {1e-3, 1.0, 1e3},  {0.5, 0.5, 0.5}};
    for (const Vec& ha : halves)
        for (const Vec& hb : halves)
            for (int i = 0; i < 64; ++i) {
                const double reach = i % 4 == 0 ? 0.0 : random.uniform(0, 1) * (length(ha) + length(hb));
                const bool aligned = i % 3 == 0;
                pairs.add(box({0, 0, 0}, aligned ? no_rotation : random.rotation(), ha),
                          box(reach * random.direction(), aligned ? no_rotation : random.rotation(), hb),
                          i % 2 == 0 ? 0.0f : usual_margin);
            }
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> manifolds = run(table->box_box, pairs);
        for (int i = 0; i < pairs.count(); ++i)
            ASSERT_EQ(flaw(manifolds[static_cast<std::size_t>(i)], pairs.margin(i)), "")
                << table->name << ", pair " << i;
    }
}

TEST(CollideBoxBox, ScalesFromMillimetersToKilometers) {
    // The same scene in another unit of length gives the same manifold in that unit.
    const Pairs meters = random_pairs(size_classes[0], 2000, 17);
    for (const cairn::KernelTable* table : backends()) {
        const std::vector<Manifold> reference = run(table->box_box, meters);
        for (const float scale : {0x1p-10f, 0x1p+10f}) {
            Pairs scaled;
            for (int i = 0; i < meters.count(); ++i) {
                ShapePose a = meters.first(i), b = meters.second(i);
                for (ShapePose* p : {&a, &b})
                    for (std::size_t k = 0; k < 4; ++k) {
                        p->high[k] *= scale;
                        p->low[k] *= scale;
                        p->size[k] *= scale;
                    }
                scaled.add(a, b, usual_margin * scale);
            }
            const std::vector<Manifold> other = run(table->box_box, scaled);
            for (std::size_t i = 0; i < reference.size(); ++i) {
                ASSERT_EQ(reference[i].count, other[i].count) << i;
                for (int k = 0; k < reference[i].count; ++k)
                    for (int c = 0; c < 4; ++c) ASSERT_EQ(reference[i].points[k][c] * scale, other[i].points[k][c]);
            }
        }
    }
}

namespace {

// Two cubes face to face, overlapping by 1 mm. The upper one is rotated by 40 degrees, so that the clipped face has
// eight corners, and tilted by up to `tilt`.
Pairs turned_cubes(Random& random, double tilt) {
    const Vec half = {0.5, 0.5, 0.5};
    const Vec turn = {0, 0.7, 0}, tilted = turn + random.uniform(0, tilt) * random.direction();
    Pairs pairs;
    pairs.add(box({0, 0, 0}, about(random.direction(), random.uniform(0, tilt)), half),
              box({0, 0.999, 0}, about((1 / length(tilted)) * tilted, length(tilted)), half), usual_margin);
    return pairs;
}

std::array<std::uint32_t, 4> in_any_order(std::uint32_t features) {
    std::array<std::uint32_t, 4> sorted{};
    for (std::size_t k = 0; k < 4; ++k) sorted[k] = features >> (8 * k) & 255u;
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

// Twice the area of the polygon of contact points, projected along the normal.
double spanned(const Manifold& m) {
    double most = 0;
    for (int i = 0; i < m.count; ++i)
        for (int j = 0; j < m.count; ++j)
            for (int k = 0; k < m.count; ++k)
                for (int l = 0; l < m.count; ++l)
                    most = std::max(most, dot(cross(point_of(m, j) - point_of(m, i), point_of(m, l) - point_of(m, k)),
                                              normal_of(m)));
    return most;
}

} // namespace

// Contact points that are chosen afresh in each step follow tiny vibrations: 2,850 of 5,000 boxes in a heap never came
// to rest.
TEST(CollideBoxBox, PointsAndReferenceFaceStayThroughATremor) {
    for (const cairn::KernelTable* table : backends()) {
        Random random(19);
        std::uint32_t kept = kept_features(run(table->box_box, turned_cubes(random, 0))[0]);
        const auto first = in_any_order(kept);
        int fresh_changes = 0;
        for (int step = 0; step < 1000; ++step) {
            const Pairs pairs = turned_cubes(random, 1e-3);
            fresh_changes += in_any_order(kept_features(run(table->box_box, pairs)[0])) != first;
            kept = kept_features(run(table->box_box, pairs, {kept})[0]);
            ASSERT_EQ(in_any_order(kept), first) << table->name << ", step " << step;
        }
        EXPECT_GT(fresh_changes, 200) << table->name;
    }
}

TEST(CollideBoxBox, PointsAreChosenAfreshWhereTheOldOnesNoLongerServe) {
    for (const cairn::KernelTable* table : backends()) {
        Random random(23);
        const std::uint32_t first = kept_features(run(table->box_box, turned_cubes(random, 0))[0]);
        int changes = 0;
        for (int trial = 0; trial < 2000; ++trial) {
            const Pairs pairs = turned_cubes(random, 0.05);
            const Manifold fresh = run(table->box_box, pairs)[0], kept = run(table->box_box, pairs, {first})[0];
            ASSERT_EQ(flaw(kept, usual_margin), "") << table->name << ", trial " << trial;
            ASSERT_LE(deepest_of(kept), deepest_of(fresh) + 0.0051) << table->name << ", trial " << trial;
            changes += in_any_order(kept_features(kept)) != in_any_order(first);
            // With another face as reference other points are relevant.
            if ((kept.features[0] ^ fresh.features[0]) >> 4) continue;
            ASSERT_GE(spanned(kept), 0.69 * spanned(fresh)) << table->name << ", trial " << trial;
        }
        EXPECT_GT(changes, 500) << table->name;
        EXPECT_LT(changes, 2000) << table->name;
    }
}
