// A closed system keeps its momentum and angular momentum, whatever happens inside (row 19 of docs/validation.md).
#include "support.h"

#include <random>

namespace cairn_test {
namespace {

struct Momenta {
    glm::dvec3 linear, angular;
    double linear_scale = 0, angular_scale = 0; // sums of the bodies' own, what the errors are relative to
};

Momenta momenta(World& world) {
    Momenta m{world.linear_momentum(), world.angular_momentum()};
    for (const BodyId id : world.bodies()) {
        const Body body = world.body(id);
        const glm::dvec3 p = double(body.mass()) * glm::dvec3(body.linear_velocity());
        m.linear_scale += glm::length(p);
        m.angular_scale +=
            glm::length(glm::cross(body.center_of_mass(), p)) + double(glm::length(body.angular_momentum()));
    }
    return m;
}

class ClosedSystem : public EveryStep {
  protected:
    // As many steps at each length of step: what is left is rounding, which grows with their number.
    static constexpr int steps = 120;
    void expect_constant(World& world, const std::string& what) {
        const Momenta start = momenta(world);
        double linear = 0, angular = 0;
        bool touched = false;
        for (int i = 0; i < steps; ++i) {
            world.step(dt());
            const Momenta now = momenta(world);
            linear = std::max(linear, glm::length(now.linear - start.linear) / start.linear_scale);
            angular = std::max(angular, glm::length(now.angular - start.angular) / start.angular_scale);
            touched |= !world.contacts().empty();
        }
        EXPECT_TRUE(touched) << what;
        EXPECT_LE(linear, 1e-5) << what;
        EXPECT_LE(angular, 1e-5) << what;
    }
    struct Case {
        float restitution, friction;
    };
    static constexpr Case cases[] = {{0, 0}, {0, 0.6f}, {0.5f, 0.6f}, {1, 0}, {1, 1}};
};
CAIRN_AT_EVERY_STEP(ClosedSystem);

TEST_P(ClosedSystem, ColliderOfMixedBodiesKeepsItsMomenta) {
    for (const Case& c : cases) {
        World world{without_gravity()};
        std::mt19937 random{7};
        auto number = [&random] { return float(random() % 20001) / 10000.0f - 1; };
        for (int i = 0; i < 48; ++i) {
            // On three shells, all on their way inwards with some turning about.
            const Vec3 out = glm::normalize(Vec3(number(), number(), number()));
            BodyDef def;
            def.position = Position(float(3 + i % 3 * 2) * out);
            def.linear_velocity = -3.0f * out + 0.5f * Vec3(number(), number(), number());
            def.angular_velocity = 2.0f * Vec3(number(), number(), number());
            def.mass = 1.0f + float(i % 4);
            const Material material = surface(c.friction, c.restitution);
            if (i % 2 == 0)
                add_body(world, Sphere{0.4f}, def, material);
            else
                add_body(world, Box{{0.5f, 0.3f, 0.4f}}, def, material);
        }
        expect_constant(world,
                        "restitution " + std::to_string(c.restitution) + ", friction " + std::to_string(c.friction));
    }
}

// A box of six walls, slowly turning, with 27 balls and boxes in it that fly about.
void fill_box(World& world, const Material& material) {
    BodyDef def;
    def.angular_velocity = {0.3f, 0.5f, 0.2f};
    def.mass = 20.0f;
    const BodyId shell = world.create_body(def);
    for (int side = 0; side < 6; ++side) {
        ShapeDef wall;
        Vec3 half(1.6f);
        half[side / 2] = 0.1f;
        wall.position[side / 2] = side % 2 == 0 ? -1.5f : 1.5f;
        wall.material = material;
        world.add_shape(shell, Box{half}, wall);
    }
    std::mt19937 random{3};
    auto number = [&random] { return float(random() % 20001) / 10000.0f - 1; };
    for (int i = 0; i < 27; ++i) {
        BodyDef inside;
        inside.position = {0.8 * (i % 3 - 1), 0.8 * (i / 3 % 3 - 1), 0.8 * (i / 9 - 1)};
        inside.linear_velocity = 3.0f * Vec3(number(), number(), number());
        inside.mass = 1.0f;
        if (i % 2 == 0)
            add_body(world, Sphere{0.3f}, inside, material);
        else
            add_body(world, Box{{0.25f, 0.3f, 0.2f}}, inside, material);
    }
}

TEST_P(ClosedSystem, BoxFullOfBallsAndBoxesKeepsItsMomenta) {
    for (const Case& c : cases) {
        World world{without_gravity()};
        fill_box(world, surface(c.friction, c.restitution));
        expect_constant(world,
                        "restitution " + std::to_string(c.restitution) + ", friction " + std::to_string(c.friction));
    }
}

// Impulses that acted where the bodies were at the start of the substep, not where they met, added a third in 4 s.
TEST_P(ClosedSystem, ElasticBallsAndBoxesInABoxKeepTheirEnergy) {
    World world{without_gravity()};
    fill_box(world, surface(0, 1));
    const double energy = world.kinetic_energy();
    for (int second = 0; second < 4; ++second) {
        run(world, dt(), steps_in(1));
        EXPECT_NEAR(world.kinetic_energy() / energy, 1, 0.05) << "after " << second + 1 << " s";
    }
}

} // namespace
} // namespace cairn_test
