// A room of mixed bodies whose cores the oracle watches, in every step and for every pair.
#include "cells.h"
#include "core_watch.h"

namespace cairn_test {
namespace {

void fill(World& world, const Crowd& cell, Random& random) {
    const Material material = surface(0.3f, 0.5f);
    const double half = cell.width / 2, thick = cell.thickness / 2;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Bullet wall;
            Vec3 extents(float(half + 2 * thick));
            extents[axis] = float(thick);
            wall.shapes = {Box{extents}};
            BodyDef def;
            def.type = BodyType::static_;
            def.position[axis] = side * (half + thick);
            add_bullet(world, wall, def, material);
        }
    const int n = int(std::ceil(std::cbrt(double(cell.bodies))));
    const double pitch = (cell.width - 4.5 * cell.size) / (n > 1 ? n - 1 : 1);
    for (int i = 0; i < cell.bodies; ++i) {
        BodyDef def;
        def.position = pitch * (Position(i % n, i / n % n, i / (n * n)) - 0.5 * double(n - 1));
        def.rotation = random.rotation();
        def.linear_velocity = Vec3(cell.speed * random.direction());
        def.angular_velocity = Vec3(cell.spin * random.direction());
        add_bullet(world, make_bullet(all_kinds[std::size_t(i) % std::size(all_kinds)], cell.size), def, material);
    }
}

} // namespace

CrowdSeen watch_crowd(const Crowd& cell) {
    Random random(cell.seed);
    CrowdSeen seen;
    for (int shot = 0; shot < cell.shots; ++shot) {
        WorldDef def = without_gravity();
        def.hit_speed = 0;
        World world(def);
        fill(world, cell, random);
        CoreWatch watch(world);
        for (int i = 0; i < int(cell.seconds * 60); ++i) {
            world.step(frame);
            ++seen.steps;
            const CoreEncounters met = watch.look(world, double(frame));
            seen.overlapping += met.overlapping;
            seen.passed += met.passed;
            seen.deep += met.deep;
        }
    }
    return seen;
}

} // namespace cairn_test
