// Scenes with published results: the benchmarks of SimBenchmark (J. Hwangbo, D. Kang and others, 2018;
// github.com/leggedrobotics/SimBenchmark). Scenes and measures follow its sources, with y up; the published numbers are
// from its data files, at the same time step.
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <algorithm>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace cairn::validation {
namespace {

constexpr double dt = 0.001; // s, for all scenes except Kapla
constexpr const char* source = "SimBenchmark, 2018";

// A box of 20 x 1 x 20 m and 10 kg with 5 x 5 balls on it, pushed with 150 N along `heading` (degrees).
struct RollingScene {
    static constexpr double force = 150, box_mass = 10, ball_mass = 1, box_friction = 0.4;
    World world{without_sleep()};
    glm::dvec3 along;
    BodyId box, ball; // `ball` is one of the 25

    RollingScene(double heading, double overlap) // initial penetration, m
        : along(std::cos(radians(heading)), 0, std::sin(radians(heading))) {
        add_ground(world, material(0.5f)); // coefficients multiply: 0.5 x 0.8 below the box, 1.0 x 0.8 below the balls
        BodyDef def;
        def.mass = float(box_mass);
        def.position = {0, 0.5 - overlap, 0};
        box = add_body(world, Box{{10, 0.5f, 10}}, def, material(0.8f));
        def.mass = float(ball_mass);
        for (int i = 0; i < 25; ++i) {
            def.position = {i / 5 * 2.0 - 4, 1.5 - 3 * overlap, i % 5 * 2.0 - 4};
            const BodyId body = add_body(world, Sphere{0.5f}, def, material(1));
            if (i == 0) ball = body;
        }
    }
    static Material material(float friction) {
        Material result = surface(friction);
        result.friction_combine = CombineRule::multiply;
        return result;
    }
    // The pushing force minus the friction of the ground accelerates the box and, by a force f at each contact, the
    // balls, which roll without slipping: their surface has 7/2 of the acceleration f / m of their centers.
    static double box_acceleration() { return 3.5 * ball_acceleration(); }
    static double ball_acceleration() {
        const double through = force - box_friction * (box_mass + 25 * ball_mass) * gravity;
        return through / box_mass / (3.5 / ball_mass + 25 / box_mass) / ball_mass;
    }
    void step() {
        world.body(box).add_force(Vec3(force * along));
        world.step(float(dt));
    }
    glm::dvec3 velocity(BodyId body) { return glm::dvec3(world.body(body).linear_velocity()); }
};

// The mean squared error of the velocities of box and ball together, over 4 s, m^2/s^2.
double mean_squared_error(double heading, double overlap, Plot* plot = nullptr) {
    RollingScene scene(heading, overlap);
    constexpr int steps = 4000;
    double sum = 0;
    Curve box{"box", {}, {}, true}, ball{"ball", {}, {}, true};
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 box_error =
            scene.velocity(scene.box) - RollingScene::box_acceleration() * i * dt * scene.along;
        const glm::dvec3 ball_error =
            scene.velocity(scene.ball) - RollingScene::ball_acceleration() * i * dt * scene.along;
        sum += glm::dot(box_error, box_error) + glm::dot(ball_error, ball_error);
        if (plot && i % 200 == 0) {
            for (Curve* curve : {&box, &ball}) curve->x.push_back(i * dt);
            box.y.push_back(glm::dot(scene.velocity(scene.box), scene.along));
            ball.y.push_back(glm::dot(scene.velocity(scene.ball), scene.along));
        }
        scene.step();
    }
    if (plot) plot->curves = {box, ball};
    return sum / steps;
}

} // namespace

