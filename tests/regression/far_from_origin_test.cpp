// gcc 12 with -ftree-slp-vectorize folds `float(x - double(float(x)))` to zero: a shape far from the origin lost the
// low part of its position, and was rounded to a grid of one meter (at 1e7 m). Therefore -fno-tree-slp-vectorize is
// set.
#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace {

using namespace cairn;

// Two balls at a given place: one on the other without gravity, or rolling side by side on a box.
struct Balls {
    World world;
    BodyId first, second;
    Position origin;

    Balls(const Position& origin_, const WorldDef& settings) : world(settings), origin(origin_) {}

    BodyId add(const Shape& shape, const Position& at, BodyType type, const Vec3& velocity = {0, 0, 0}) {
        BodyDef def;
        def.type = type;
        def.position = origin + at;
        def.linear_velocity = velocity;
        const BodyId body = world.create_body(def);
        world.add_shape(body, shape);
        return body;
    }
    float separation() {
        const std::vector<Contact> contacts = world.contacts();
        for (const Contact& contact : contacts)
            if ((contact.body_a == first && contact.body_b == second) ||
                (contact.body_a == second && contact.body_b == first))
                return contact.points[0].separation;
        return 1e9f;
    }
};

const Position far_away{1e7 + 0.3, 5e6 + 0.1, -2e6 - 0.7};

TEST(FarFromTheOrigin, RestingBallTouchesAsAtTheOrigin) {
    Balls near({0, 0, 0}, {}), far(far_away, {});
    for (Balls* balls : {&near, &far}) {
        balls->first = balls->add(Sphere{0.5f}, {0, 0, 0}, BodyType::static_);
        balls->second = balls->add(Sphere{0.5f}, {0, 1, 0}, BodyType::dynamic);
    }
    for (int i = 0; i < 120; ++i) {
        near.world.step(1.0f / 60);
        far.world.step(1.0f / 60);
        ASSERT_NEAR(far.separation(), near.separation(), 1e-6f) << "step " << i;
        ASSERT_LT(near.separation(), 1e-4f);
    }
}

TEST(FarFromTheOrigin, RollingBallsCollideAsAtTheOrigin) {
    Balls near({0, 0, 0}, {}), far(far_away, {});
    for (Balls* balls : {&near, &far}) {
        balls->add(Box{{5, 0.5f, 5}}, {0, -0.5, 0}, BodyType::static_);
        balls->first = balls->add(Sphere{0.5f}, {0.1, 0.5, 0.05}, BodyType::dynamic);
        balls->second = balls->add(Sphere{0.5f}, {-0.92, 0.5, -0.05}, BodyType::dynamic, {0.6f, 0, 0});
    }
    bool touched = false;
    for (int i = 0; i < 120; ++i) {
        near.world.step(1.0f / 60);
        far.world.step(1.0f / 60);
        touched |= near.separation() < 1e-3f;
        if (near.separation() < 0.01f && i < 30) { // later, rounding errors have accumulated
            // The time of impact is found to a fraction of the tolerance of 0.1 mm.
            ASSERT_NEAR(far.separation(), near.separation(), 5e-6f) << "step " << i;
        }
        for (const auto& [a, b] : {std::pair{near.first, far.first}, std::pair{near.second, far.second}}) {
            const Position p = near.world.body(a).position(), q = far.world.body(b).position() - far.origin;
            ASSERT_LT(glm::length(p - q), 5e-5) << "step " << i;
        }
    }
    EXPECT_TRUE(touched);
}

} // namespace
