// Contacts along a line, or with several points on a round surface: the contact points move over both surfaces as the
// bodies roll.
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

double energy_of(const World& world) { return world.kinetic_energy() + world.potential_energy(); }

void add_round(World& world, bool is_capsule, double half, double radius, const BodyDef& def) {
    if (is_capsule)
        add_body(world, Capsule{float(half), float(radius), {}}, def, surface(1));
    else
        add_body(world, Cylinder{float(half), float(radius)}, def, surface(1));
}

// The growth rate of the energy, 1/s, of a plank that lies across a fixed log and rocks on it by up to 0.15 rad. Energy
// counts from that of the horizontal plank at its static penetration.
double growth_of_plank(RandomStart& random, bool is_capsule, int hertz) {
    const double radius = random.uniform(0.1, 1), thickness = random.uniform(0.01, 0.4) * radius;
    const double half = random.uniform(1, 3) * radius, lean = random.uniform(0.03, 0.15);
    const glm::dquat heading = glm::angleAxis(random.uniform(0, 2 * pi), glm::dvec3(0, 1, 0)),
                     turn = heading * glm::angleAxis(lean, glm::dvec3(0, 0, 1));
    World world(without_sleep());
    BodyDef log;
    log.type = BodyType::static_;
    log.rotation = Quat(heading * glm::angleAxis(pi / 2, glm::dvec3(1, 0, 0)));
    add_round(world, is_capsule, 2 * radius, radius, log);
    BodyDef def;
    def.rotation = Quat(turn);
    def.position = turn * glm::dvec3(radius * lean, radius + thickness, 0);
    const BodyId plank = add_body(world, Box{{float(half), float(thickness), float(0.3 * half)}}, def, surface(1));
    const double level = double(world.body(plank).mass()) * gravity * (radius + thickness);
    run(world, 1.0f / float(hertz), 2 * hertz);
    const double before = energy_of(world) - level;
    run(world, 1.0f / float(hertz), 6 * hertz);
    return std::log((energy_of(world) - level) / before) / 6;
}

// When contact points moved with the plank until it had moved by some thousandths of its radius, energy grew at 0.03 to
// 0.07 /s.
TEST(RollingLines, APlankThatRocksOnALogKeepsItsEnergy) {
    RandomStart random(5);
    for (const bool is_capsule : {false, true})
        for (const int hertz : {60, 240})
            for (int i = 0; i < 12; ++i)
                EXPECT_NEAR(growth_of_plank(random, is_capsule, hertz), 0, 0.006) << is_capsule << hertz << " " << i;
}

// The energy after 9 s, relative to that after 1 s, of a cylinder or capsule on its side that rolls to and fro because
// its center of mass is below its axis.
double left_of_roll(RandomStart& random, bool is_capsule, int hertz) {
    const double radius = random.uniform(0.1, 0.5), below = random.uniform(0.2, 0.6) * radius;
    const double lean = random.uniform(0.1, 0.6);
    const glm::dquat lying = glm::angleAxis(pi / 2, glm::dvec3(1, 0, 0)),
                     heading = glm::angleAxis(random.uniform(0, 2 * pi), glm::dvec3(0, 1, 0));
    World world(without_sleep());
    add_ground(world, surface(1));
    BodyDef def;
    def.position = {0, radius, 0};
    def.rotation = Quat(heading * glm::angleAxis(lean, glm::dvec3(0, 0, 1)) * lying);
    MassProperties mass;
    mass.mass = 5;
    mass.center_of_mass = Vec3(glm::inverse(lying) * glm::dvec3(0, -below, 0));
    mass.inertia_diagonal = Vec3(float(1.5 * radius * radius));
    def.mass_properties = mass;
    add_round(world, is_capsule, 0.3, radius, def);
    const double lowest = 5 * gravity * (radius - below);
    run(world, 1.0f / float(hertz), hertz);
    const double before = energy_of(world) - lowest;
    run(world, 1.0f / float(hertz), 9 * hertz);
    return (energy_of(world) - lowest) / before;
}