Result measure_rolling_benchmark() {
    Result result;
    Plot speeds{"Balls on a pushed box, force at 60 degrees", "time, s", "speed, m/s", false, false, {}};
    Plot errors{
        "Error for each direction of the force", "heading, degrees", "mean squared error, m^2/s^2", false, true, {}};
    Curve seen{"Cairn", {}, {}, true};
    constexpr double overlap = 2e-5; // m
    double worst = 0, along_side = 0, across = 0, touching = 0;
    for (int heading = 0; heading < 360; heading += 15) {
        const double error = mean_squared_error(heading, overlap, heading == 60 ? &speeds : nullptr);
        if (!(error <= worst)) worst = error;
        if (heading == 90) along_side = error;
        if (heading == 60) across = error;
        seen.x.push_back(heading);
        seen.y.push_back(error);
    }
    const std::string name = "mean squared error of the velocities, m^2/s^2, ";
    for (const double heading : {0.0, 15.0, 45.0, 60.0, 90.0}) {
        const double error = mean_squared_error(heading, 0);
        if (!(error <= touching)) touching = error;
    }
    const std::string start = "the initial overlap of 0.02 mm is pushed out in a few ms: while the balls lift off, "
                              "friction with the ground is low, and the box keeps the 7 mm/s that it gains meanwhile";
    const std::string rest = "in the first step the weight of the balls acts on the ground late (1.5 mm/s); later "
                             "float velocities are rounded 24,000 times in the same direction (up to 6 mm/s)";
    constexpr double known = 1.5e-4;
    result.rows = {
        {name + "force along a side", dt, 0, along_side, 1e-6, Bar::at_most, start, known},
        {name + "force at 60 degrees", dt, 0, across, 1e-6, Bar::at_most, start, known},
        {name + "the worst of 24 directions", dt, 0, worst, 1e-6, Bar::at_most, start, known},
        {name + "no initial overlap, the worst of 5 directions", dt, 0, touching, 1e-6, Bar::at_most, rest, known}};
    speeds.curves.push_back({"box, closed form", {0, 4}, {0, 4 * RollingScene::box_acceleration()}});
    speeds.curves.push_back({"ball, closed form", {0, 4}, {0, 4 * RollingScene::ball_acceleration()}});
    errors.curves = {seen,
                     {"RaiSim", {90, 60}, {4.1e-7, 4.1e-7}, true},
                     {"Bullet", {90, 60}, {4.9e-9, 5.7e-9}, true},
                     {"ODE", {90, 60}, {7.7e-9, 3.14}, true}};
    result.plots = {speeds, errors};
    const std::string side = name + "force along a side", diagonal = name + "force at 60 degrees";
    for (const auto& [engine, first, second] : {std::tuple{"Bullet", "4.9e-9", "5.7e-9"},
                                                {"RaiSim", "4.1e-7", "4.1e-7"},
                                                {"MuJoCo (CG, RK4)", "2.4e-3", "2.4e-3"},
                                                {"ODE (quick)", "7.7e-9", "3.145 (does not move)"},
                                                {"DART (Dantzig)", "0.426", "3.145 (does not move)"}}) {
        result.published.push_back({side, engine, first, source});
        result.published.push_back({diagonal, engine, second, source});
    }
    return result;
}

namespace {

// 7 x 7 elastic balls of 10 kg dropped from 5 m, for 20 s. Root mean square errors of the energy relative to its
// initial value.
struct Bouncing {
    double as_it_is = 0;    // from the positions and speeds that the world reports
    double of_parabola = 0; // with the speeds of half a substep later, which match the positions of the Euler method
    Curve curve;

