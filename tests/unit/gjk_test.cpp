// Distance, depth and sweeps of convex shapes, compared with all pairs of features and all separating axes.
#include "convex_test_support.h"
#include "shapes/box_triangle_distance.h"
#include "shapes/convex_query.h"
#include "shapes/epa.h"
#include "shapes/gjk.h"

#include <gtest/gtest.h>

namespace {

using namespace convex_test;
using cairn::ClosestPoints;

// A polytope in the common frame, constructed without the code under test.
struct Polytope {
    std::vector<DVec3> corners;
    std::vector<std::vector<std::size_t>> faces;
};
Polytope polytope(const cairn::HullData& h, DVec3 center, DQuat q) {
    Polytope p;
    for (auto v : h.vertices) p.corners.push_back(center + rotate(q, cairn::math::to_double(v)));
    for (const auto& f : h.faces) {
        p.faces.emplace_back();
        for (std::uint32_t i = 0; i < f.count; ++i) p.faces.back().push_back(h.loops[f.first + i]);
    }
    return p;
}
double segment_distance(DVec3 p, DVec3 q, DVec3 r, DVec3 s) {
    const DVec3 u = q - p, v = s - r, w = p - r;
    const double a = dot(u, u), b = dot(u, v), c = dot(v, v), d = dot(u, w), e = dot(v, w), det = a * c - b * b;
    const auto unit = [](double t) { return std::clamp(t, 0.0, 1.0); };
    double best = 1e300;
    const auto offer = [&](double x, double y) { best = std::min(best, length(w + x * u - y * v)); };
    if (det > 1e-12 * a * c) {
        const double x = unit((b * e - c * d) / det), y = unit((b * x + e) / c);
        offer(unit((b * y - d) / a), y);
    }
    for (double x : {0.0, 1.0}) offer(x, unit((e + x * b) / c));
    for (double y : {0.0, 1.0}) offer(unit((y * b - d) / a), y);
    return best;
}
DVec3 normal_of(const Polytope& p, const std::vector<std::size_t>& f) {
    return normalized(cross(p.corners[f[1]] - p.corners[f[0]], p.corners[f[2]] - p.corners[f[0]]));
}
double separation(const Polytope& p, const Polytope& q, DVec3 n) {
    double hi = -1e300, lo = 1e300;
    for (DVec3 v : p.corners) hi = std::max(hi, dot(n, v));
    for (DVec3 v : q.corners) lo = std::min(lo, dot(n, v));
    return lo - hi;
}
// The distance if positive, otherwise minus the depth.
double brute_distance(const Polytope& p, const Polytope& q) {
    double axis = -1e300, least = 1e300;
    const auto faces = [&](const Polytope& a, const Polytope& b, double sign) {
        for (const auto& f : a.faces) {
            const DVec3 n = normal_of(a, f);
            axis = std::max(axis, separation(p, q, sign * n));
            for (DVec3 v : b.corners) {
                bool over = true;
                for (std::size_t i = 0; i < f.size(); ++i) {
                    const DVec3 from = a.corners[f[i]], to = a.corners[f[(i + 1) % f.size()]];
                    over = over && dot(cross(n, to - from), v - from) >= 0;
                }
                const double height = dot(n, v - a.corners[f[0]]);
                if (over && height > 0) least = std::min(least, height);
            }
        }
    };
    faces(p, q, 1);
    faces(q, p, -1);
    for (const auto& f : p.faces)
        for (std::size_t i = 0; i < f.size(); ++i)
            for (const auto& g : q.faces)
                for (std::size_t j = 0; j < g.size(); ++j) {
                    const DVec3 a = p.corners[f[i]], b = p.corners[f[(i + 1) % f.size()]];
                    const DVec3 c = q.corners[g[j]], d = q.corners[g[(j + 1) % g.size()]];
                    least = std::min(least, segment_distance(a, b, c, d));
                    const DVec3 n = cross(b - a, d - c);
                    if (length(n) < 1e-6 * length(b - a) * length(d - c)) continue;
                    axis = std::max({axis, separation(p, q, normalized(n)), separation(p, q, -normalized(n))});
                }
    return axis > 0 ? least : axis;
}

std::shared_ptr<const cairn::HullData> any_hull(Random& random) {
    const auto u = [&] { return random.uniform(0.2, 1); };
    switch (random.below(3)) {
    case 0:
        return tetrahedron(u());
    case 1:
        return box_hull({u(), u(), u()});
    default:
        return prism(3 + random.below(4), u(), u(), u());
    }
}

TEST(Gjk, DistanceAndDepthOfPolytopesAreThoseOfAllTheirFeatures) {
    Random random(1);
    int apart = 0, overlapping = 0;
    for (int k = 0; k < 4000; ++k) {
        const auto ha = any_hull(random), hb = any_hull(random);
        const DQuat qa = random.below(4) ? random.rotation() : DQuat{},
                    qb = random.below(4) ? random.rotation() : DQuat{};
        const DVec3 offset = random.uniform(0, 3) * random.direction();
        const Solid sa = hull(ha), sb = hull(hb);
        const ClosestPoints c = closest_points(sa.at({}, qa), sb.at(offset, qb));
        const double truth = brute_distance(polytope(*ha, {}, qa), polytope(*hb, offset, qb));
        EXPECT_NEAR(c.distance, truth, truth > 0 ? 1e-6 : 2e-4 * -truth + 1e-6) << k;
        EXPECT_NEAR(length(c.normal), 1, 1e-9);
        EXPECT_LT(length(c.on_b - c.on_a - c.distance * c.normal), 2e-3) << k << " " << truth;
        ++(truth > 0 ? apart : overlapping);
    }
    EXPECT_GT(apart, 1000);
    EXPECT_GT(overlapping, 1000);
}

TEST(Gjk, TheGuessDoesNotChangeTheDistance) {
    Random random(2);
    for (int k = 0; k < 5000; ++k) {
        const Solid sa = any_solid(random, 1), sb = any_solid(random, 1);
        const Convex a = sa.at({}, random.rotation()),
                     b = sb.at(random.uniform(1, 3) * random.direction(), random.rotation());
        const cairn::CorePair pair{exact_core(a), exact_core(b)};
        const auto cold = gjk_distance(pair, {}, 1e300), warm = gjk_distance(pair, random.direction(), 1e300);
        if (cold.state != warm.state) {
            EXPECT_LT(std::max(cold.distance, warm.distance), 1e-8) << k;
            continue;
        }
        EXPECT_NEAR(cold.distance, warm.distance, 1e-9 + 1e-6 * cold.distance) << k;
        // The state `far` is only reported for pairs that are farther apart than the limit.
        const auto far = gjk_distance(pair, {}, 0.5 * cold.distance);
        if (cold.distance > 1e-6) {
            EXPECT_EQ(far.state, cairn::GjkResult::State::far) << k;
            EXPECT_LE(far.distance, cold.distance * (1 + 1e-9));
            EXPECT_GE(far.distance, 0.5 * cold.distance);
        }
    }
}

TEST(Gjk, TheCornersOfTheLastResultDoNotChangeTheDistance) {
    Random random(3);
    int apart = 0;
    for (int k = 0; k < 5000; ++k) {
        const Solid sa = any_solid(random, 1), sb = any_solid(random, 1);
        const DQuat qa = random.rotation(), qb = random.rotation();
        const DVec3 place = random.uniform(1, 3) * random.direction();
        const Convex a = sa.at({}, qa), b = sb.at(place, qb);
        const auto before = cairn::gjk_distance({exact_core(a), exact_core(b)}, {}, 1e300);
        if (before.state != cairn::GjkResult::State::apart) continue;
        // Both shapes move, by a small or large amount; the cached simplex vertices move with them.
        const double far = std::pow(10.0, random.uniform(-6, 0));
        const DQuat ta = about(random.direction(), far * random.uniform(0, 2)),
                    tb = about(random.direction(), far * random.uniform(0, 2));
        const DVec3 way = far * random.direction();
        cairn::Simplex start = before.simplex;
        for (int i = 0; i < start.count; ++i) {
            cairn::DifferencePoint& p = start.points[i];
            p.a = rotate(ta, p.a), p.b = place + way + rotate(tb, p.b - place);
            p.w = p.a - p.b;
        }
        const Convex moved_a = sa.at({}, ta * qa), moved_b = sb.at(place + way, tb * qb);
        const cairn::CorePair pair{exact_core(moved_a), exact_core(moved_b)};
        const auto cold = gjk_distance(pair, {}, 1e300), warm = cairn::gjk_distance_from(pair, start, 1e300, 1e-12);
        if (cold.state != warm.state) {
            EXPECT_LT(std::max(cold.distance, warm.distance), 1e-8) << k;
            continue;
        }
        EXPECT_NEAR(cold.distance, warm.distance, 1e-9 + 1e-6 * cold.distance) << k;
        apart += warm.state == cairn::GjkResult::State::apart;
    }
    EXPECT_GT(apart, 3000);
}

TEST(Gjk, SimpleShapesHaveTheirKnownDistance) {
    const Solid two = ball(0.5), rod = capsule(1, 0.25), can = cylinder(1, 0.5), tip = cylinder(1, 0.5, 0),
                taper = capsule(1, 0.5, 0.25);
    EXPECT_NEAR(closest_points(two.at({}), two.at({3, 4, 0})).distance, 4, 1e-12);
    EXPECT_NEAR(closest_points(two.at({}), two.at({0.3, 0, 0})).distance, -0.7, 1e-12);
    EXPECT_NEAR(closest_points(rod.at({}), rod.at({0.5, 0, 2}, about({0, 0, 1}, 1.5707963267948966))).distance, 1.5,
                1e-9);
    EXPECT_NEAR(closest_points(can.at({}), two.at({2, 0.3, 0})).distance, 1, 1e-9);
    EXPECT_NEAR(closest_points(can.at({}), two.at({1.5, 2, 0})).distance, std::sqrt(2) - 0.5, 1e-6);
    EXPECT_NEAR(closest_points(tip.at({}), two.at({0, 2, 0})).distance, 0.5, 1e-9);
    EXPECT_NEAR(closest_points(taper.at({}), two.at({0, 2, 0})).distance, 0.25, 1e-9);
    EXPECT_NEAR(closest_points(taper.at({}), two.at({0, -2, 0})).distance, 0, 1e-9);
    EXPECT_NEAR(closest_points(can.at({}), can.at({0.9, 0, 0})).distance, -0.1, 1e-4);
}

// A point inside a shape, computed without the code under test.
DVec3 random_point_in(const Convex& c, Random& random) {
    // A point of a triangle between three support points.
    const DVec3 p = support(c, random.direction()), q = support(c, random.direction()),
                r = support(c, random.direction());
    const double s = random.uniform(0, 1), t = random.uniform(0, 1);
    const DVec3 inside = p + s * (q - p) + t * (r - (p + s * (q - p)));
    return middle(c) + 0.99 * (inside - middle(c)); // not a vertex
}

TEST(ConvexQuery, ContainsWhatIsBetweenPointsOfTheSurface) {
    Random random(3);
    for (int k = 0; k < 20000; ++k) {
        const Solid s = any_solid(random, 1);
        const Convex c = s.at(random.direction(), random.rotation());
        EXPECT_TRUE(contains(c, random_point_in(c, random))) << k;
        const DVec3 n = random.direction();
        EXPECT_FALSE(contains(c, support(c, n) + 1e-6 * n)) << k;
    }
}

TEST(ConvexQuery, RaysMeetTheSurfaceWhereTheShapeBegins) {
    Random random(4);
    int hits = 0;
    for (int k = 0; k < 5000; ++k) {
        const Solid s = any_solid(random, 1);
        const Convex c = s.at({}, random.rotation());
        const DVec3 origin = 5.0 * random.direction(), target = random_point_in(c, random);
        const auto hit = cast_ray(c, origin, 2.0 * (target - origin));
        ASSERT_TRUE(hit) << k;
        ++hits;
        EXPECT_FALSE(contains(c, hit->point + 2e-6 * hit->normal)) << k;
        EXPECT_TRUE(contains(c, hit->point - 2e-6 * hit->normal)) << k;
        EXPECT_LT(length(hit->point - (origin + (2 * hit->fraction) * (target - origin))), 2e-5) << k;
        EXPECT_LE(dot(hit->normal, target - origin), 0);
        // Away from the shape.
        EXPECT_FALSE(cast_ray(c, origin, origin)) << k;
        EXPECT_FALSE(cast_ray(c, target, target - origin)) << k;                                        // from inside
        EXPECT_FALSE(cast_ray(c, origin, 0.4 * (target - origin)) && length(target - origin) > 5) << k; // too short
    }
    EXPECT_EQ(hits, 5000);
}

// Without the fix 13 of 40,000 rays missed: they ended at sliver triangles along a rim, whose side was decided by an
// inaccurate normal.
TEST(ConvexQuery, NoRayMissesACylinder) {
    Random random(11);
    for (int k = 0; k < 40000; ++k) {
        const auto u = [&] { return random.uniform(0.2, 1); };
        const Solid s = cylinder(u(), u(), random.below(2) ? u() : 0);
        const Convex c = s.at({}, random.rotation());
        const DVec3 origin = 5.0 * random.direction(), target = random_point_in(c, random);
        const auto hit = cast_ray(c, origin, random.uniform(1, 4) * (target - origin));
        ASSERT_TRUE(hit) << k;
        EXPECT_LE(dot(hit->normal, target - origin), 0) << k;
    }
}

TEST(ConvexQuery, SweepsStopWhereTheShapesFirstTouch) {
    Random random(5);
    int hits = 0, misses = 0;
    for (int k = 0; k < 3000; ++k) {
        const Solid sa = any_solid(random, 0.5), sb = any_solid(random, 1);
        const DQuat qa = random.rotation();
        const DVec3 from = 4.0 * random.direction(), way = -1.5 * from + 2.0 * random.direction();
        const Convex a = sa.at(from, qa), b = sb.at({}, random.rotation());
        const auto hit = cast_convex(a, way, b);
        double least = 1e300; // over the whole path, by ternary search: the distance is convex
        double low = 0, high = 1;
        const auto distance = [&](double t) { return closest_points(sa.at(from + t * way, qa), b).distance; };
        for (int i = 0; i < 60; ++i) {
            const double m1 = low + (high - low) / 3, m2 = high - (high - low) / 3;
            const double d1 = distance(m1), d2 = distance(m2);
            least = std::min({least, d1, d2});
            if (d1 < d2 || (d1 < 0 && d2 < 0))
                high = m2;
            else
                low = m1;
        }
        if (!hit) {
            EXPECT_GT(least, -1e-6) << k;
            ++misses;
            continue;
        }
        ++hits;
        EXPECT_NEAR(distance(hit->fraction), 0, 1e-6) << k;
        EXPECT_GT(distance(0.99 * hit->fraction), 0) << k;
        EXPECT_LT(dot(hit->normal, way), 0);
    }
    EXPECT_GT(hits, 500);
    EXPECT_GT(misses, 500);
}

TEST(ConvexQuery, SweepsOfOverlappingShapesStopAtOnceAndThoseThatPartGoFree) {
    const Solid b = box(0.5, 0.5, 0.5), c = ball(0.5);
    const auto hit = cast_convex(c.at({0, 0.9, 0}), {0, -1, 0}, b.at({}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->fraction, 0);
    EXPECT_NEAR(hit->normal.y, 1, 1e-6);
    EXPECT_FALSE(cast_convex(c.at({0, 1, 0}), {0, 1, 0}, b.at({})));
    EXPECT_FALSE(cast_convex(c.at({0, 1.0001, 0}), {1, 0, 0}, b.at({})));
    EXPECT_TRUE(cast_convex(c.at({0, 1.0001, 0}), {1, -0.1, 0}, b.at({})));
}

TEST(ConvexQuery, NearestPointsAreThoseOfTheDistance) {
    Random random(7);
    int outside = 0, inside = 0, far = 0;
    for (int k = 0; k < 20000; ++k) {
        const Solid s = any_solid(random, 1);
        const Convex c = s.at(random.direction(), random.rotation());
        const DVec3 to = c.center + random.uniform(0, 3) * random.direction();
        Convex point;
        point.center = to;
        const double truth = closest_points(point, c).distance, most = random.uniform(0, 2);
        if (std::fabs(truth) < 1e-6 || std::fabs(truth - most) < 1e-6) continue;
        const auto nearest = cairn::nearest_point(c, to, most);
        ASSERT_EQ(nearest.has_value(), truth < most) << k;
        if (!nearest) {
            ++far;
            continue;
        }
        EXPECT_NEAR(nearest->distance, std::max(truth, 0.0), 1e-6) << k;
        EXPECT_NEAR(length(nearest->point - to), nearest->distance, 1e-9) << k;
        EXPECT_TRUE(truth > 0 || nearest->point == to) << k;
        EXPECT_TRUE(contains(c, nearest->point + 1e-6 * (middle(c) - nearest->point))) << k;
        ++(truth > 0 ? outside : inside);
    }
    EXPECT_GT(outside, 2000);
    EXPECT_GT(inside, 2000);
    EXPECT_GT(far, 2000);
}

// The polytope is on either side of the triangle, beside it, or intersects it.
TEST(ConvexQuery, OverlapsOfPolytopesWithTrianglesAreThoseOfAllSeparatingAxes) {
    Random random(8);
    int meeting = 0, apart = 0;
    for (int k = 0; k < 20000; ++k) {
        const auto h = any_hull(random);
        const DQuat q = random.rotation();
        const Solid solid = hull(h);
        const Polytope p = polytope(*h, {}, q);
        const DVec3 place = random.uniform(0, 2.5) * random.direction();
        Polytope triangle;
        for (int i = 0; i < 3; ++i) triangle.corners.push_back(place + random.uniform(0.1, 2) * random.direction());
        triangle.faces = {{0, 1, 2}, {0, 2, 1}};
        const std::vector<DVec3>& t = triangle.corners;
        if (length(cross(t[1] - t[0], t[2] - t[0])) < 1e-3) continue;
        const double truth = brute_distance(p, triangle);
        if (std::fabs(truth) < 1e-6) continue;
        ASSERT_EQ(overlap(solid.at({}, q), cairn::make_triangle(t[0], t[1], t[2])), truth < 0) << k << ' ' << truth;
        ++(truth < 0 ? meeting : apart);
    }
    EXPECT_GT(meeting, 3000);
    EXPECT_GT(apart, 3000);
}

TEST(BoxTriangleDistance, IsThatOfGjk) {
    Random random(6);
    int apart = 0, meeting = 0;
    for (int k = 0; k < 100000; ++k) {
        const DVec3 half{random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0.01, 1)};
        const DVec3 place = random.uniform(0, 2) * random.direction();
        const double size = random.uniform(0.05, 3);
        DVec3 corners[3];
        for (DVec3& c : corners) c = place + random.uniform(0, size) * random.direction();
        if (k % 5 == 0) corners[k % 3][k % 2] = half[k % 2]; // in the plane of a face
        if (k % 7 == 0) corners[1][2] = corners[2][2];       // an edge parallel to two faces
        if (length(cross(corners[1] - corners[0], corners[2] - corners[0])) < 1e-6) continue;
        const Convex a = box(half.x, half.y, half.z).at({}),
                     b = cairn::make_triangle(corners[0], corners[1], corners[2]);
        const cairn::CorePair pair{exact_core(a), exact_core(b)};
        const auto r = gjk_distance(pair, b.center, 1e30);
        DVec3 on_box, on_triangle;
        const bool is_apart = cairn::nearest_of_box_and_triangle(a.size, corners, on_box, on_triangle);
        if (r.state == cairn::GjkResult::State::apart && r.distance > 1e-7) {
            ASSERT_TRUE(is_apart) << k;
            ASSERT_NEAR(length(on_triangle - on_box), r.distance, 1e-9) << k;
            if (r.distance > 1e-3) {
                ASSERT_LT(length((1 / r.distance) * (on_triangle - on_box) - r.normal), 1e-5) << k;
            }
            ++apart;
        } else if (r.state == cairn::GjkResult::State::overlapping && epa_depth(pair, r.simplex).depth > 1e-7) {
            ASSERT_FALSE(is_apart) << k;
            ++meeting;
        }
    }
    EXPECT_GT(apart, 20000);
    EXPECT_GT(meeting, 20000);
}

} // namespace