// When lines of contact were fixed within a step, and moved with the bodies from step to step, 0.56 to 1.15 of the
// energy remained.
TEST(RollingLines, ARolyPolyKeepsItsEnergy) {
    RandomStart random(7);
    for (const bool is_capsule : {false, true})
        for (const int hertz : {60, 240})
            for (int i = 0; i < 12; ++i)
                EXPECT_NEAR(left_of_roll(random, is_capsule, hertz), 1, 0.04) << is_capsule << hertz << " " << i;
}

// The kinetic energy after 5 s, relative to the initial one, of a cone or truncated cone that lies on its side and
// rolls in a circle.
double left_of_cone(RandomStart& random, bool has_tip, int hertz) {
    const double base = random.uniform(0.05, 0.3), half = random.uniform(0.5, 2) * base;
    const double top = has_tip ? 0 : random.uniform(0.2, 0.8) * base, rate = random.uniform(1.5, 6);
    const double slope = std::atan((base - top) / (2 * half)), height = 0.5 * (base + top) * std::cos(slope);
    const glm::dquat heading = glm::angleAxis(random.uniform(0, 2 * pi), glm::dvec3(0, 1, 0));
    const glm::dvec3 line = heading * glm::dvec3(1, 0, 0);
    World world(without_sleep());
    add_ground(world, rough());
    BodyDef def;
    def.position = {0, height, 0};
    def.rotation = Quat(heading * glm::angleAxis(-(pi / 2 + slope), glm::dvec3(0, 0, 1)));
    const BodyId cone = add_body(world, Cylinder{float(half), float(base), float(top)}, def, rough());
    const glm::dvec3 arm = {0, world.body(cone).center_of_mass().y, 0};
    world.body(cone).set_angular_velocity(Vec3(rate * line));
    world.body(cone).set_linear_velocity(Vec3(rate * glm::cross(line, arm)));
    run(world, 1.0f / float(hertz), hertz / 2);
    const double before = world.kinetic_energy();
    run(world, 1.0f / float(hertz), 5 * hertz);
    return world.kinetic_energy() / before;
}

enum class Ground { plane, mesh, height_field };

void add_smooth_ground(World& world, Ground ground, const Material& material) {
    constexpr int cells = 12;
    BodyDef def;
    def.type = BodyType::static_;
    if (ground == Ground::plane) {
        add_ground(world, material);
    } else if (ground == Ground::mesh) {
        add_body(world, flat_mesh(cells, 1), def, material);
    } else {
        const std::vector<float> heights((cells + 1) * (cells + 1), 0.0f);
        add_body(world, HeightField(cells + 1, cells + 1, {1, 1}, heights), def, material);
    }
}

// A body that lies on the ground and rotates about its own axis as well as about the vertical keeps both rotations. In
// such a motion only the ends of the contact line move within the step, not its middle. When the middle alone was
// considered, the spin about the axis was lost in three seconds, and nine tenths of it at 240 Hz. The same loss
// occurred on meshes and height fields whose contacts did not record that triangles are flat; and a body across an edge
// between two coplanar triangles, inclined a little, had no contact point beyond the edge.
TEST(RollingLines, WhatSpinsAboutItsAxisAndTurnsKeepsBoth) {
    RandomStart random(3);
    for (const Ground ground : {Ground::plane, Ground::mesh, Ground::height_field})
        for (const auto& [hertz, bar] : {std::pair(60, 0.03), std::pair(120, 0.02), std::pair(240, 0.006)})
            for (const bool is_capsule : {true, false})
                for (int i = 0; i < 12; ++i) {
                    World world(without_sleep());
                    Material smooth = surface(0);
                    smooth.torsional_friction = 0;
                    add_smooth_ground(world, ground, smooth);
                    const double about_axis = random.uniform(2, 10), about_vertical = random.uniform(2, 8);
                    BodyDef def;
                    def.position = {random.uniform(-1, 1), 0.05, random.uniform(-1, 1)};
                    def.rotation = glm::angleAxis(float(random.uniform(0, 2 * pi)), Vec3(0, 1, 0)) *
                                   glm::angleAxis(float(pi / 2), Vec3(0, 0, 1));
                    const Vec3 axis = def.rotation * Vec3(0, 1, 0);
                    def.angular_velocity = float(about_axis) * axis + float(about_vertical) * Vec3(0, 1, 0);
                    const BodyId id = is_capsule ? add_body(world, Capsule{0.2f, 0.05f}, def, smooth)
                                                 : add_body(world, Cylinder{0.2f, 0.05f}, def, smooth);
                    const double before = world.kinetic_energy();
                    run(world, 1.0f / float(hertz), 3 * hertz);
                    const Vec3 now = world.body(id).rotation() * Vec3(0, 1, 0),
                               spin = world.body(id).angular_velocity();
                    const std::string what = std::to_string(int(ground)) + ", " + std::to_string(hertz) + " Hz, " +
                                             (is_capsule ? "capsule " : "cylinder ") + std::to_string(i);
                    EXPECT_NEAR(double(glm::dot(spin, now)) / about_axis, 1, bar) << what;
                    EXPECT_NEAR(double(spin.y) / about_vertical, 1, bar) << what;
                    EXPECT_NEAR(world.kinetic_energy() / before, 1, 0.01) << what;
                }
}

