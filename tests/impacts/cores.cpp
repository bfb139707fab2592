// A room of mixed bodies whose cores are watched, in every step and of every pair, by the oracle.
#include "cells.h"
#include "oracle.h"

namespace cairn_test {
namespace {

struct Member {
    Body body;
    Bullet bullet; // its shapes lie in the body's frame as they are
    bool is_static;
    Transform from, to;
    Vec3 velocity{0, 0, 0}, spin{0, 0, 0};
    // Nothing changed its velocity in the step, and its axis turned so little that one rotation leads from pose to
    // pose.
    bool is_free = true;
};

std::vector<Member> fill(World& world, const Crowd& cell, Random& random) {
    const Material material = surface(0.3f, 0.5f);
    std::vector<Member> members;
    const auto add = [&](const Bullet& bullet, const BodyDef& def) {
        const Body body = world.body(add_bullet(world, bullet, def, material));
        const bool is_static = def.type == BodyType::static_;
        members.push_back({body, bullet, is_static, body.transform(), body.transform(), body.linear_velocity(),
                           body.angular_velocity()});
    };
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
            add(wall, def);
        }
    const int n = int(std::ceil(std::cbrt(double(cell.bodies))));
    const double pitch = (cell.width - 4.5 * cell.size) / (n > 1 ? n - 1 : 1);
    for (int i = 0; i < cell.bodies; ++i) {
        BodyDef def;
        def.position = pitch * (Position(i % n, i / n % n, i / (n * n)) - 0.5 * double(n - 1));
        def.rotation = random.rotation();
        def.linear_velocity = Vec3(cell.speed * random.direction());
        def.angular_velocity = Vec3(cell.spin * random.direction());
        add(make_bullet(all_kinds[std::size_t(i) % std::size(all_kinds)], cell.size), def);
    }
    return members;
}

void step(World& world, std::vector<Member>& members) {
    world.step(frame);
    for (Member& member : members) {
        if (member.is_static) continue;
        member.from = member.to;
        member.to = member.body.transform();
        const Vec3 velocity = member.body.linear_velocity();
        const Vec3 spin = member.body.angular_velocity();
        const double bend = double(glm::length(spin - member.spin)) * double(frame) / 8; // rad
        member.is_free = glm::length(velocity - member.velocity) <= 1e-5f * glm::length(velocity) &&
                         bend * member.bullet.reach <= 0.1 * core_shrink(member.bullet.inner_radius);
        member.velocity = velocity, member.spin = spin;
    }
}

// Whether any core of one meets one of the other. At the end of the step only, or all along it.
bool do_cores_meet(const Member& a, const Member& b, bool is_along) {
    for (const Shape& shape_a : a.bullet.shapes)
        for (const Shape& shape_b : b.bullet.shapes) {
            const auto moving = [is_along](const Member& member, const Shape& shape) {
                return Moving{&shape, is_along ? member.from : member.to, member.to, member.bullet.center,
                              core_shrink(inner_radius(shape))};
            };
            if (cores_meet(moving(a, shape_a), moving(b, shape_b))) return true;
        }
    return false;
}

} // namespace

CoresMet watch_crowd(const Crowd& cell) {
    Random random(cell.seed);
    CoresMet met;
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        std::vector<Member> members = fill(world, cell, random);
        for (int i = 0; i < int(cell.seconds * 60); ++i) {
            step(world, members);
            ++met.steps;
            for (std::size_t a = 0; a < members.size(); ++a)
                for (std::size_t b = a + 1; b < members.size(); ++b) {
                    if (members[a].is_static && members[b].is_static) continue;
                    if (do_cores_meet(members[a], members[b], false))
                        ++met.overlapping;
                    else if (members[a].is_free && members[b].is_free)
                        met.passed += do_cores_meet(members[a], members[b], true);
                }
        }
    }
    return met;
}

} // namespace cairn_test