    explicit Bouncing(Integrator integrator, std::string label) : curve{std::move(label), {}, {}} {
        WorldDef settings;
        settings.integrator = integrator;
        World world(settings);
        add_ground(world, surface(0, 1));
        BodyDef def;
        def.mass = 10.0f;
        std::vector<BodyId> balls;
        for (int i = 0; i < 49; ++i) {
            def.position = {i / 7 * 2.0, 5, i % 7 * 2.0};
            balls.push_back(add_body(world, Sphere{0.1f}, def, surface(0, 1)));
        }
        const double start = 49 * 10 * gravity * 5, gain = 0.5 * gravity * dt / world.usual_substeps(float(dt));
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i) {
            double momentum = 0; // upward
            for (const BodyId ball : balls) momentum += 10 * double(world.body(ball).linear_velocity().y);
            const double error = (world.kinetic_energy() + world.potential_energy()) / start - 1;
            const double shifted = error + (490 * 0.5 * gain - momentum) * gain / start;
            as_it_is += error * error;
            of_parabola += shifted * shifted;
            if (i % 50 == 0) {
                curve.x.push_back(i * dt);
                curve.y.push_back(error);
            }
            world.step(float(dt));
        }
        as_it_is = std::sqrt(as_it_is / steps);
        of_parabola = std::sqrt(of_parabola / steps);
    }
};

} // namespace

Result measure_bouncing_benchmark() {
    Result result;
    const std::string name = "root mean square error of the energy over the initial energy";
    const Bouncing rk4(Integrator::rk4, "Runge-Kutta 4"), euler(Integrator::semi_implicit_euler, "semi-implicit Euler");
    result.rows = {
        {name + ", Runge-Kutta 4", dt, 0, rk4.as_it_is, 5.7e-6, Bar::at_most},
        {name + ", semi-implicit Euler, velocities of half a substep later", dt, 0, euler.of_parabola, 5.7e-6,
         Bar::at_most,
         "with the velocities as they are " + text(euler.as_it_is) + ": the error is g h v / 2, but bounded"}};
    result.plots.push_back({"Energy of 49 elastic balls",
                            "time, s",
                            "error of the energy over the initial energy",
                            false,
                            false,
                            {rk4.curve, euler.curve}});
    result.published = {{name, "RaiSim", "5.7e-6", source},
                        {name, "ODE", "5.7e-4", source},
                        {name, "DART", "1.1e-2", source},
                        {name, "Bullet", "1.1e-2", source}};
    return result;
}

namespace {

// 6 x 6 x 6 balls of 10 kg without friction and restitution that fall in a heap. Returns the mean over 10 s of the sum
// of the squared penetrations, m^2.
double pile_error(unsigned seed, Curve& curve) {
    constexpr double radius = 0.1;
    World world(without_sleep());
    add_ground(world, surface(0));
    std::mt19937 random(seed);
    auto jitter = [&random] { return 0.001 * double(random() % 100001) / 100000; };
    std::vector<BodyId> balls;
    BodyDef def;
    def.mass = 10.0f;
    for (int i = 0; i < 216; ++i) {
        const double x = 0.21 * (i / 36) + jitter(), z = 0.21 * (i / 6 % 6) + jitter();
        def.position = {x, 0.101 + 0.21 * (i % 6) + jitter(), z};
        balls.push_back(add_body(world, Sphere{float(radius)}, def, surface(0)));
    }
    std::vector<Transform> places(balls.size());
    constexpr int steps = 10000;
    double sum = 0;
    std::size_t contacts = 0; // the greatest number at a time
    for (int step = 0; step < steps; ++step) {
        world.read_transforms(balls, places);
        double squares = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Position& a = places[i].position;
            const double below = std::max(0.0, radius - a.y);
            squares += below * below;
            for (std::size_t k = i + 1; k < places.size(); ++k) {
                const glm::dvec3 way = places[k].position - a;
                const double apart = glm::dot(way, way);
                if (apart >= 4 * radius * radius) continue;
                const double overlap = 2 * radius - std::sqrt(apart);
                squares += overlap * overlap;
            }
        }
        sum += squares;
        if (step % 25 == 0) {
            curve.x.push_back(step * dt);
            curve.y.push_back(std::max(squares, 1e-15));
            contacts = std::max(contacts, world.statistics().contacts);
        }
        world.step(float(dt));
    }
    return contacts > balls.size() ? sum / steps : std::nan(""); // with fewer contacts the balls were never a pile
}

} // namespace