// Without the rotation of the contact line within a step and the variation of the radius of curvature along a cone,
// cones kept 0.82 of their energy on average, and 0.53 at least.
TEST(RollingLines, AConeRollsInACircle) {
    RandomStart random(9);
    for (const bool has_tip : {true, false}) {
        double sum = 0, least = 1;
        for (int i = 0; i < 24; ++i) {
            const double left = left_of_cone(random, has_tip, 60);
            sum += left, least = std::min(least, left);
            EXPECT_LT(left, 1.02) << i;
        }
        EXPECT_GT(sum / 24, 0.95) << has_tip;
        EXPECT_GT(least, 0.75) << has_tip;
    }
}

// Adds a row of boxes, each 0.5 m long, of which the first begins `behind` m before the origin.
void add_tiles(World& world, const glm::dquat& heading, double behind) {
    const BodyId tiles = world.create_body({.type = BodyType::static_, .rotation = Quat(heading)});
    for (int i = 0; i < 66; ++i) {
        ShapeDef tile;
        tile.material = rough();
        tile.position = {float(0.5 * i + 0.25 - behind), -0.5f, 0};
        world.add_shape(tiles, Box{{0.25f, 0.5f, 3}}, tile);
    }
}

// The state, after three seconds, of an axle with two tapered wheels that roll on their larger rims: the remaining
// fraction of the energy, and the sideways displacement as a fraction of the distance.
struct RolledAxle {
    double energy, aside;
    double bump; // greatest vertical speed after the start, m/s
};
RolledAxle roll_axle(RandomStart& random, bool is_capsule, int hertz, bool on_tiles) {
    const double radius = random.uniform(0.1, 0.5), half = random.uniform(0.05, 0.3) * radius,
                 small = random.uniform(0.3, 0.9) * radius, mass = random.uniform(1, 20), speed = random.uniform(1, 10);
    const glm::dquat heading = glm::angleAxis(random.uniform(0, 2 * pi), glm::dvec3(0, 1, 0));
    const glm::dvec3 ahead = heading * glm::dvec3(1, 0, 0), aside = heading * glm::dvec3(0, 0, 1);
    World world(without_sleep());
    if (on_tiles)
        add_tiles(world, heading, random.uniform(0, 0.5));
    else
        add_ground(world, rough());
    BodyDef def;
    def.position = {0, radius, 0};
    def.rotation = Quat(heading);
    def.linear_velocity = Vec3(speed * ahead);
    def.angular_velocity = Vec3(-speed / radius * aside);
    const float moment = float(mass * radius * radius);
    def.mass_properties = MassProperties{float(mass), {}, {moment, moment, 0.5f * moment}, {1, 0, 0, 0}};
    const BodyId axle = world.create_body(def);
    const double turn = random.uniform(-1, 1) < 0 ? -pi / 2 : pi / 2; // larger rims inside or outside
    for (const double side : {-1.0, 1.0}) {
        ShapeDef wheel;
        wheel.material = rough();
        wheel.position = {0, 0, float(2 * side * radius)};
        wheel.rotation = glm::angleAxis(float(side * turn), Vec3(1, 0, 0));
        if (is_capsule)
            world.add_shape(axle, Capsule{float(half), float(radius), float(small)}, wheel);
        else
            world.add_shape(axle, Cylinder{float(half), float(radius), float(small)}, wheel);
    }
    const double before = energy_of(world);
    double bump = 0;
    for (int i = 0; i < 3 * hertz; ++i) {
        world.step(1.0f / float(hertz));
        if (i > hertz / 5) bump = std::max(bump, std::fabs(double(world.body(axle).linear_velocity().y)));
    }
    const glm::dvec3 way = world.body(axle).position() - def.position;
    return {energy_of(world) / before, std::fabs(glm::dot(way, aside)) / glm::dot(way, ahead), bump};
}

