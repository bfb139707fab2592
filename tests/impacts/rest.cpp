// Standing, sliding and rolling under gravity.
#include "cells.h"

#include "validation/measures.h"

namespace cairn_test {
namespace {

double mean_height(const World& world, const std::vector<BodyId>& ids) {
    double sum = 0;
    for (const BodyId id : ids) sum += world.body(id).position().y;
    return sum / double(ids.size());
}

// Adds a stack of boxes without gaps, the lowest `height` m above the ground.
std::vector<BodyId> add_stack(World& world, int boxes, double edge, double height) {
    std::vector<BodyId> ids;
    for (int i = 0; i < boxes; ++i) {
        BodyDef def;
        def.position = {0, height + (i + 0.5) * edge, 0};
        ids.push_back(add_body(world, Box{Vec3(float(edge / 2))}, def));
    }
    return ids;
}

} // namespace

double rebound_of_stack(int boxes, double height) {
    World world;
    add_ground(world);
    const std::vector<BodyId> ids = add_stack(world, boxes, 1, height);
    double fastest = 0;
    for (int i = 0; i < 120; ++i) {
        const double before = mean_height(world, ids);
        world.step(frame);
        fastest = std::max(fastest, (mean_height(world, ids) - before) / double(frame));
    }
    return fastest;
}

double turn_of_sliding_box(double offset) {
    constexpr double friction = 0.3, way = 14, side = 0.5, height = 0.2; // friction; m
    World world;
    add_ground(world, surface(float(friction)));
    MassProperties mass;
    mass.mass = 50;
    mass.center_of_mass = {0, 0, float(offset)};
    const double across = double(mass.mass) * side * side / 6;
    const double flat = double(mass.mass) * (side * side + height * height) / 12;
    mass.inertia_diagonal = {float(flat), float(across), float(flat)};
    BodyDef def;
    def.position = {0, height / 2, 0};
    def.linear_velocity = {float(std::sqrt(2 * friction * gravity * way)), 0, 0};
    def.mass_properties = mass;
    const Body box = world.body(
        add_body(world, Box{{float(side / 2), float(height / 2), float(side / 2)}}, def, surface(float(friction))));
    // Rotations of the steps are summed, as the box may rotate by more than half a turn.
    double turned = 0, heading = 0;
    for (int i = 0; i < 360; ++i) {
        world.step(frame);
        const Vec3 along = box.rotation() * Vec3(1, 0, 0);
        const double now = std::atan2(-along.z, along.x);
        turned += std::remainder(now - heading, 2 * pi);
        heading = now;
    }
    return std::fabs(turned) / radians(1);
}

bool do_cards_stand(double degrees, double friction, double heading) {
    constexpr double length = 1, thickness = 0.02, width = 0.7; // m
    const double lean = radians(degrees);
    World world;
    add_ground(world, surface(float(friction)));
    std::vector<BodyId> cards;
    for (const double sign : {-1.0, 1.0}) {
        // Seen from the front, the top of the left card leans to the right. Its lowest edge is on the ground, its
        // rightmost one in the middle.
        const double x = length / 2 * std::sin(lean) + thickness / 2 * std::cos(lean);
        const double y = length / 2 * std::cos(lean) + thickness / 2 * std::sin(lean);
        BodyDef def;
        def.position = {sign * x * std::cos(heading), y, -sign * x * std::sin(heading)};
        def.rotation =
            Quat(glm::angleAxis(heading, Position(0, 1, 0)) * glm::angleAxis(sign * lean, Position(0, 0, 1)));
        const Box card{{float(thickness / 2), float(length / 2), float(width / 2)}};
        cards.push_back(add_body(world, card, def, surface(float(friction))));
    }
    const double before = mean_height(world, cards);
    run(world, frame, 300);
    return mean_height(world, cards) > 0.95 * before;
}

double least_friction_of_cards(double degrees, double heading) {
    // Searched from above, among the values below 1.
    return -last_where(-1.0, -0.05, 0.002, [=](double less) { return do_cards_stand(degrees, -less, heading); });
}

double energy_of_disk(double degrees, double seconds) {
    constexpr double radius = 0.5, half_height = 0.01; // m
    const double lean = radians(degrees), sine = std::sin(lean), cosine = std::cos(lean);
    World world(without_sleep());
    Material material = surface(1);
    material.torsional_friction = 0;
    add_ground(world, material);
    BodyDef def;
    // The axis of the disk leans toward +x, so that its lowest point is there. It rolls with a fixed center: it rotates
    // about the line from the center to the lowest point, which revolves with the period 2 pi / rate.
    def.rotation = glm::angleAxis(float(-lean), Vec3(0, 0, 1));
    def.position = {0, radius * sine + half_height * cosine, 0};
    const double rate = std::sqrt(4 * gravity / (radius * sine));
    def.angular_velocity = Vec3(rate * sine * Position(-cosine, sine, 0));
    const BodyId id = world.create_body(def);
    ShapeDef shape;
    shape.material = material;
    world.add_shape(id, Cylinder{float(half_height), float(radius)}, shape);
    const double start = world.kinetic_energy() + world.potential_energy();
    run(world, frame, int(seconds * 60));
    return (world.kinetic_energy() + world.potential_energy()) / start - 1;
}

double slide_on_slope(double friction, double degrees_more, double seconds) {
    World world;
    const Slope slope{std::atan(friction) + radians(degrees_more)};
    slope.add_to(world, surface(float(friction)));
    BodyDef def;
    def.position = 0.5 * slope.normal();
    def.rotation = slope.rotation();
    const Body box = world.body(add_body(world, Box{{0.5f, 0.5f, 0.5f}}, def, surface(float(friction))));
    const Position start = box.position();
    run(world, frame, int(seconds * 60));
    return glm::dot(box.position() - start, slope.downhill());
}

Apart made_in_one_place(const Shape& shape, int bodies, double half, int before) {
    World world;
    add_ground(world);
    BodyDef def;
    for (int i = 0; i < before; ++i) {
        def.position = {10 + 4 * half * i, half, 0};
        add_body(world, shape, def);
    }
    std::vector<BodyId> ids;
    const double start = half + 0.01;
    def.position = {0, start, 0};
    for (int i = 0; i < bodies; ++i) ids.push_back(add_body(world, shape, def));
    Apart apart;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        for (const BodyId id : ids) {
            const Vec3 v = world.body(id).linear_velocity();
            apart.speed = std::max({apart.speed, double(v.y), std::hypot(double(v.x), double(v.z))});
            apart.height = std::max(apart.height, world.body(id).position().y - start);
        }
    }
    return apart;
}

double height_left_of_stack(int cubes, double edge, double seconds) {
    World world;
    add_ground(world);
    const std::vector<BodyId> ids = add_stack(world, cubes, edge, 0);
    run(world, frame, int(seconds * 60));
    return (world.body(ids.back()).position().y + edge / 2) / (cubes * edge);
}

} // namespace cairn_test
