// The oracle of cores along motions, on cases with known results.
#include "bodies.h"
#include "oracle.h"

#include <gtest/gtest.h>

#include <array>

namespace cairn_test {
namespace {

Transform at(const Position& position, const Quat& rotation = {1, 0, 0, 0}) { return {position, rotation}; }
Quat turn_about_z(double angle) { return glm::angleAxis(float(angle), Vec3(0, 0, 1)); }
Moving still(const Shape& shape, const Transform& pose, double shrink = 0) { return {&shape, pose, pose, {}, shrink}; }

double distance(const Shape& a, const Transform& pose_a, const Shape& b, const Transform& pose_b) {
    return separation(make_core(a, 0).pieces[0], still(a, pose_a).at(0), make_core(b, 0).pieces[0],
                      still(b, pose_b).at(0));
}

TEST(CoreSeparation, IsThatOfClosedForms) {
    Random random(1);
    const Box box{{0.3f, 0.2f, 0.1f}};
    for (int i = 0; i < 300; ++i) {
        const Transform pose = at(0.5 * random.direction(), random.rotation());
        const Transform ball = at(random.between(0, 2) * random.direction());
        const glm::dquat rotation = glm::normalize(glm::dquat(pose.rotation));
        const Position local = glm::conjugate(rotation) * (ball.position - pose.position);
        const Position outside = glm::max(glm::abs(local) - Position(box.half_extents), Position(0));
        const double expected = std::max(0.0, glm::length(outside) - double(0.25f));
        EXPECT_NEAR(distance(box, pose, Sphere{0.25f}, ball), expected, 1e-7) << i;
        const double tall = std::max(0.0, std::fabs(local.y) - 0.5), flat = std::hypot(local.x, local.z);
        EXPECT_NEAR(distance(Capsule{0.5f, 0.125f, {}}, pose, Sphere{0.25f}, ball),
                    std::max(0.0, std::hypot(tall, flat) - 0.375), 1e-7)
            << i;
        EXPECT_NEAR(distance(Cylinder{0.5f, 0.125f}, pose, Sphere{0.25f}, ball),
                    std::max(0.0, std::hypot(tall, std::max(0.0, flat - 0.125)) - 0.25), 1e-7)
            << i;
    }
}

// Whether two boxes overlap, by the fifteen separating axes.
bool do_boxes_overlap(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
    std::array<glm::dvec3, 6> edges;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0);
        axis[i] = 1;
        edges[std::size_t(i)] = pose_a.rotation * axis;
        edges[std::size_t(3 + i)] = pose_b.rotation * axis;
    }
    const auto is_parted = [&](const glm::dvec3& axis) {
        double reach = 0;
        for (int i = 0; i < 3; ++i)
            reach += double(a.half_extents[i]) * std::fabs(glm::dot(axis, edges[std::size_t(i)])) +
                     double(b.half_extents[i]) * std::fabs(glm::dot(axis, edges[std::size_t(3 + i)]));
        return std::fabs(glm::dot(axis, pose_b.position - pose_a.position)) > reach;
    };
    for (const glm::dvec3& edge : edges)
        if (is_parted(edge)) return false;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 3; j < 6; ++j)
            if (is_parted(glm::cross(edges[i], edges[j]))) return false;
    return true;
}

TEST(CoreSeparation, IsNoneWhereBoxesOverlap) {
    Random random(2);
    int overlapping = 0;
    for (int i = 0; i < 2000; ++i) {
        const Box a{{0.3f, 0.2f, 0.1f}}, b{{0.1f, 0.4f, 0.05f}};
        const Transform pose_a = at({0, 0, 0}, random.rotation());
        const Transform pose_b = at(random.between(0.1, 0.7) * random.direction(), random.rotation());
        const Shape shape_a = a, shape_b = b;
        const bool is_overlap = do_boxes_overlap(a, still(shape_a, pose_a).at(0), b, still(shape_b, pose_b).at(0));
        EXPECT_EQ(distance(a, pose_a, b, pose_b) <= 0, is_overlap) << i;
        overlapping += is_overlap;
    }
    EXPECT_GT(overlapping, 200);
    EXPECT_LT(overlapping, 1800);
}