// When the rim was that of the end toward which the axis leans, which is the wrong one while the axis is nearly
// horizontal, such wheels gained up to 18 % of their energy in five seconds, and drifted sideways by up to 9 m in 25 m.
// Wheels of capsules had a second contact point at their smaller end, centimeters above the ground, and drifted by up
// to a quarter of the distance.
TEST(RollingLines, WheelsThatTaperRollStraightOn) {
    RandomStart random(17);
    for (const bool is_capsule : {false, true})
        for (const int hertz : {60, 240})
            for (int i = 0; i < 16; ++i) {
                const RolledAxle rolled = roll_axle(random, is_capsule, hertz, false);
                EXPECT_LT(rolled.energy, 1.002) << is_capsule << " " << hertz << " Hz " << i;
                EXPECT_GT(rolled.energy, 0.98) << is_capsule << " " << hertz << " Hz " << i;
                EXPECT_LT(rolled.aside, 0.02) << is_capsule << " " << hertz << " Hz " << i;
            }
}

// At the first contact with a tile, the smaller end had a second contact point, centimeters above the tile, and both
// points moved like those of a cone that lies on its side: each tile threw the wheels up at 0.3 m/s.
TEST(RollingLines, WheelsThatTaperRollOverTiles) {
    RandomStart random(18);
    for (const bool is_capsule : {false, true})
        for (const int hertz : {60, 240})
            for (int i = 0; i < 12; ++i) {
                const RolledAxle rolled = roll_axle(random, is_capsule, hertz, true);
                EXPECT_LT(rolled.bump, 0.03) << is_capsule << " " << hertz << " Hz " << i;
                EXPECT_LT(rolled.energy, 1.002) << is_capsule << " " << hertz << " Hz " << i;
                EXPECT_GT(rolled.energy, 0.97) << is_capsule << " " << hertz << " Hz " << i;
            }
}

// Whether a standing cylinder of 1 kg falls when it is pushed at the height of its center with the fraction `share` of
// the tipping force m g r / h. The force increases for a second.
bool falls(double radius, double half, double share, double heading, double turn) {
    World world;
    add_ground(world, surface(3));
    BodyDef def;
    def.mass = 1;
    def.position = {0, half, 0};
    def.rotation = glm::angleAxis(float(turn), Vec3(0, 1, 0));
    const BodyId cylinder = add_body(world, Cylinder{float(half), float(radius)}, def, surface(3));
    run(world, 1.0f / 60, 30);
    const double force = share * gravity * radius / half;
    for (int i = 0; i < 240; ++i) {
        const double grown = std::min(1.0, i / 60.0);
        world.body(cylinder).add_force(Vec3(force * grown * glm::dvec3(std::cos(heading), 0, std::sin(heading))));
        world.step(1.0f / 60);
        if ((world.body(cylinder).rotation() * Vec3(0, 1, 0)).y < 0.97f) return true;
    }
    return false;
}

// When the four contact points on its rim moved with the body, they moved to the side of the load, and the cylinder
// fell at 0.88 to 0.996 of that force.
TEST(RollingLines, ACylinderTipsAtItsRim) {
    RandomStart random(11);
    for (int i = 0; i < 24; ++i) {
        const double radius = random.uniform(0.02, 0.3), half = random.uniform(2, 4) * radius;
        const double heading = random.uniform(0, 2 * pi), turn = random.uniform(0, 2 * pi);
        EXPECT_FALSE(falls(radius, half, 0.97, heading, turn)) << radius << " " << half << " " << heading;
        EXPECT_TRUE(falls(radius, half, 1.02, heading, turn)) << radius << " " << half << " " << heading;
    }
}

