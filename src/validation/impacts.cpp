// Sequences of impacts, and projectiles that must not tunnel through their targets (rows 29 and 30).
#include "validation/billiards.h"
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/random_starts.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace cairn::validation {
namespace {

constexpr std::uint32_t breaks = 60;
constexpr std::size_t impacts_followed = 10;
constexpr double cue_speed = 6; // m/s

// Fifteen balls of a rack, some millimeters apart so that they collide in pairs, and the cue ball.
std::vector<BilliardBall> rack(RandomStart& start, double radius) {
    std::vector<BilliardBall> balls;
    balls.push_back(
        {{start.uniform(-0.3, -0.2), start.uniform(-0.005, 0.005), start.uniform(-0.005, 0.005)}, {cue_speed, 0, 0}});
    const double spacing = 2 * radius + 0.006;
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i <= row; ++i) {
            const glm::dvec3 place(row * spacing * std::sqrt(0.75), 0, (i - 0.5 * row) * spacing);
            const auto off = [&] { return start.uniform(-0.001, 0.001); };
            const double x = off(), y = off();
            balls.push_back({place + glm::dvec3(x, y, off()), {0, 0, 0}});
        }
    return balls;
}

struct Deviation {
    double angle = 0, speed = 0; // degrees; relative to the initial speed of the cue ball
};

// Returns the deviation of the worst ball after the first impacts. The heading of a ball that hardly moves is ignored.
Deviation break_rack(std::uint32_t seed, double dt) {
    constexpr double radius = 0.028575, least_speed = 0.02 * cue_speed; // m, m/s
    RandomStart start(seed);
    const std::vector<BilliardBall> balls = rack(start, radius);
    Billiards exact(balls, radius);
    WorldDef settings = without_gravity();
    settings.enable_sleep = false;
    World world{settings};
    std::vector<BodyId> bodies;
    for (const BilliardBall& ball : balls) {
        BodyDef def;
        def.position = start.place(ball.position);
        def.linear_velocity = Vec3(start.turned(ball.velocity));
        def.mass = 0.17f;
        bodies.push_back(add_body(world, Sphere{float(radius)}, def, surface(0, 1)));
    }
    while (exact.impacts().size() < impacts_followed) {
        // Without further impacts nothing was measured.
        if (!std::isfinite(exact.until_next())) return {std::nan(""), std::nan("")};
        world.step(float(dt));
        exact.advance_to(world.time());
    }
    Deviation most;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const glm::dvec3 wanted = exact.balls()[i].velocity;
        const glm::dvec3 given = start.back(world.body(bodies[i]).linear_velocity());
        const double speed = glm::length(wanted);
        most.speed = std::max(most.speed, std::fabs(glm::length(given) - speed) / cue_speed);
        if (speed < least_speed) continue;
        const double angle = std::atan2(glm::length(glm::cross(given, wanted)), glm::dot(given, wanted)) / radians(1);
        if (!(angle <= most.angle)) most.angle = angle;
    }
    return most;
}

struct Bullet {
    const char* name;
    Shape shape;
    double reach; // m, farthest point from its center
};

std::array<Bullet, 4> bullets() {
    Capsule capsule;
    capsule.half_height = 0.06f;
    capsule.radius = 0.02f;
    const std::array<Vec3, 4> corners{
        {{0.05f, -0.03f, 0.03f}, {-0.05f, -0.03f, 0.03f}, {0, -0.03f, -0.05f}, {0, 0.06f, 0}}};
    return {{{"balls of 5 cm", Sphere{0.05f}, 0.05},
             {"boxes of 2 x 6 x 10 cm", Box{{0.01f, 0.03f, 0.05f}}, 0.06},
             {"capsules of 4 x 16 cm", capsule, 0.08},
             {"tetrahedra of 10 cm", Hull(corners), 0.07}}};
}

enum class Target { wall, mesh, plate };
constexpr std::array<const char*, 3> target_names{"a wall of 1 cm", "a triangle mesh", "a moving plate of 1 cm"};

constexpr double half_width = 2; // m, of the targets
constexpr int shots = 100;

