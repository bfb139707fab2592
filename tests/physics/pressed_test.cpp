// Bodies that are pressed on a surface so hard that they would move farther in a step than the speculative margin: by
// many times their weight, as in a centrifuge, under a press or in a world of centimeters, or in long steps.
#include "support.h"

#include "validation/random_starts.h"

#include <cmath>
#include <vector>

namespace cairn_test {
namespace {

struct Pull {
    double acceleration, step; // m/s^2, s
};
const Pull pulls[] = {{50, 1.0 / 60}, {100, 1.0 / 60},     {300, 1.0 / 60}, {1000, 1.0 / 60},
                      {gravity, 0.1}, {gravity, 1.0 / 15}, {gravity, 0.25}};

enum class Ground { box, plane, mesh, kinematic_box };
constexpr Ground grounds[] = {Ground::box, Ground::plane, Ground::mesh, Ground::kinematic_box};
constexpr int kinds = 7;

void add_ground(World& world, const RandomStart& random, Ground ground, const Material& material) {
    BodyDef def;
    def.type = ground == Ground::kinematic_box ? BodyType::kinematic : BodyType::static_;
    def.rotation = random.quat(), def.position = random.place({0, 0, 0});
    if (ground == Ground::plane) {
        add_body(world, Plane{}, def, material);
    } else if (ground == Ground::mesh) {
        const std::vector<Vec3> corners = {{-60, 0, -60}, {60, 0, -60}, {60, 0, 60}, {-60, 0, 60}};
        const std::vector<std::uint32_t> triangles = {0, 2, 1, 0, 3, 2};
        add_body(world, Mesh(corners, triangles), def, material);
    } else {
        def.position = random.place({0, -0.5, 0});
        add_body(world, Box{{60, 0.5f, 60}}, def, material);
    }
}

Shape shape_of(RandomStart& random, int kind, double size) {
    const auto part = [&](double least, double greatest) { return float(size * random.uniform(least, greatest)); };
    switch (kind) {
    case 0:
        return Box{{part(0.3, 1), part(0.3, 1), part(0.3, 1)}};
    case 1:
        return Sphere{part(0.5, 1)};
    case 2:
        return Capsule{part(0.3, 0.6), part(0.3, 0.6), {}};
    case 3:
        return Cylinder{part(0.3, 1), part(0.4, 0.7)};
    case 4:
        return cone(part(0.5, 0.8), part(0.4, 0.8));
    case 5:
        return Box{{part(0.3, 0.9), part(0.3, 0.9), part(0.3, 0.9)}, part(0.02, 0.1)};
    default: {
        std::vector<Vec3> points;
        for (int i = 0; i < 14; ++i) points.emplace_back(part(-1, 1), part(-1, 1), part(-1, 1));
        return Hull(points);
    }
    }
}

double impulse_on(const World& world, BodyId body) {
    double sum = 0;
    for (const Contact& c : world.contacts(body))
        for (int i = 0; i < c.point_count; ++i) sum += double(c.points[i].normal_impulse);
    return sum;
}

// A body falls a little and then lies or rolls. Returns the fraction of the pressing force that the ground carries,
// averaged over 20 steps; negative if the body has fallen through.
double fraction_of_force_carried(RandomStart& random, int kind, Ground ground, Pull pull) {
    WorldDef def = without_sleep();
    def.gravity = Vec3(random.turned({0, -pull.acceleration, 0}));
    World world(def);
    const Material material = surface(0.6f, 0);
    add_ground(world, random, ground, material);
    const double size = random.uniform(0.05, 0.5);
    BodyDef body;
    body.position = random.place({random.uniform(-2, 2), 1.75 * size + random.uniform(0, 0.03), random.uniform(-2, 2)});
    body.rotation = RandomStart(std::uint32_t(random.uniform(0, 1e6))).quat();
    body.angular_damping = 2;
    const BodyId id = add_body(world, shape_of(random, kind, size), body, material);
    run(world, float(pull.step), 300);
    double sum = 0;
    for (int i = 0; i < 20; ++i) world.step(float(pull.step)), sum += impulse_on(world, id);
    const double height = glm::dot(world.body(id).position() - random.place({0, 0, 0}), random.turned({0, 1, 0}));
    return height < 0 ? -1 : sum / (20 * pull.step * pull.acceleration * double(world.body(id).mass()));
}

// When each step was treated as free flight that ended in an impact, the ground carried a twelfth of the force, and of
// balls on meshes half fell through from 300 m/s^2 on.
TEST(Pressed, TheGroundBearsWhatPresses) {
    int unsteady = 0;
    for (const Pull& pull : pulls)
        for (int kind = 0; kind < kinds; ++kind)
            for (const Ground ground : grounds)
                for (std::uint32_t seed = 0; seed < 4; ++seed) {
                    RandomStart random(seed * 100 + std::uint32_t(kind));
                    const double share = fraction_of_force_carried(random, kind, ground, pull);
                    EXPECT_GT(share, 0.0) << pull.acceleration << " " << pull.step << ", kind " << kind << ", ground "
                                          << int(ground) << ", " << seed;
                    unsteady += !(std::fabs(share - 1) < 0.02);
                }
    EXPECT_LE(unsteady, 4) << "of " << 7 * kinds * 4 * 4;
}

// A sliding body stops after the distance that Coulomb friction gives.
TEST(Pressed, FrictionIsThatOfWhatPresses) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        RandomStart random(seed);
        const double pull = random.uniform(50, 1000), friction = random.uniform(0.2, 0.6);
        WorldDef def = without_sleep();
        def.gravity = Vec3(random.turned({0, -pull, 0}));
        World world(def);
        const Material material = surface(float(friction), 0);
        add_ground(world, random, grounds[seed % 4], material);
        const double way = random.uniform(0.3, 3), speed = std::sqrt(2 * friction * pull * way);
        const double heading = random.uniform(0, 2 * pi);
        const glm::dvec3 along(std::cos(heading), 0, std::sin(heading));
        BodyDef body;
        body.rotation = random.quat();
        body.position = random.place({0, 0.1 + 1e-5, 0});
        body.linear_velocity = Vec3(random.turned(speed * along));
        const BodyId id = add_body(world, Box{{0.5f, 0.1f, 0.5f}}, body, material);
        run(world, 1.0f / 60, 120);
        const double gone = glm::dot(world.body(id).position() - random.place({0, 0.1, 0}), random.turned(along));
        EXPECT_LT(glm::length(world.body(id).linear_velocity()), 1e-3) << seed;
        EXPECT_NEAR(gone / way, 1, 0.1) << seed << ": " << pull << " m/s^2, " << way << " m";
    }
}

} // namespace
} // namespace cairn_test