TEST(CoresMeet, WhereBallsDoWithinTheStep) {
    const Shape ball = Sphere{0.05f};
    // At the ends of the step their distance is 2 m along x, with an offset of 0.1 m.
    for (const double more : {-0.001, 0.001}) {
        const Position from(-1, 0.1 + more, 0), to(1, 0.1 + more, 0);
        EXPECT_EQ(cores_meet(ball, at(from), at(to), ball, at({0, 0, 0}), at({0, 0, 0}), 0), more < 0);
        EXPECT_FALSE(cores_meet(ball, at(from), at(to), ball, at({0, 0, 0}), at({0, 0, 0}), 0.001));
    }
    EXPECT_TRUE(cores_meet(ball, at({-1, 0.0975, 0}), at({1, 0.0975, 0}), ball, at({0, 0, 0}), at({0, 0, 0}), 0.001));
    // If both move, they meet in the middle.
    EXPECT_TRUE(cores_meet(ball, at({-1, 0, 0}), at({1, 0, 0}), ball, at({0, 1, 0}), at({0, -1, 0}), 0));
    EXPECT_FALSE(cores_meet(ball, at({-1, 0, 0}), at({1, 0, 0}), ball, at({0, 1, 0}), at({0, 0.2, 0}), 0));
    const Moving flying{&ball, at({-1, 0, 0}), at({1, 0, 0})};
    const auto time = cores_meet(flying, still(ball, at({0, 0, 0})));
    ASSERT_TRUE(time);
    EXPECT_NEAR(*time, 0.45, 1e-4);
}

TEST(CoresMeet, WhereARodTurnsThroughSomething) {
    const Shape rod = Box{{0.5f, 0.01f, 0.01f}}, ball = Sphere{0.02f};
    // The rod rotates by 90 degrees about its center, its end along an arc of 0.5 m: no overlap at the ends of the
    // step.
    const Transform from = at({0, 0, 0}), to = at({0, 0, 0}, turn_about_z(pi / 2));
    const auto place = [](double radius) { return at({radius * std::sqrt(0.5), radius * std::sqrt(0.5), 0}); };
    EXPECT_TRUE(cores_meet(rod, from, to, ball, place(0.45), place(0.45), 0.001));
    EXPECT_TRUE(cores_meet(rod, from, to, ball, place(0.517), place(0.517), 0.001));
    EXPECT_FALSE(cores_meet(rod, from, to, ball, place(0.523), place(0.523), 0.001));
    EXPECT_FALSE(cores_meet(rod, to, from, ball, at({-0.2, 0.2, 0}), at({-0.2, 0.2, 0}), 0.001));
    // The ball moves around with the rod, in front of it.
    EXPECT_FALSE(cores_meet(rod, from, at({0, 0, 0}, turn_about_z(0.5)), ball, place(0.4), at({0.1, 0.4, 0}), 0.001));
    // Rotation about one end: the other end moves twice as far, and reaches places that a rotation about the center
    // does not.
    const Moving swinging{&rod, at({0.5, 0, 0}), at({0, 0.5, 0}, turn_about_z(pi / 2)), {-0.5, 0, 0}, 0.001};
    EXPECT_TRUE(cores_meet(swinging, still(ball, place(0.95), 0.001)).has_value());
    EXPECT_FALSE(cores_meet(swinging, still(ball, place(1.05), 0.001)).has_value());
}

TEST(CoresMeet, SurfacesThatAreFlownThrough) {
    const Vec3 corners[] = {{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}, {1, 0, 1}};
    const std::uint32_t triangles[] = {0, 2, 3, 0, 3, 1};
    const float heights[] = {0, 0, 0, 0};
    const Shape surfaces[] = {Plane{}, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2(1, 1)}, Mesh(corners, triangles),
                              HeightField(2, 2, {2, 2}, heights), Box{{1, 0.005f, 1}}};
    const Shape bullets[] = {Sphere{0.01f}, Box{{0.01f, 0.01f, 0.01f}}, Capsule{0.01f, 0.01f, {}},
                             Cylinder{0.01f, 0.01f}, cone(0.01f, 0.01f)};
    for (const Shape& surface : surfaces)
        for (const Shape& bullet : bullets) {
            SCOPED_TRACE(testing::Message() << surface.index() << " " << bullet.index());
            const auto flies = [&](const Position& from, const Position& to, const Quat& end = {1, 0, 0, 0}) {
                const Moving moving{&bullet, at(from), at(to, end), {}, 0.001};
                return cores_meet(moving, still(surface, at({0, 0, 0}), 0.001)).has_value();
            };
            EXPECT_TRUE(flies({0.2, 7, 0.3}, {-0.1, -5, -0.2}));
            EXPECT_TRUE(flies({0.2, 7, 0.3}, {-0.1, -5, -0.2}, turn_about_z(2)));
            EXPECT_FALSE(flies({-1, 0.05, 0}, {1, 0.05, 0}, turn_about_z(2)));
            if (!std::holds_alternative<Plane>(surface) || std::get<Plane>(surface).half_extents) {
                EXPECT_FALSE(flies({1.2, 7, 0}, {1.2, -5, 0})); // beyond the edge
            }
        }
}

