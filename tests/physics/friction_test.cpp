// Boxes that stick, slide, tip and spin (rows 10, 11, 12 and 24 of docs/validation.md).
#include "support.h"

namespace cairn_test {
namespace {

class Friction : public EveryStep {
  protected:
    struct OnSlope {
        World world;
        Slope slope;
        BodyId box;
        Position start;

        OnSlope(double degrees, float friction, Vec3 half_extents = {0.5f, 0.5f, 0.5f})
            : world(without_sleep()), slope{radians(degrees)} {
            slope.add_to(world, surface(friction));
            BodyDef def;
            def.position = double(half_extents.y) * slope.normal();
            def.rotation = slope.rotation();
            start = def.position;
            box = add_body(world, Box{half_extents}, def, surface(friction));
        }
        double way() { return glm::dot(world.body(box).position() - start, slope.downhill()); }
        double speed() { return glm::dot(glm::dvec3(world.body(box).linear_velocity()), slope.downhill()); }
        double tilt() { // of the box against the slope, radians
            const glm::dvec3 up = glm::dvec3(world.body(box).rotation() * Vec3(0, 1, 0));
            return std::acos(std::min(1.0, glm::dot(up, slope.normal())));
        }
    };
};
CAIRN_AT_EVERY_STEP(Friction);

TEST_P(Friction, BoxOnASlopeSticksUpToTheFrictionAngle) {
    const float friction = float(std::tan(radians(30)));
    OnSlope below(29.5, friction), above(30.5, friction);
    run(above.world, dt(), steps_in(2));
    EXPECT_GT(above.way(), 0.1); // 0.2 m in theory
    // Creep: after it has settled, less than 1 mm in a minute.
    run(below.world, dt(), steps_in(1));
    EXPECT_LT(std::abs(below.way()), 0.001);
    const double settled = below.way(), seconds = GetParam() == 60 ? 60 : 10;
    run(below.world, dt(), steps_in(seconds));
    EXPECT_LT(std::abs(below.way() - settled), 0.001 * seconds / 60);
}

TEST_P(Friction, BoxSlidesDownASlopeAtTheCoulombRate) {
    OnSlope scene(30, 0.2f);
    run(scene.world, dt(), steps_in(0.25));
    const double v = scene.speed();
    run(scene.world, dt(), steps_in(1));
    EXPECT_NEAR((scene.speed() - v) / (steps_in(1) * double(dt())) / 3.20586, 1, 0.01);
}

TEST_P(Friction, CubeTipsOverBeyondFortyFiveDegrees) {
    OnSlope below(44.5, 2.0f), above(45.5, 2.0f);
    run(below.world, dt(), steps_in(5));
    run(above.world, dt(), steps_in(5));
    EXPECT_LT(below.tilt(), radians(0.5));
    EXPECT_GT(above.tilt(), radians(30));
}

TEST_P(Friction, BoxSlidesToAStopInTheSameWayForEveryHeading) {
    struct Case {
        float friction;
        double way;
    };
    for (const Case& c : {Case{0.2f, 1.01937}, Case{0.4f, 0.50968}, Case{0.7f, 0.29125}}) {
        double least = 1e9, most = 0;
        for (int heading = 0; heading < 360; heading += 15) {
            const glm::dvec3 along{std::cos(radians(heading)), 0, std::sin(radians(heading))};
            World world;
            add_ground(world, surface(c.friction));
            BodyDef def;
            def.position = {0, 0.25, 0};
            def.linear_velocity = Vec3(2.0 * along);
            const BodyId box = add_body(world, Box{{0.5f, 0.25f, 0.5f}}, def, surface(c.friction));
            run(world, dt(), steps_in(1.5));
            EXPECT_LT(glm::length(world.body(box).linear_velocity()), 1e-3f);
            const double way = glm::dot(world.body(box).position(), along);
            least = std::min(least, way);
            most = std::max(most, way);
            EXPECT_NEAR(way / c.way, 1, 0.01) << "heading " << heading << ", friction " << c.friction;
        }
        EXPECT_LT((most - least) / c.way, 0.001) << "friction " << c.friction;
    }
}

TEST_P(Friction, SpinningBoxSlidesAsFarAsCoulombFrictionAtItsCornersAllows) {
    for (const double heading : {0.0, 30.0, 45.0, 90.0}) {
        const glm::dvec3 along{std::cos(radians(heading)), 0, std::sin(radians(heading))};
        World world;
        add_ground(world, surface(0.4f));
        BodyDef def;
        def.position = {0, 0.25, 0};
        def.linear_velocity = Vec3(3.0 * along);
        def.angular_velocity = {0, 6, 0};
        const BodyId box = add_body(world, Box{{0.5f, 0.25f, 0.5f}}, def, surface(0.4f));
        double stopped = 0;
        for (int i = 1; i <= steps_in(2); ++i) {
            world.step(dt());
            if (glm::length(world.body(box).linear_velocity()) > 0.01f) stopped = i * double(dt());
        }
        EXPECT_NEAR(glm::dot(world.body(box).position(), along) / 1.543, 1, 0.1) << "heading " << heading;
        EXPECT_NEAR(stopped / 0.918, 1, 0.1) << "heading " << heading;
    }
}

} // namespace
} // namespace cairn_test