BodyId add_target(World& world, Target target, const RandomStart& start) {
    const auto half = float(half_width);
    BodyDef def;
    def.position = start.place({0, 0, 0});
    def.rotation = Quat(start.rotation());
    if (target == Target::plate) {
        def.mass = 200.0f;
    } else {
        def.type = BodyType::static_;
    }
    if (target != Target::mesh) return add_body(world, Box{{half, 0.005f, half}}, def, surface(0.5f, 0.3f));
    const std::array<Vec3, 4> points{{{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}}};
    const std::array<std::uint32_t, 6> corners{0, 1, 2, 0, 2, 3};
    return add_body(world, Mesh(points, corners), def, surface(0.5f, 0.3f));
}

// Returns whether a body that is shot at the middle of a target comes out behind it.
bool gets_through(std::uint32_t seed, const Bullet& bullet, Target target, double speed, double dt) {
    RandomStart start(seed);
    WorldDef settings = without_gravity();
    settings.max_linear_speed = float(4 * speed);
    World world{settings};
    const BodyId wall = add_target(world, target, start);
    const glm::dvec3 goal(start.uniform(-0.3, 0.3), 0, start.uniform(-0.3, 0.3));
    const glm::dvec3 slope(start.uniform(-0.8, 0.8), -1, start.uniform(-0.8, 0.8)), way = glm::normalize(slope);
    const double distance = (bullet.reach + 0.01) / -way.y + speed * dt * start.uniform(0, 2);
    BodyDef def;
    def.position = start.place(goal - way * distance);
    def.rotation = RandomStart(seed + 1000).quat();
    def.linear_velocity = Vec3(start.turned(way * speed));
    def.angular_velocity = Vec3(start.turned({start.uniform(-30, 30), start.uniform(-30, 30), 0}));
    def.mass = 0.2f;
    const BodyId body = add_body(world, bullet.shape, def, surface(0.5f, 0.3f));
    for (int i = 0; i < 6; ++i) {
        world.step(float(dt));
        const Body plate = world.body(wall);
        const glm::dvec3 seen =
            glm::conjugate(glm::dquat(plate.rotation())) * (world.body(body).center_of_mass() - plate.position());
        const bool is_beside = std::max(std::fabs(seen.x), std::fabs(seen.z)) > half_width - bullet.reach;
        if (seen.y < 0) return !is_beside;
        if (is_beside) return false; // the body slides or bounces off to the side
    }
    return false;
}

} // namespace

Result measure_billiards() {
    constexpr double greatest_angle = 0.5, greatest_speed = 0.005;
    Result result;
    Plot plot{"Sixteen balls after ten impacts", "start", "greatest error of a direction, degrees", false, true, {}};
    for (const double dt : time_steps) {
        int kept = 0;
        Curve curve{"dt = " + step_text(dt) + " s", {}, {}, true};
        for (std::uint32_t seed = 0; seed < breaks; ++seed) {
            const Deviation most = break_rack(seed, dt);
            kept += most.angle <= greatest_angle && most.speed <= greatest_speed;
            curve.x.push_back(seed);
            curve.y.push_back(most.angle);
        }
        result.rows.push_back({"16 balls, 10 impacts, 60 breaks: fraction with all directions within 0.5 degrees and "
                               "all speeds within 0.5 % of the initial speed",
                               dt, 1, double(kept) / breaks, 0.95, Bar::at_least});
        plot.curves.push_back(curve);
    }
    result.plots.push_back(plot);
    return result;
}

Result measure_shots() {
    Result result;
    Plot plot{"Bodies that pass through, of 10,000", "speed, m/s", "passed through", true, false, {}};
    for (const Target target : {Target::wall, Target::mesh, Target::plate}) {
        for (const Bullet& bullet : bullets()) {
            Curve curve{std::string(bullet.name) + ", " + target_names[std::size_t(target)], {}, {}};
            for (const double speed : {10.0, 100.0, 1000.0}) {
                int lost = 0;
                for (int shot = 0; shot < shots; ++shot)
                    lost += gets_through(std::uint32_t(shot), bullet, target, speed, time_steps[0]);
                const double share = 1e4 * lost / shots;
                result.rows.push_back({std::string(bullet.name) + " at " + text(speed) + " m/s at " +
                                           target_names[std::size_t(target)] + ", " + std::to_string(shots) +
                                           " shots: passed through, of 10,000",
                                       time_steps[0], 0, share, 0, Bar::at_most});
                curve.x.push_back(speed);
                curve.y.push_back(share);
            }
            plot.curves.push_back(curve);
        }
    }
    result.plots.push_back(plot);
    return result;
}

} // namespace cairn::validation
