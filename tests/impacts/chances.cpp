// Other ways to tunnel than a shot at a wall: a hit or force within a step, a closed room, rotating bodies.
#include "cells.h"

namespace cairn_test {
namespace {

constexpr double ball_radius = 0.05, wall_thickness = 0.01; // m

BodyId add_static(World& world, const Shape& shape, const Position& position, const Material& material) {
    BodyDef def;
    def.type = BodyType::static_;
    def.position = position;
    return add_body(world, shape, def, material);
}

// Kinetic energy of all, J.
double energy(const World& world) { return world.kinetic_energy(); }

// Adds six walls around the origin.
void add_room(World& world, const Room& cell, const Material& material) {
    const double half = cell.width / 2, thick = cell.thickness / 2;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Vec3 extents(float(half + 2 * thick));
            Position position(0, 0, 0);
            extents[axis] = float(thick);
            position[axis] = side * (half + thick);
            add_static(world, Box{extents}, position, material);
        }
}

// Adds bodies in a grid, each randomly rotated, with the same speed in random directions.
std::vector<BodyId> fill_room(World& world, const Room& cell, Random& random, const Material& material) {
    const Bullet bullet = make_bullet(cell.kind, cell.size);
    const int n = int(std::ceil(std::cbrt(double(cell.bodies))));
    const double pitch = (cell.width - 2 * bullet.reach) / (n > 1 ? n - 1 : 1);
    std::vector<BodyId> ids;
    for (int i = 0; i < cell.bodies; ++i) {
        BodyDef def;
        const Position cell_of_grid(i % n, i / n % n, i / (n * n));
        def.position = 0.999 * (cell_of_grid * pitch - 0.5 * pitch * double(n - 1));
        def.rotation = random.rotation();
        def.position -= Position(def.rotation * Vec3(bullet.center));
        def.linear_velocity = Vec3(cell.speed * random.direction());
        ids.push_back(add_bullet(world, bullet, def, material));
    }
    return ids;
}

} // namespace

int strike_before_wall(const Chance& cell) {
    Random random(cell.seed);
    int behind = 0;
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        const Material elastic = surface(0, 1);
        add_static(world, Box{{2, float(wall_thickness / 2), 2}}, {0, 0, 0}, elastic);
        BodyDef def;
        def.position = {0, wall_thickness / 2 + 0.3 + ball_radius, 0};
        const Body struck = world.body(add_body(world, Sphere{float(ball_radius)}, def, elastic));
        const double way = cell.speed * double(frame) * random.between(0, 1);
        def.position += Position(random.between(-0.3, 0.3) * ball_radius, 2.2 * ball_radius + way, 0);
        def.linear_velocity = {0, -float(cell.speed), 0};
        const Body striker = world.body(add_body(world, Sphere{float(ball_radius)}, def, elastic));
        bool is_behind = false;
        for (int i = 0; i < 4; ++i) {
            world.step(frame);
            const Position at = struck.position(), other = striker.position();
            is_behind = is_behind || (at.y < 0 && std::fabs(at.x) < 1.9) || (other.y < 0 && std::fabs(other.x) < 1.9);
        }
        behind += is_behind;
    }
    return behind;
}

Bounced bounce_between_walls(const Chance& cell) {
    Random random(cell.seed);
    Bounced bounced;
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        const Material elastic = surface(0, 1);
        const double side = 0.5 + wall_thickness / 2, free = 0.5 - ball_radius; // m; free: for the center
        for (const double sign : {-1.0, 1.0})
            add_static(world, Box{{2, float(wall_thickness / 2), 2}}, {0, sign * side, 0}, elastic);
        BodyDef def;
        const double start = random.between(-0.8, 0.8) * free;
        def.position = {0, start, 0};
        def.linear_velocity = {0, float(cell.speed), 0};
        const Body ball = world.body(add_body(world, Sphere{float(ball_radius)}, def, elastic));
        run(world, frame, 60);
        const double y = ball.position().y;
        if (std::fabs(y) > free + ball_radius) {
            ++bounced.escaped;
            continue;
        }
        // Unfolded, the path is a line; a period is one round trip.
        const double period = 4 * free, phase = std::fmod(start + free + cell.speed * world.time(), period);
        const double expected = (phase < 2 * free ? phase : period - phase) - free;
        const bool is_up = phase < 2 * free, is_near_wall = free - std::fabs(expected) < 0.05;
        const bool is_right_way = is_near_wall || (ball.linear_velocity().y > 0) == is_up;
        bounced.miscounted += std::fabs(y - expected) > 0.05 || !is_right_way;
    }
    return bounced;
}

double escape_room(const Room& cell) {
    Random random(cell.seed);
    int outside = 0;
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        const Material material = surface(0.6f, float(cell.restitution));
        add_room(world, cell, material);
        const std::vector<BodyId> ids = fill_room(world, cell, random, material);
        run(world, frame, int(cell.seconds * 60));
        for (const BodyId id : ids) {
            const Position at = glm::abs(world.body(id).center_of_mass());
            outside += !(std::max({at.x, at.y, at.z}) < cell.width / 2);
        }
    }
    return double(outside) / cell.shots;
}

