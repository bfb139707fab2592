// Bodies that rock and roll without losses conserve energy: the contact point moves over both bodies within each step.
#include "starts.h"
#include "support.h"

#include <algorithm>
#include <tuple>

namespace cairn_test {
namespace {

World world_with_ball(double radius) {
    World world(without_sleep());
    BodyDef ball;
    ball.type = BodyType::static_;
    ball.position = {0, -radius, 0};
    add_body(world, Sphere{float(radius)}, ball, surface(0.6f));
    return world;
}

// The growth rate of the energy, 1/s, of a box of 1 x 0.4 x 1 m that rocks on a ball by some milliradians: from its
// maxima in the third and in the first second. The center of the box is 0.2 m high; it rocks, rather than falls, if the
// radius of the ball is greater.
double growth_of_box(double radius, int hertz, double direction) {
    World world = world_with_ball(radius);
    BodyDef def;
    def.position = {0, 0.2, 0};
    def.angular_velocity = 0.01f * Vec3(std::cos(direction), 0, std::sin(direction));
    add_body(world, Box{{0.5f, 0.2f, 0.5f}}, def, surface(0.6f));
    double first = 0, last = 0;
    for (int i = 0; i < 3 * hertz; ++i) {
        world.step(1.0f / float(hertz));
        if (i < hertz) first = std::max(first, world.kinetic_energy());
        if (i >= 2 * hertz) last = std::max(last, world.kinetic_energy());
    }
    return std::log(last / first) / 2;
}

// A contact point found at the start of a step is late by (n - 1) / (2n) of a step of n substeps on average, and a
// restoring torque that is late by t drives the rocking at the rate omega^2 t: at 0.15 to 1.2 /s on balls of 5 and 10
// m, at 960 and 240 Hz.
TEST(Rocking, BoxesOnBallsKeepTheirEnergy) {
    Starts starts(3);
    for (const double radius : {2.0, 5.0, 10.0})
        for (const int hertz : {60, 240, 960})
            for (int i = 0; i < 4; ++i)
                EXPECT_NEAR(growth_of_box(radius, hertz, starts.between(0, 6)), 0, hertz == 60 ? 0.05 : 0.01)
                    << radius << " " << hertz;
}

// The greatest increase of the energy of a shape that rocks on a ball within 3 s, as a fraction of its initial kinetic
// energy at `speed` rad/s.
double rise_of(const Hull& hull, double center, double radius, int hertz, double speed, double direction) {
    World world = world_with_ball(radius);
    BodyDef def;
    def.position = {0, center, 0};
    def.angular_velocity = float(speed) * Vec3(std::cos(direction), 0, std::sin(direction));
    add_body(world, hull, def, surface(0.6f));
    const double before = world.kinetic_energy() + world.potential_energy(), kinetic = world.kinetic_energy();
    double most = 0;
    for (int i = 0; i < 3 * hertz; ++i) {
        world.step(1.0f / float(hertz));
        most = std::max(most, world.kinetic_energy() + world.potential_energy() - before);
    }
    return most / kinetic;
}

// Tetrahedra are not tested by the wide kernel of box pairs. When contact points moved with the bodies for some
// millimeters, in which the true contact point moved by centimeters, all of them gained energy, at 0.7 to 1.2 /s.
TEST(Rocking, TetrahedraOnBallsGainNothing) {
    Starts starts(5);
    const float half = 0.8660254f, center = 0.35355339f; // half: of the length of a side; center: height above a face
    const Hull tetrahedron(
        std::vector<Vec3>{{1, -center, 0}, {-0.5f, -center, half}, {-0.5f, -center, -half}, {0, 3 * center, 0}});
    for (const double radius : {2.0, 5.0, 10.0})
        for (const int hertz : {60, 240, 960})
            for (int i = 0; i < 4; ++i) {
                const double speed = starts.between(0.05, 0.2), direction = starts.between(0, 6);
                EXPECT_LT(rise_of(tetrahedron, double(center), radius, hertz, speed, direction), 0.02)
                    << radius << " " << hertz << " " << speed << " " << direction;
            }
}

// The relative change of the energy in a second of Euler's disk: a disk of 50 cm radius and 2 cm thickness that rolls
// on its rim about a fixed center at the given angle to the ground, with a random heading. It rotates about the line
// from its center to its lowest point, and for a thin disk that point revolves at the rate given by rate^2 = 4 g / (R
// sin(lean)).
double change_of_disk(double degrees, double direction, int hertz, const Shape& ground = Plane{},
                      double thickness = 0) {
    constexpr double radius = 0.5, half = 0.01;
    World world(without_sleep());
    Material material = surface(1);
    material.torsional_friction = 0;
    BodyDef below;
    below.type = BodyType::static_;
    below.position.y = -thickness;
    add_body(world, ground, below, material);
    const double lean = radians(degrees), sine = std::sin(lean), cosine = std::cos(lean);
    const Quat heading = glm::angleAxis(float(direction), Vec3(0, 1, 0));
    BodyDef def;
    def.rotation = heading * glm::angleAxis(float(-lean), Vec3(0, 0, 1));
    def.position = {0, radius * sine + half * cosine, 0};
    const double rate = std::sqrt(4 * gravity / (radius * sine));
    def.angular_velocity = heading * Vec3(rate * sine * glm::dvec3(-cosine, sine, 0));
    ShapeDef shape;
    shape.material = material;
    world.add_shape(world.create_body(def), Cylinder{float(half), float(radius)}, shape);
    const double start = world.kinetic_energy() + world.potential_energy();
    run(world, 1.0f / float(hertz), hertz);
    return (world.kinetic_energy() + world.potential_energy()) / start - 1;
}

// With arms of the start of the step for all of it, the disk lost 9 to 24 % of its energy at 60 Hz and 20 to 41
// degrees, and 4 to 14 % at 240 Hz; with arms of the middle, 75 % at 20 degrees. The contact point is therefore
// followed along the rim. Near the ground it moves by a third of a radian and more in a step of 1/60 s: 2.5 and 18 %
// were lost at 10 and 5 degrees when it moved on a straight line within a step. When the edge of the upper face came
// within the speculative margin, the disk had a second contact point with zero impulse, and lost 7 % at 60 degrees.
TEST(Rocking, EulersDiskKeepsItsEnergy) {
    Starts starts(7);
    for (const int hertz : {60, 120, 240, 480, 1000})
        for (const auto& [least, most, bar] :
             {std::tuple(4, 6, 0.004), std::tuple(8, 20, 0.001), std::tuple(20, 42, 0.0005), std::tuple(55, 80, 0.002)})
            for (int i = 0; i < 12; ++i) {
                const double lean = starts.between(least, most), direction = starts.between(0, 6);
                EXPECT_NEAR(change_of_disk(lean, direction, hertz), 0, bar) << hertz << " " << lean << " " << direction;
            }
}

// On the triangles of a mesh the rim touched each triangle at a point of its own, and on other cylinders at three
// points close together; and contacts with these and with hulls did not record that they are on a face. The disk lost
// 92 % at 5 degrees on a mesh, 87 % on a hull or a cylinder, and 51 and 40 % at 30 degrees.
TEST(Rocking, EulersDiskKeepsItsEnergyOnAllFaces) {
    Starts starts(8);
    std::vector<Vec3> corners;
    for (int i = 0; i < 7; ++i)
        for (const float y : {-1.0f, 1.0f})
            corners.push_back({6 * std::cos(0.9f * float(i)), y, 6 * std::sin(0.9f * float(i))});
    const std::pair<Shape, double> grounds[] = {{flat_mesh(16, 0.3f), 0},
                                                {Hull(corners), 1},
                                                {Cylinder{1, 6, {}}, 1},
                                                {Box{{6, 1, 6}}, 1},
                                                {Box{{6, 1, 6}, 0.1f}, 1.1}};
    for (const auto& [ground, thickness] : grounds)
        for (const int hertz : {60, 240})
            for (const auto& [least, most, bar] : {std::tuple(4, 6, 0.004), std::tuple(8, 20, 0.001),
                                                   std::tuple(20, 42, 0.0005), std::tuple(55, 80, 0.002)})
                for (int i = 0; i < 4; ++i) {
                    const double lean = starts.between(least, most), direction = starts.between(0, 6);
                    EXPECT_NEAR(change_of_disk(lean, direction, hertz, ground, thickness), 0, bar)
                        << "ground " << ground.index() << ", " << hertz << " Hz, " << lean << " degrees, " << direction;
                }
}

} // namespace
} // namespace cairn_test
