// Height fields with holes: a cell whose height is missing has no surface. A mesh of the remaining triangles must
// behave the same.
#include "chance.h"
#include "test_world.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace cairn::test {
namespace {

HeightField any_field(Chance& chance, float height) {
    const int columns = 2 + int(chance.below(10)), rows = 2 + int(chance.below(10));
    std::vector<float> heights(std::size_t(columns) * std::size_t(rows));
    const unsigned one_in = 2 + chance.below(8);
    for (float& h : heights) h = chance.below(one_in) == 0 ? HeightField::hole : chance.between(-height, height);
    for (const std::size_t corner : {std::size_t(0), std::size_t(1), std::size_t(columns), std::size_t(columns) + 1})
        heights[corner] = 0; // one cell is never a hole
    return HeightField(columns, rows, {chance.between(0.5f, 1.5f), chance.between(0.5f, 1.5f)}, heights);
}
Mesh mesh_of(const HeightField& field) {
    std::vector<Vec3> corners = field.vertices();
    for (Vec3& p : corners)
        if (p.y == HeightField::hole) p.y = 0; // no triangle uses this vertex
    return Mesh(corners, field.indices());
}
Shape any_solid(Chance& chance) {
    switch (chance.below(4)) {
    case 0:
        return Sphere{chance.between(0.05f, 0.4f)};
    case 1:
        return Box{{chance.between(0.05f, 0.4f), chance.between(0.05f, 0.4f), chance.between(0.05f, 0.4f)}};
    case 2:
        return Capsule{chance.between(0.05f, 0.4f), chance.between(0.05f, 0.3f), {}};
    default:
        return Cylinder{chance.between(0.05f, 0.4f), chance.between(0.05f, 0.3f), {}};
    }
}

// Two worlds with the same ground, as a height field and as a mesh.
struct Pair {
    World field, mesh;
    Pair(Chance& chance, float height) {
        const HeightField ground = any_field(chance, height);
        BodyDef def = body_at(Position(chance.in_box(20)), BodyType::static_);
        def.rotation = chance.rotation();
        frame_of_ground = {def.position, def.rotation};
        add_body(field, def, ground);
        add_body(mesh, def, mesh_of(ground));
    }
    Transform frame_of_ground;
    Position placed(const Vec3& p) const { return frame_of_ground.position + Position(frame_of_ground.rotation * p); }
};

TEST(FieldHoles, RaysMeetWhatAMeshOfTheirTrianglesHas) {
    Chance chance(1);
    int hits = 0, misses = 0;
    for (int i = 0; i < 200; ++i) {
        Pair worlds(chance, 1);
        for (int k = 0; k < 60; ++k) {
            const Position from = worlds.placed(chance.in_box(5)), to = worlds.placed(chance.in_box(3));
            const Vec3 way(to - from);
            const double far = 2.0 * glm::length(to - from);
            const auto a = worlds.field.cast_ray(from, way, far), b = worlds.mesh.cast_ray(from, way, far);
            ASSERT_EQ(a.has_value(), b.has_value()) << i << ", " << k;
            ++(a ? hits : misses);
            if (!a) continue;
            EXPECT_NEAR(a->distance, b->distance, 1e-5) << i << ", " << k;
            EXPECT_LT(glm::length(a->normal - b->normal), 1e-4f) << i << ", " << k;
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(misses, 2000);
}

TEST(FieldHoles, ShapesMeetWhatAMeshOfTheirTrianglesHas) {
    Chance chance(2);
    for (int i = 0; i < 200; ++i) {
        Pair worlds(chance, 0.6f);
        for (int k = 0; k < 30; ++k) {
            const Shape solid = any_solid(chance);
            const Transform at{worlds.placed(chance.in_box(3)), chance.rotation()};
            EXPECT_EQ(worlds.field.overlap(solid, at).size(), worlds.mesh.overlap(solid, at).size()) << i << ", " << k;
            const Vec3 way = 4.0f * chance.in_box(1);
            const auto a = worlds.field.cast_shape(solid, at, way), b = worlds.mesh.cast_shape(solid, at, way);
            ASSERT_EQ(a.has_value(), b.has_value()) << i << ", " << k;
            if (a) {
                EXPECT_NEAR(a->fraction, b->fraction, 1e-4) << i << ", " << k;
            }
            const auto p = worlds.field.closest_point(at.position, 3), q = worlds.mesh.closest_point(at.position, 3);
            ASSERT_EQ(p.has_value(), q.has_value()) << i << ", " << k;
            if (p) {
                EXPECT_NEAR(p->distance, q->distance, 1e-5) << i << ", " << k;
            }
        }
    }
}

// A body above the hole falls through it, a body beside it rests, and a rolling body falls in when it reaches the hole.
TEST(FieldHoles, ThingsFallThroughThemAndNowhereElse) {
    Chance chance(3);
    constexpr int side = 21; // cells of 0.5 m; the hole is 3 m by 3 m around the middle, to 1.5 m from it
    std::vector<float> heights(std::size_t(side) * side, 0.0f);
    for (int r = 8; r <= 12; ++r)
        for (int c = 8; c <= 12; ++c) heights[std::size_t(r * side + c)] = HeightField::hole;
    for (int i = 0; i < 60; ++i) {
        World world;
        add_body(world, body_at({0, 0, 0}, BodyType::static_), HeightField(side, side, {0.5f, 0.5f}, heights));
        const bool is_over = i % 2 == 0;
        Position at(chance.between(-4.3f, 4.3f), 0.8, chance.between(-4.3f, 4.3f));
        const double off = std::max(std::fabs(at.x), std::fabs(at.z));
        if (is_over ? off > 0.7 : off < 2.3) at *= (is_over ? 0.7 : 2.3) / off;
        at.y = 0.8;
        BodyDef def = body_at(at);
        def.rotation = chance.rotation();
        const Body body = world.body(add_body(world, def, any_solid(chance)));
        run(world, 90);
        if (is_over) {
            EXPECT_LT(body.position().y, -3) << i;
        } else {
            EXPECT_NEAR(body.position().y, 0.35, 0.35) << i;
        }
    }
    for (int i = 0; i < 24; ++i) {
        World world;
        add_body(world, body_at({0, 0, 0}, BodyType::static_), HeightField(side, side, {0.5f, 0.5f}, heights));
        const float angle = chance.between(0, float(2 * pi));
        const Vec3 out(std::cos(angle), 0, std::sin(angle));
        BodyDef def = body_at(Position(4.2f * out) + Position(0, 0.15, 0));
        def.linear_velocity = -3.0f * out;
        const Body ball = world.body(add_body(world, def, Sphere{0.15f}));
        for (int k = 0; k < 240 && ball.position().y > -0.5; ++k) world.step(frame);
        EXPECT_LT(ball.position().y, -0.5) << i;
        EXPECT_LT(std::max(std::fabs(ball.position().x), std::fabs(ball.position().z)), 1.5) << i;
    }
}

TEST(FieldHoles, AreNeitherNumbersThatAreNoneNorAll) {
    std::vector<float> heights(9, 0.0f);
    const auto make = [&] { return HeightField(3, 3, {1, 1}, heights); };
    // The hole touches all triangles except two, which the diagonals of their cells separate from it.
    heights[4] = HeightField::hole;
    const HeightField field = make();
    EXPECT_EQ(field.indices(), (std::vector<std::uint32_t>{1, 5, 2, 3, 6, 7}));
    EXPECT_EQ(field.vertices()[4], Vec3(0, HeightField::hole, 0));
    EXPECT_EQ(field.vertices()[8], Vec3(1, 0, 1));
    heights[4] = -HeightField::hole;
    EXPECT_THROW(make(), Error);
    heights[4] = not_a_number;
    EXPECT_THROW(make(), Error);
    heights.assign(9, HeightField::hole);
    EXPECT_THROW(make(), Error);
    heights[0] = heights[8] = 1; // two vertices with a height, but no triangle
    EXPECT_THROW(make(), Error);
}

} // namespace
} // namespace cairn::test