// A box given as a hull has the same core, and the same results.
TEST(CoresMeet, HullsAsTheBoxesThatTheyAre) {
    const Vec3 half(0.3f, 0.2f, 0.1f);
    std::vector<Vec3> corners;
    for (unsigned i = 0; i < 8; ++i) corners.push_back(half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    const Shape box = Box{half}, hull = Hull(corners), other = Cylinder{0.2f, 0.1f, 0.05f};
    EXPECT_NEAR(inner_radius(hull), inner_radius(box), 1e-7);
    Random random(3);
    int met = 0;
    for (int i = 0; i < 200; ++i) {
        const auto draw = [&](double far) { return at(far * random.direction(), random.rotation()); };
        const Transform from = draw(1), to = draw(1), from_other = draw(0.6), to_other = draw(0.6);
        const Moving as_box{&box, from, to, {}, 0.02}, as_hull{&hull, from, to, {}, 0.02};
        const Moving passing{&other, from_other, to_other, {0, 0.05, 0}, 0.01};
        const auto expected = cores_meet(as_box, passing), measured = cores_meet(as_hull, passing);
        EXPECT_EQ(expected.has_value(), measured.has_value()) << i;
        if (expected && measured) {
            EXPECT_NEAR(*expected, *measured, 1e-4) << i;
        }
        met += expected.has_value();
    }
    EXPECT_GT(met, 20);
    EXPECT_LT(met, 180);
}

// The search by bisection agrees with dense sampling.
TEST(CoresMeet, AsManyLooksSay) {
    const Shape a = cone(0.2f, 0.3f), b = Box{{0.05f, 0.4f, 0.05f}, 0.02f};
    const CorePiece core_a = make_core(a, 0.01).pieces[0], core_b = make_core(b, 0.01).pieces[0];
    Random random(4);
    int met = 0;
    for (int i = 0; i < 200; ++i) {
        const auto draw = [&](double far) { return at(far * random.direction(), random.rotation()); };
        const Moving moving{&a, draw(1), draw(1), {0, -0.1, 0}, 0.01}, other{&b, draw(0.7), draw(0.7), {}, 0.01};
        double least = 1;
        for (int k = 0; k <= 300; ++k)
            least = std::min(least, separation(core_a, moving.at(k / 300.0), core_b, other.at(k / 300.0)));
        const bool is_met = cores_meet(moving, other).has_value();
        // Between two samples they approach by 2 cm at most.
        if (least <= 0) {
            EXPECT_TRUE(is_met) << i;
        }
        if (least > 0.02) {
            EXPECT_FALSE(is_met) << i;
        }
        met += is_met;
    }
    EXPECT_GT(met, 20);
    EXPECT_LT(met, 180);
}

TEST(Core, EndsInsideOfTheShape) {
    // The inscribed ball of a cone touches base and side; the core vanishes when the inset is its radius.
    const Shape sharp = cone(0.3f, 0.2f);
    const double radius = 0.3 * 0.4 / (0.3 + 0.5);
    EXPECT_NEAR(inner_radius(sharp), radius, 1e-7);
    EXPECT_EQ(make_core(sharp, radius + 1e-6).pieces.size(), 0u);
    const Core last = make_core(sharp, radius - 1e-6);
    ASSERT_EQ(last.pieces.size(), 1u);
    EXPECT_LT(last.reach_from({0, radius - 0.2, 0}), 1e-5);
    // The inset of a rounded shape first reduces its rounding.
    const Core rounded = make_core(Box{{0.1f, 0.1f, 0.1f}, 0.05f}, 0.02);
    EXPECT_NEAR(rounded.pieces[0].rounding, 0.03, 1e-7);
    EXPECT_NEAR(rounded.pieces[0].support({1, 0, 0}).x, 0.13, 1e-7);
    EXPECT_NEAR(make_core(Box{{0.1f, 0.1f, 0.1f}, 0.05f}, 0.06).pieces[0].support({1, 0, 0}).x, 0.09, 1e-7);
    EXPECT_TRUE(make_core(Sphere{0.001f}, 0.0011).pieces.empty());
}

} // namespace
} // namespace cairn_test
