// Bodies that collide with each other: whether they do, the velocities after the impact, and the energy.
#include "cells.h"
#include "validation/billiards.h"

namespace cairn_test {
namespace {

using cairn::validation::BilliardBall;
using cairn::validation::Billiards;

WorldDef awake() {
    WorldDef settings = without_gravity();
    settings.enable_sleep = false;
    return settings;
}

// Adds the same balls to a world, frictionless and elastic.
std::vector<BodyId> add_balls(World& world, const std::vector<BilliardBall>& balls, double radius) {
    std::vector<BodyId> ids;
    for (const BilliardBall& ball : balls) {
        BodyDef def;
        def.position = ball.position;
        def.linear_velocity = Vec3(ball.velocity);
        Material material = surface(0, 1);
        material.torsional_friction = 0;
        ids.push_back(add_body(world, Sphere{float(radius)}, def, material));
    }
    return ids;
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / radians(1);
}

// Draws balls at random positions in a unit cube, without contact.
std::vector<BilliardBall> draw_gas(const GasCell& cell, Random& random) {
    std::vector<BilliardBall> balls;
    while (int(balls.size()) < cell.balls) {
        const Position place(random.uniform(), random.uniform(), random.uniform());
        bool is_free = true;
        for (const BilliardBall& ball : balls)
            is_free = is_free && glm::length(ball.position - place) > 2.001 * cell.radius;
        if (is_free) balls.push_back({place, Position(Vec3(cell.speed * random.direction()))});
    }
    return balls;
}

// The difference of two outcomes.
struct Difference {
    double angle = 0; // degrees, of balls that are not slow
    double speed = 0; // relative; for slow balls relative to the slow speed

    void add(const glm::dvec3& expected, const glm::dvec3& measured, double slow) {
        const double length = glm::length(expected);
        if (length > slow) {
            angle = std::max(angle, degrees_between(expected, measured));
            speed = std::max(speed, std::fabs(glm::length(measured) / length - 1));
        } else {
            speed = std::max(speed, glm::length(measured - expected) / slow);
        }
    }
};

constexpr double slow_ball = 0.05; // of the cue ball's speed; slower balls have no meaningful angle
constexpr int counted_impacts = 10;
constexpr double angle_bar = 0.5, speed_bar = 0.005; // degrees; relative

// Fifteen balls at rest, loosely spaced, and a cue ball.
std::vector<BilliardBall> draw_game(const BilliardsCell& cell, double radius, Random& random) {
    std::vector<BilliardBall> balls;
    const double pitch = 3 * radius, loose = 0.35 * radius;
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i <= row; ++i) {
            Position at(row * pitch * std::sqrt(0.75), (i - 0.5 * row) * pitch, 0);
            at += Position(random.between(-loose, loose), random.between(-loose, loose), 0);
            if (!cell.is_planar) at.z += random.between(-loose, loose);
            balls.push_back({at, {0, 0, 0}});
        }
    const double start = 4 * radius + cell.speed * double(frame) * random.uniform();
    const Position from(-start, random.between(-radius, radius), cell.is_planar ? 0 : random.between(-radius, radius));
    balls.push_back({from, {cell.speed, 0, 0}});
    return balls;
}

// Whether single precision can play the game: the slightly disturbed exact game ends within a tenth of the bar, and no
// impact is so close to the time of comparison that only one of the two may have had it.
bool is_well_conditioned(const std::vector<BilliardBall>& start, double radius, const Billiards& end, double slow,
                         double disturbance, Random& random) {
    std::vector<BilliardBall> aside = start;
    for (BilliardBall& ball : aside) {
        ball.position += disturbance * radius * random.direction();
        ball.velocity += disturbance * glm::length(ball.velocity) * random.direction();
    }
    Billiards other(aside, radius);
    other.advance_to(end.time());
    if (other.impacts().size() != end.impacts().size()) return false;
    Difference difference;
    for (std::size_t i = 0; i < start.size(); ++i)
        difference.add(end.balls()[i].velocity, other.balls()[i].velocity, slow);
    const double margin = 0.01 * radius / (slow / slow_ball); // s in which the cue ball moves a hundredth of its radius
    const bool is_clear = end.until_next() > margin && end.time() - end.impacts().back() > margin;
    return is_clear && difference.angle < angle_bar / 10 && difference.speed < speed_bar / 10;
}

} // namespace

Changes step_gas(const GasCell& cell) {
    Random random(cell.seed);
    Changes changes;
    for (int shot = 0; shot < cell.shots; ++shot) {
        const std::vector<BilliardBall> start = draw_gas(cell, random);
        Billiards exact(start, cell.radius);
        exact.advance_to(double(frame));
        World world(awake());
        const std::vector<BodyId> ids = add_balls(world, start, cell.radius);
        world.step(frame);
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const Position expected = exact.balls()[i].velocity, measured(world.body(ids[i]).linear_velocity());
            const bool is_due = glm::length(expected - start[i].velocity) > 1e-4 * cell.speed;
            const bool is_changed = glm::length(measured - start[i].velocity) > 1e-4 * cell.speed;
            changes.right += is_due && is_changed;
            changes.false_ += !is_due && is_changed;
            changes.missing += is_due && !is_changed;
            changes.worst_error = std::max(changes.worst_error, glm::length(measured - expected) / cell.speed);
        }
    }
    return changes;
}