// A spinning top with a tip 6 cm below its center of mass, conical or a ball of radius `ball`, in steady precession
// about the vertical.
struct Top {
    double rate;     // rate of precession, relative to the exact one
    double nutation; // rad: variation of its inclination
    double energy;   // remaining fraction
};
Top spin_top(double spin, double lean, double heading, double ball, int hertz) {
    constexpr double arm = 0.06, axial = 0.5 * 0.1 * 0.05 * 0.05, across = 0.6 * axial; // m, kg m^2
    WorldDef settings = without_sleep();
    World world(settings);
    add_ground(world, rough());
    const glm::dquat turn = glm::angleAxis(heading, glm::dvec3(0, 1, 0)) * glm::angleAxis(-lean, glm::dvec3(0, 0, 1));
    const glm::dvec3 axis = turn * glm::dvec3(0, 1, 0);
    // The slow solution p of A p^2 - C s p + m g l = 0, with A = (I + m l^2) cos(lean) and the spin s.
    const double a = (across + 0.1 * arm * arm) * std::cos(lean), moment = axial * spin, weight = 0.1 * gravity * arm;
    const double precession = (moment - std::sqrt(moment * moment - 4 * a * weight)) / (2 * a);
    const glm::dvec3 rate = precession * glm::dvec3(0, 1, 0) + (spin - precession * std::cos(lean)) * axis;
    BodyDef def;
    MassProperties mass;
    mass.mass = 0.1f;
    mass.inertia_diagonal = {float(across), float(axial), float(across)};
    def.mass_properties = mass;
    def.position = arm * axis + glm::dvec3(0, ball, 0);
    def.rotation = Quat(turn);
    def.angular_velocity = Vec3(rate);
    def.linear_velocity = Vec3(glm::cross(rate, arm * axis + glm::dvec3(0, ball, 0)));
    ShapeDef tip;
    tip.material = rough();
    tip.position = {0, float((ball > 0 ? 0 : 0.02) - arm), 0};
    tip.rotation = glm::angleAxis(float(pi), Vec3(1, 0, 0));
    const BodyId top = world.create_body(def);
    world.add_shape(top, ball > 0 ? Shape(Sphere{float(ball)}) : Shape(Cylinder{0.02f, 0.02f, 0.0f}), tip);
    const double before = energy_of(world);
    double turned = 0, least = 9, most = 0, last = std::atan2(-axis.z, axis.x);
    for (int i = 0; i < 2 * hertz; ++i) {
        world.step(1.0f / float(hertz));
        const glm::dvec3 now = glm::dquat(world.body(top).rotation()) * glm::dvec3(0, 1, 0);
        const double angle = std::atan2(-now.z, now.x);
        turned += std::remainder(angle - last, 2 * pi);
        last = angle;
        least = std::min(least, std::acos(now.y)), most = std::max(most, std::acos(now.y));
    }
    return {turned / (2 * precession), most - least, energy_of(world) / before};
}

// When contacts constrained the angular velocity at the end of each substep instead of the one that moves the body, the
// nutation grew to 0.1 to 0.3 rad at 480 and 960 Hz. At 60 and 120 Hz it was up to 0.9 rad, because the spin of a top
// counted as a rotation of its inertia tensor, and because a second contact point, far off the tip, came within the
// speculative margin. A top on a ball also rolls, which slows its precession.
TEST(RollingLines, ATopOnItsTipPrecesses) {
    RandomStart random(13);
    for (const auto& [hertz, bar] :
         {std::pair(60, 0.1), std::pair(120, 0.04), std::pair(240, 0.02), std::pair(480, 0.02), std::pair(960, 0.005)})
        for (const double ball : {0.0, 0.001})
            for (int i = 0; i < 12; ++i) {
                const double spin = random.uniform(120, 280), lean = random.uniform(0.2, 0.5);
                const Top top = spin_top(spin, lean, random.uniform(0, 2 * pi), ball, hertz);
                EXPECT_NEAR(top.rate, ball > 0 ? 0.95 : 1, 0.02) << spin << " " << lean << " " << ball << " " << hertz;
                EXPECT_LT(top.nutation, bar) << spin << " " << lean << " " << ball << " " << hertz;
                EXPECT_NEAR(top.energy, 1, 0.01) << spin << " " << lean << " " << ball << " " << hertz;
            }
}

} // namespace
} // namespace cairn_test