double energy_of_room(const Room& cell) {
    Random random(cell.seed);
    double farthest = 0;
    for (int shot = 0; shot < cell.shots; ++shot) {
        WorldDef settings = without_gravity();
        settings.enable_sleep = false;
        World world(settings);
        const Material elastic = surface(0, 1);
        add_room(world, cell, elastic);
        fill_room(world, cell, random, elastic);
        const double start = energy(world);
        run(world, frame, int(cell.seconds * 60));
        const double change = energy(world) / start - 1;
        if (!(std::fabs(change) <= std::fabs(farthest))) farthest = change;
    }
    return farthest;
}

int push_through_floor(const Chance& cell) {
    Random random(cell.seed);
    int through = 0;
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        add_static(world, Box{{2, float(wall_thickness / 2), 2}}, {0, 0, 0}, surface(0.6f));
        BodyDef def;
        // The ball moves 0.25 to 0.3 m in the first step: some hit the floor in it, some in the next.
        def.position = {0, wall_thickness / 2 + ball_radius + random.between(0.05, 0.3), 0};
        Body ball = world.body(add_body(world, Sphere{float(ball_radius)}, def, surface(0.6f)));
        const Position direction = random.direction_near({0, -1, 0}, 30);
        ball.add_force(Vec3(double(ball.mass()) * cell.speed / double(frame) * direction));
        bool is_behind = false;
        for (int i = 0; i < 4; ++i) {
            world.step(frame);
            is_behind = is_behind || ball.position().y < 0;
        }
        through += is_behind;
    }
    return through;
}

int swing_paddle(const Chance& cell) {
    constexpr double length = 1, thickness = 0.01, depth = 0.2; // m
    Random random(cell.seed);
    int behind = 0;
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        const double rate = cell.speed / length;
        BodyDef def;
        def.type = BodyType::kinematic;
        def.angular_velocity = {0, 0, float(rate)};
        def.mass_properties = MassProperties{}; // it rotates about its end, not its center
        const BodyId paddle = world.create_body(def);
        ShapeDef shape;
        shape.position = {float(length / 2), 0, 0};
        world.add_shape(paddle, Box{{float(length / 2), float(thickness / 2), float(depth / 2)}}, shape);
        // The paddle begins along x and sweeps around; the ball rests somewhere in its path.
        const double at = random.between(0.3, 0.9) * length;
        const double furthest = std::min(2.5, 2 * rate * double(frame)); // rad; at most half a turn ahead
        const double angle = 0.2 + ball_radius / at + random.between(0, furthest);
        def = {};
        def.position = {at * std::cos(angle), at * std::sin(angle), random.between(-0.05, 0.05)};
        const Body ball = world.body(add_body(world, Sphere{float(ball_radius)}, def));
        // The ball counts as in front until it has left the reach of the paddle.
        bool is_behind = false, is_away = false;
        for (int i = 0; i < int((angle + 3) / (rate * double(frame))) && !is_away && !is_behind; ++i) {
            world.step(frame);
            const Position seen = glm::conjugate(glm::dquat(world.body(paddle).rotation())) * ball.position();
            is_away = std::hypot(seen.x, seen.y) > length - ball_radius;
            is_behind = !is_away && seen.y < 0;
        }
        behind += is_behind;
    }
    return behind;
}

int swing_rod(const Chance& cell) {
    constexpr double length = 1, thickness = 0.02, pole = 0.01; // m
    Random random(cell.seed);
    int past = 0;
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_gravity());
        const double turn = cell.speed * double(frame), at = random.between(0.3, 0.9) * length; // rad per step; m
        const double before = random.between(0.1, 0.1 + turn);
        BodyDef def;
        def.rotation = glm::angleAxis(float(-before), Vec3(0, 0, 1));
        def.position = Position(def.rotation * Vec3(float(length / 2), 0, 0));
        def.angular_velocity = {0, 0, float(cell.speed)};
        def.linear_velocity = glm::cross(def.angular_velocity, Vec3(def.position));
        const BodyId rod =
            add_body(world, Box{{float(length / 2), float(thickness / 2), float(thickness / 2)}}, def, surface(0.6f));
        world.create_joint(world.joint_at(BodyId{}, rod, {0, 0, 0}, {0, 0, 1}, BallJoint{}));
        add_static(world, Box{{float(pole / 2), float(pole / 2), 0.5f}}, {at, 0, 0}, surface(0.6f));
        // In these first steps the rod cannot have rotated by more than half a turn.
        bool is_past = false;
        for (int i = 0; i < 1 + int((before + 2) / turn) && !is_past; ++i) {
            world.step(frame);
            const Vec3 along = world.body(rod).rotation() * Vec3(1, 0, 0);
            is_past = std::atan2(along.y, along.x) > 0;
        }
        past += is_past;
    }
    return past;
}

} // namespace cairn_test