Oblique hit_obliquely(const Chance& cell) {
    constexpr double radius = 0.05, offset = 0.6; // m; relative to the diameter
    Random random(cell.seed);
    Oblique worst;
    for (int shot = 0; shot < cell.shots; ++shot) {
        const double way = 2 * radius + cell.speed * double(frame) * random.between(0.01, 2);
        const std::vector<BilliardBall> start = {{{-way, offset * 2 * radius, 0}, {cell.speed, 0, 0}}, {}};
        Billiards exact(start, radius);
        exact.to_next_impact();
        World world(awake());
        const std::vector<BodyId> ids = add_balls(world, start, radius);
        run(world, frame, 1 + int(std::ceil(exact.time() / double(frame))));
        double error = 0;
        for (std::size_t i = 0; i < 2; ++i)
            error = std::max(error,
                             glm::length(Position(world.body(ids[i]).linear_velocity()) - exact.balls()[i].velocity) /
                                 cell.speed);
        worst.velocity_error = std::max(worst.velocity_error, error);
        worst.mean_error += error / cell.shots;
        const double before = 0.5 * double(world.body(ids[0]).mass()) * cell.speed * cell.speed;
        worst.energy_error = std::max(worst.energy_error, std::fabs(world.kinetic_energy() / before - 1));
    }
    return worst;
}

HeadOn meet_head_on(const Chance& cell) {
    Random random(cell.seed);
    HeadOn result;
    for (; result.shots < cell.shots; ++result.shots) {
        const double size = random.between(0.02, 0.2);
        const double way = std::sqrt(3.0) * size / 2 + 0.001 + cell.speed * double(frame) * random.between(0, 2);
        World world(without_gravity());
        std::vector<BodyId> ids;
        for (const double sign : {-1.0, 1.0}) {
            BodyDef def;
            def.position = {sign * way, 0, 0};
            def.rotation = random.rotation();
            def.linear_velocity = {float(-sign * cell.speed), 0, 0};
            ids.push_back(add_body(world, Box{Vec3(float(size / 2))}, def));
        }
        run(world, frame, 2 + int(way / (cell.speed * double(frame))));
        const Body a = world.body(ids[0]), b = world.body(ids[1]);
        const double kept = double(a.linear_velocity().x - b.linear_velocity().x) / (2 * cell.speed);
        result.missed += a.position().x > b.position().x && kept > 0.99;
    }
    return result;
}

Range energy_of_meeting(Kind kind, const Chance& cell) {
    Random random(cell.seed);
    Range range;
    const Bullet bullet = make_bullet(kind, 0.1);
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(awake());
        const double way = bullet.reach + 0.001 + cell.speed * double(frame) * random.between(0, 1);
        for (const double sign : {-1.0, 1.0}) {
            BodyDef def;
            def.position = {sign * way, random.between(-0.05, 0.05), random.between(-0.05, 0.05)};
            def.rotation = random.rotation();
            def.linear_velocity = {float(-sign * cell.speed), 0, 0};
            def.angular_velocity = Vec3(10.0 * random.direction());
            add_bullet(world, bullet, def, surface(0, 1));
        }
        const double before = world.kinetic_energy();
        run(world, frame, 4 + int(way / (cell.speed * double(frame))));
        const double change = world.kinetic_energy() / before - 1;
        range = {std::min(range.least, change), std::max(range.most, change)};
    }
    return range;
}

Range energy_of_bouncing(const Bouncing& cell) {
    Random random(cell.seed);
    Range range;
    const Bullet bullet = make_bullet(cell.kind, cell.size);
    for (int shot = 0; shot < cell.shots; ++shot) {
        World world(without_sleep());
        add_ground(world, surface(0, 1));
        BodyDef def;
        def.position = {0, 1 + bullet.reach, 0};
        def.rotation = random.rotation();
        add_bullet(world, bullet, def, surface(0, 1));
        const double before = world.kinetic_energy() + world.potential_energy();
        for (int i = 0; i < int(cell.seconds * 60); ++i) {
            world.step(frame);
            const double change = (world.kinetic_energy() + world.potential_energy()) / before - 1;
            range = {std::min(range.least, change), std::max(range.most, change)};
        }
    }
    return range;
}

BilliardsResult play_billiards(const BilliardsCell& cell) {
    constexpr double radius = 0.0285; // m
    Random random(cell.seed);
    BilliardsResult result;
    const double slow = slow_ball * cell.speed;
    while (result.games < cell.shots && result.skipped < 50 * cell.shots) {
        const std::vector<BilliardBall> start = draw_game(cell, radius, random);
        Billiards exact(start, radius);
        bool has_all = true;
        for (int i = 0; i < counted_impacts && has_all; ++i) has_all = exact.to_next_impact();
        // Compared at the end of the step that contains the last impact.
        const int steps = int(std::ceil(exact.time() / double(frame)));
        exact.advance_to(steps * double(frame));
        if (!has_all || !is_well_conditioned(start, radius, exact, slow, cell.disturbance, random)) {
            ++result.skipped;
            continue;
        }
        ++result.games;
        WorldDef settings = awake();
        settings.restitution_speed = 0; // as in the exact game
        World world(settings);
        const std::vector<BodyId> ids = add_balls(world, start, radius);
        run(world, frame, steps);
        Difference difference;
        for (std::size_t i = 0; i < ids.size(); ++i)
            difference.add(exact.balls()[i].velocity, Position(world.body(ids[i]).linear_velocity()), slow);
        result.differ += !(difference.angle <= angle_bar && difference.speed <= speed_bar);
        result.worst_angle = std::max(result.worst_angle, difference.angle);
        result.worst_speed = std::max(result.worst_speed, difference.speed);
    }
    return result;
}

} // namespace cairn_test
