// Shape casts through a world, compared with conservative advancement towards each of its shapes in turn.
#include "cast_test_support.h"

#include <cairn/world.h>

#include <gtest/gtest.h>

namespace {

using namespace convex_test;
using cairn::Shape;

cairn::Quat any_rotation(Random& random) {
    const DQuat q = random.rotation();
    return {float(q.w), float(q.x), float(q.y), float(q.z)};
}
Shape any_shape(Random& random) {
    const auto u = [&] { return float(random.uniform(0.15, 0.6)); };
    std::vector<cairn::Vec3> points;
    switch (random.below(9)) {
    case 0:
        return cairn::Sphere{u()};
    case 1:
        return cairn::Box{{u(), u(), u()}};
    case 2:
        return cairn::Box{{u(), u(), u()}, 0.1f};
    case 3:
        return cairn::Capsule{u(), u()};
    case 4:
        return cairn::Capsule{u(), u(), u()};
    case 5:
        return cairn::Cylinder{u(), u()};
    case 6:
        return cairn::Cylinder{u(), u(), random.below(2) ? u() : 0.0f};
    case 7:
        return cairn::Cylinder{u(), u(), {}, 0.1f};
    default:
        for (int i = 0; i < 14; ++i) {
            const DVec3 p = 0.6 * random.direction();
            points.push_back({float(p.x), float(p.y), float(p.z)});
        }
        return cairn::Hull(points);
    }
}

struct Item {
    Solid solid;
    DVec3 at;
    DQuat turn;
    cairn::ShapeId id;
    Convex posed(DVec3 by = {}) const { return solid.at(at + by, turn); }
};
Item make_item(const Shape& shape, cairn::Position at, cairn::Quat q) {
    return {solid(shape), {at.x, at.y, at.z}, normalized(DQuat{q.x, q.y, q.z, q.w}), {}};
}

// The first contact of the moving shape with a static one, with the separating direction there.
struct Meeting {
    double fraction;
    DVec3 normal;
    double depth; // initial penetration depth
};
std::optional<Meeting> advance(const Item& moving, DVec3 way, const Convex& still, double tolerance) {
    double fraction = 0;
    for (int round = 0; round < 1000; ++round) {
        const auto c = closest_points(moving.posed(fraction * way), still);
        if (fraction == 0 && c.distance < -tolerance) return Meeting{0, -c.normal, -c.distance};
        const double speed = dot(way, c.normal);
        if (!(speed > 0)) return std::nullopt;
        if (c.distance <= tolerance) return Meeting{fraction, -c.normal, 0};
        fraction += (c.distance - 0.5 * tolerance) / speed;
        if (fraction > 1) return std::nullopt;
    }
    return std::nullopt;
}

void check_cast(const Item& moving, DVec3 way, const std::vector<Item>& items,
                const std::optional<cairn::ShapeCastHit>& hit, int (&count)[3]) {
    constexpr double tolerance = 6e-7, near = 3e-6;
    double first = 2;
    for (const Item& item : items) {
        const auto met = advance(moving, way, item.posed(), tolerance);
        if (met && met->fraction < first) first = met->fraction;
    }
    if (!hit) {
        ++count[0];
        if (first > 1) return;
        // A result may differ only where the shape passes another within rounding.
        const Item past{moving.solid, moving.at + first * way, moving.turn, {}};
        double speed = length(way);
        for (const Item& item : items) {
            const auto c = closest_points(past.posed(), item.posed());
            if (c.distance < near) speed = std::min(speed, std::fabs(dot(c.normal, way)));
        }
        EXPECT_LT(speed, 1e-2 * length(way));
        return;
    }
    ++count[hit->fraction > 0 ? 1 : 2];
    ASSERT_LE(hit->fraction, 1);
    const auto met = std::find_if(items.begin(), items.end(), [&](const Item& i) { return i.id == hit->shape; });
    ASSERT_NE(met, items.end());
    const Convex still = met->posed(), there = moving.posed(hit->fraction * way);
    const DVec3 normal{hit->normal.x, hit->normal.y, hit->normal.z}, point{hit->point.x, hit->point.y, hit->point.z};
    EXPECT_NEAR(length(normal), 1, 1e-6);
    if (hit->fraction == 0) {
        // Among all shapes that overlap at the start, the result is the one that was created first, with the minimal
        // separating translation and a point at its end.
        EXPECT_EQ(first, 0);
        for (const Item& item : items) {
            if (item.id == hit->shape) break;
            EXPECT_GT(closest_points(there, item.posed()).distance, -near);
        }
        const double least = -closest_points(there, still).distance;
        const double depth = dot(support(still, normal) - support(there, -normal), normal);
        EXPECT_LT(depth, least * (1 + 1.1e-4) + near);
        EXPECT_TRUE(nearest_point(still, point, 1e-3));
        EXPECT_TRUE(nearest_point(moved(there, depth * normal), point, 1e-3));
        return;
    }
    // No shape is hit earlier, and at the reported fraction the shapes touch at the point, whose plane separates them.
    const double steep = -dot(normal, way);
    EXPECT_GT(steep, 0);
    EXPECT_LT(hit->fraction * steep, first * steep + near);
    if (first < hit->fraction) { // the same hit, or one that was passed within rounding
        EXPECT_LT((hit->fraction - first) * steep, near + 1e-2 * length(way) * (hit->fraction - first));
    }
    EXPECT_NEAR(closest_points(there, still).distance, 0, near);
    EXPECT_NEAR(dot(support(still, normal) - point, normal), 0, near);
    EXPECT_NEAR(dot(support(there, -normal) - point, normal), 0, near);
}

TEST(ShapeCastSearch, FindsWhatAdvancingPastEachShapeFinds) {
    int count[3] = {};
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Random random(seed);
        cairn::World world;
        std::vector<Item> items;
        for (int i = 0; i < 24; ++i) {
            const Shape shape = any_shape(random);
            const cairn::Position at(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
            cairn::BodyDef body;
            body.type = i % 3 == 0 ? cairn::BodyType::static_ : cairn::BodyType::dynamic;
            body.position = at, body.rotation = any_rotation(random);
            items.push_back(make_item(shape, at, body.rotation));
            items.back().id = world.add_shape(world.create_body(body), shape);
        }
        for (int k = 0; k < 2400; ++k) {
            const Shape shape = k % 2 == 0 ? Shape(cairn::Box{{0.25f, 0.2f, 0.3f}}) : any_shape(random);
            const cairn::Position at(random.uniform(-3.5, 3.5), random.uniform(-3.5, 3.5), random.uniform(-3.5, 3.5));
            const cairn::Quat turn = any_rotation(random);
            const DVec3 way = random.uniform(0.1, 8) * random.direction();
            const cairn::Vec3 translation(float(way.x), float(way.y), float(way.z));
            const auto hit = world.cast_shape(shape, {at, turn}, translation);
            const DVec3 asked{translation.x, translation.y, translation.z};
            check_cast(make_item(shape, at, turn), asked, items, hit, count);
            ASSERT_FALSE(::testing::Test::HasFailure()) << seed << ' ' << k;
        }
    }
    EXPECT_GT(count[0], 3000); // missed everything
    EXPECT_GT(count[1], 3000); // hit on the path
    EXPECT_GT(count[2], 3000); // overlapping from the start
}

} // namespace