Result measure_pile_benchmark() {
    Result result;
    Plot plot{"Overlaps in a pile of 216 balls", "time, s", "sum of the squared overlaps, m^2", false, true, {}};
    double worst = 0;
    for (const unsigned seed : {1u, 2u, 3u}) {
        Curve curve{"start " + std::to_string(seed), {}, {}};
        const double error = pile_error(seed, curve);
        if (!(error <= worst)) worst = error;
        plot.curves.push_back(curve);
    }
    const std::string name = "mean over 10 s of the sum of the squared overlaps, m^2";
    result.rows = {{name + ", the worst of 3 starts", dt, 0, worst, 1.35e-4, Bar::at_most}};
    result.plots.push_back(plot);
    result.published = {{name, "RaiSim", "1.35e-4", source},
                        {name, "ODE", "1.55e-4", source},
                        {name, "DART", "2.8e-4", source},
                        {name, "MuJoCo", "9.5e-2", source},
                        {name, "Bullet", "0.38", source}};
    return result;
}

namespace {

// A tower of six storeys, each of 17 blocks of 10 kg.
struct Kapla {
    static constexpr int storeys = 6, columns = 8;
    World world{without_sleep()};
    std::vector<BodyId> blocks;

    Kapla() {
        add_ground(world);
        constexpr double across = 0.2; // between neighboring columns, m
        for (int storey = 0; storey < storeys; ++storey) {
            const double floor = 0.2 * storey;
            for (int i = 0; i < columns; ++i) add({i * across, floor + 0.05, 0}, {0.025f, 0.05f, 0.125f});
            auto wall = [&](double x, double side) { add({x, floor + 0.15, side * 0.1}, {0.1f, 0.05f, 0.025f}); };
            for (int i = 0; i < columns / 2; ++i) wall(2 * i * across + 0.1, -1);
            for (int i = 0; i < columns / 2 - 1; ++i) wall(2 * i * across + 0.3, 1);
            wall(0.1, 1);
            wall((columns / 2 - 1) * 2 * across + 0.1, 1);
        }
    }
    void add(const Position& position, const Vec3& half_extents) {
        BodyDef def;
        def.mass = 10.0f;
        def.position = position;
        blocks.push_back(add_body(world, Box{half_extents}, def));
    }
    bool stands() { return world.body(blocks.back()).position().y >= 0.2 * (storeys - 1); }
};

} // namespace

Result measure_kapla_benchmark() {
    Result result;
    constexpr double step = 0.01;
    constexpr int steps = 60000;
    Kapla tower;
    Plot plot{"A Kapla tower of 102 blocks", "time, s", "displacement of the last block, mm", false, false, {}};
    plot.curves.push_back({"Cairn", {}, {}});
    const Position start = tower.world.body(tower.blocks.back()).position();
    int stood = 0;
    double overlap = 0;
    for (; stood < steps && tower.stands(); ++stood) {
        tower.world.step(float(step));
        if (stood % 200 != 0) continue;
        overlap = std::max(overlap, deepest_overlap(tower.world));
        plot.curves[0].x.push_back((stood + 1) * step);
        plot.curves[0].y.push_back(1000 * glm::distance(tower.world.body(tower.blocks.back()).position(), start));
    }
    const std::string name = "steps for which the tower stands, of 60,000";
    const double way = glm::distance(tower.world.body(tower.blocks.back()).position(), start);
    result.rows = {{name, step, steps, double(stood), steps, Bar::at_least, "without sleeping"},
                   {"deepest overlap, m", step, 0, overlap, 0.01, Bar::at_most},
                   {"displacement of the last block, m", step, 0, way, 0.01, Bar::at_most}};
    result.plots.push_back(plot);
    result.published = {{name, "RaiSim, 1,000 iterations", "60,000", source},
                        {name, "Bullet, 1,000 iterations", "55,058", source},
                        {name, "ODE, 1,000 iterations", "6,453", source},
                        {name, "MuJoCo", "3,297", source},
                        {name, "DART", "19", source}};
    return result;
}

} // namespace cairn::validation
