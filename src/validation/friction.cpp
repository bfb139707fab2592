// Sticking, sliding, tipping, rolling and spinning on slopes and on level ground (rows 8 to 12, 16 and 24).
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <string>

namespace cairn::validation {
namespace {

constexpr float radius = 0.5f;    // of the rolling bodies, m
constexpr double roll_angle = 30; // degrees

// A rolling body, whose moment of inertia about its axis is `inertia` m r^2.
struct Roller {
    const char* name;
    double inertia;
    Shape shape;
    Quat rotation; // turns its axis to z
};
const Roller rollers[] = {
    {"ball", 2.0 / 5, Sphere{radius}, {1, 0, 0, 0}},
    {"cylinder", 1.0 / 2, Cylinder{0.5f, radius, {}}, glm::angleAxis(float(pi / 2), Vec3(1, 0, 0))},
};

// A body at rest on a slope, with its center `height` above the slope.
struct OnSlope {
    World world{without_sleep()};
    Slope slope;
    BodyId id;
    Position start;

    OnSlope(double degrees, double friction, const Shape& shape, double height, const Quat& rotation = {1, 0, 0, 0})
        : slope{radians(degrees)} {
        slope.add_to(world, surface(float(friction)));
        BodyDef def;
        def.position = start = height * slope.normal();
        def.rotation = slope.rotation() * rotation;
        id = add_body(world, shape, def, surface(float(friction)));
    }
    double way() { return glm::dot(world.body(id).position() - start, slope.downhill()); }
    double speed() { return glm::dot(glm::dvec3(world.body(id).linear_velocity()), slope.downhill()); }
    // Tangential speed of the body's surface relative to the slope at the contact point of a rolling body.
    double slip() { return speed() + double(world.body(id).angular_velocity().z) * double(radius); }
    double tilt() { // relative to the slope, rad
        const glm::dvec3 up(world.body(id).rotation() * Vec3(0, 1, 0));
        return std::acos(std::min(1.0, glm::dot(up, slope.normal())));
    }
};

OnSlope on_slope(const Roller& roller, double friction) {
    return {roll_angle, friction, roller.shape, double(radius), roller.rotation};
}

OnSlope cube_on_slope(double degrees, double friction) { return {degrees, friction, Box{{0.5f, 0.5f, 0.5f}}, 0.5}; }

glm::dvec3 direction(double degrees) { return {std::cos(radians(degrees)), 0, std::sin(radians(degrees))}; }

} // namespace

Result measure_rolling_down() {
    Result result;
    Plot plot{"Rolling down 30 degrees", "time, s", "speed, m/s", false, false, {}};
    for (const Roller& roller : rollers) {
        const std::string name = roller.name;
        const double acceleration = gravity * std::sin(radians(roll_angle)) / (1 + roller.inertia);
        for (const double dt : time_steps) {
            OnSlope scene = on_slope(roller, 0.6);
            Curve curve{name + ", dt = " + step_text(dt) + " s", {}, {}, true};
            const int half = steps_in(0.5, dt);
            double first = 0;
            for (int i = 1; i <= 3 * half; ++i) {
                scene.world.step(float(dt));
                if (i == half) first = scene.speed();
                if (i % std::max(1, half / 10) == 0) {
                    curve.x.push_back(i * dt);
                    curve.y.push_back(scene.speed());
                }
            }
            const double t = 3 * half * dt;
            result.rows.push_back(
                {name + ": acceleration, m/s^2", dt, acceleration, (scene.speed() - first) / (2 * half * dt), 0.005});
            result.rows.push_back(
                {name + ": distance in 1.5 s, m", dt, 0.5 * acceleration * t * t, scene.way(), 0.005});
            if (dt == time_steps[0]) plot.curves.push_back(curve);
        }
        plot.curves.push_back({name + ", closed form", {0, 1.5}, {0, 1.5 * acceleration}});
    }
    result.plots.push_back(plot);
    return result;
}

Result measure_roll_or_slip() {
    Result result;
    Plot plot{"Rolling or slipping on 30 degrees", "coefficient of friction", "slip after 2 s, m/s", false, false, {}};
    const double sine = std::sin(radians(roll_angle)), cosine = std::cos(radians(roll_angle));
    for (const Roller& roller : rollers) {
        // The slip grows at the rate g (sin - mu cos) - mu g cos / inertia.
        const double levers = 1 + 1 / roller.inertia;
        const double least = sine / cosine / levers;
        auto slip = [&roller](double friction, double dt) {
            OnSlope scene = on_slope(roller, friction);
            run(scene.world, float(dt), steps_in(2, dt));
            return scene.slip();
        };
        for (const double dt : time_steps) {
            const double found = last_where(0.5 * least, 1.5 * least, 2e-4 * least,
                                            [&](double friction) { return std::fabs(slip(friction, dt)) > 0.001; });
            result.rows.push_back({std::string(roller.name) + ": least friction to roll", dt, least, found, 0.02});
        }
        Curve seen{std::string(roller.name) + ", dt = " + step_text(time_steps[0]) + " s", {}, {}, true};
        Curve law{std::string(roller.name) + ", closed form", {}, {}};
        for (int i = 0; i <= 24; ++i) {
            const double friction = (0.4 + 0.05 * i) * least;
            seen.x.push_back(friction);
            seen.y.push_back(slip(friction, time_steps[0]));
            law.x.push_back(friction);
            law.y.push_back(2 * gravity * std::max(0.0, sine - levers * friction * cosine));
        }
        plot.curves.insert(plot.curves.end(), {seen, law});
    }
    result.plots.push_back(plot);
    return result;
}

Result measure_slope() {
    Result result;
    const double friction = std::tan(radians(30));
    auto way = [friction](double degrees, double dt) { // in 2 s
        OnSlope scene = cube_on_slope(degrees, friction);
        run(scene.world, float(dt), steps_in(2, dt));
        return scene.way();
    };
    for (const double dt : time_steps) {
        // A sliding box moves more than 5 mm in 2 s from 0.013 degrees beyond the limit.
        const double sticks = last_where(25, 35, 0.01, [&](double degrees) { return way(degrees, dt) < 0.005; });
        result.rows.push_back(
            {"steepest slope on which a box sticks at mu = tan 30, degrees", dt, 30, sticks, 0.5, Bar::absolute});
        OnSlope below = cube_on_slope(29.5, friction);
        run(below.world, float(dt), steps_in(3, dt)); // lets the box settle
        const double settled = below.way();
        run(below.world, float(dt), steps_in(60, dt));
        result.rows.push_back(
            {"creep at 29.5 degrees, m/min", dt, 0, std::fabs(below.way() - settled), 0.001, Bar::at_most});
        OnSlope sliding = cube_on_slope(30, 0.2);
        run(sliding.world, float(dt), steps_in(0.25, dt));
        const double first = sliding.speed();
        run(sliding.world, float(dt), steps_in(1, dt));
        const double expected = gravity * (std::sin(radians(30)) - 0.2 * std::cos(radians(30)));
        result.rows.push_back({"acceleration on 30 degrees at mu = 0.2, m/s^2", dt, expected,
                               (sliding.speed() - first) / (steps_in(1, dt) * dt), 0.01});
    }
    Plot plot{"A box on a slope, mu = tan 30 degrees", "slope, degrees", "distance in 2 s, m", false, false, {}};
    plot.curves = {{"dt = " + step_text(time_steps[0]) + " s", {}, {}, true}, {"closed form", {}, {}}};
    for (double degrees = 28; degrees <= 32; degrees += 0.125) {
        const double a = gravity * (std::sin(radians(degrees)) - friction * std::cos(radians(degrees)));
        for (Curve& curve : plot.curves) curve.x.push_back(degrees);
        plot.curves[0].y.push_back(way(degrees, time_steps[0]));
        plot.curves[1].y.push_back(0.5 * std::max(0.0, a) * 4);
    }
    result.plots.push_back(plot);
    return result;
}

Result measure_tipping() {
    Result result;
    for (const double dt : time_steps) {
        const double stands = last_where(40, 50, 0.01, [dt](double degrees) {
            OnSlope scene = cube_on_slope(degrees, 2);
            // A box that has tipped may come to rest on another face.
            for (int i = steps_in(5, dt); i > 0 && scene.tilt() < radians(30); --i) scene.world.step(float(dt));
            return scene.tilt() < radians(30);
        });
        result.rows.push_back({"steepest slope on which a cube stands, degrees", dt, 45, stands, 0.5, Bar::absolute});
        OnSlope below = cube_on_slope(44.5, 2);
        run(below.world, float(dt), steps_in(5, dt));
        result.rows.push_back(
            {"its tilt at 44.5 degrees after 5 s, degrees", dt, 0, below.tilt() / radians(1), 0.5, Bar::at_most});
    }
    Plot plot{"A cube on a slope, mu = 2", "time, s", "tilt relative to the slope, degrees", false, false, {}};
    for (const auto& [degrees, name] : {std::pair{44.5, "44.5 degrees"}, std::pair{45.5, "45.5 degrees"}}) {
        OnSlope scene = cube_on_slope(degrees, 2);
        Curve curve{name, {}, {}};
        for (int i = 1; i <= 180 && scene.tilt() < radians(80); ++i) {
            scene.world.step(float(time_steps[0]));
            curve.x.push_back(i * time_steps[0]);
            curve.y.push_back(scene.tilt() / radians(1));
        }
        plot.curves.push_back(curve);
    }
    result.plots.push_back(plot);
    return result;
}

namespace {

// A box of 1 x 0.5 x 1 m on level ground, moving in the direction `along`.
struct SlidingBox {
    World world;
    glm::dvec3 along;
    BodyId box;

    SlidingBox(float friction, double heading, double speed, float spin = 0) : along(direction(heading)) {
        add_ground(world, surface(friction));
        BodyDef def;
        def.position = {0, 0.25, 0};
        def.linear_velocity = Vec3(speed * along);
        def.angular_velocity = {0, spin, 0};
        box = add_body(world, Box{{0.5f, 0.25f, 0.5f}}, def, surface(friction));
    }
    double way() { return glm::dot(world.body(box).position(), along); }
    double speed() { return double(glm::length(world.body(box).linear_velocity())); }
};

} // namespace

Result measure_sliding_stop() {
    Result result;
    Plot plot{"Sliding to a stop from 2 m/s, dt = 1/60 s",
              "heading relative to the box's sides, degrees",
              "distance over v^2 / (2 mu g)",
              false,
              false,
              {}};
    for (const double dt : time_steps) {
        double fastest = 0;
        for (const float friction : {0.2f, 0.4f, 0.7f}) {
            const std::string name = "mu = 0." + std::to_string(int(friction * 10 + 0.5f));
            Farthest way{2 * 2 / (2 * double(friction) * gravity)};
            double least = 1e9, most = 0;
            Curve curve{name, {}, {}};
            for (int heading = 0; heading < 360; heading += 15) {
                SlidingBox scene(friction, heading, 2);
                run(scene.world, float(dt), steps_in(1.5, dt));
                fastest = std::max(fastest, scene.speed());
                way.add(scene.way());
                least = std::min(least, scene.way());
                most = std::max(most, scene.way());
                curve.x.push_back(heading);
                curve.y.push_back(scene.way() / way.expected);
            }
            result.rows.push_back(
                {name + ": stopping distance, the worst of 24 headings, m", dt, way.expected, way.value, 0.01});
            result.rows.push_back({name + ": relative spread of the stopping distance over the headings", dt, 0,
                                   (most - least) / way.expected, 0.001, Bar::at_most});
            if (dt == time_steps[0]) plot.curves.push_back(curve);
        }
        result.rows.push_back({"greatest remaining speed after 1.5 s, m/s", dt, 0, fastest, 1e-3, Bar::at_most});
    }
    result.plots.push_back(plot);
    return result;
}

Result measure_slide_to_roll() {
    Result result;
    constexpr double v0 = 2, friction = 0.2;
    const double seconds = 2 * v0 / (7 * double(float(friction)) * gravity); // until the ball rolls
    const double meters = 6.0 / 7 * v0 * seconds, rolling = 5.0 / 7 * v0;
    Plot plot{"From sliding to rolling, mu = 0.2", "time, s", "m/s", false, false, {}};
    for (const double dt : time_steps) {
        Farthest time{seconds}, way{meters}, speed{rolling};
        for (const double heading : {0.0, 37.0, 90.0, 203.0}) {
            const glm::dvec3 along = direction(heading);
            World world;
            add_ground(world, surface(float(friction)));
            BodyDef def;
            def.position = {0, double(radius), 0};
            def.linear_velocity = Vec3(v0 * along);
            const BodyId ball = add_body(world, Sphere{radius}, def, surface(float(friction)));
            auto go = [&] { return glm::dot(glm::dvec3(world.body(ball).linear_velocity()), along); };
            auto turn = [&] { // speed of the ball's surface due to its rotation
                const glm::dvec3 spin(world.body(ball).angular_velocity());
                return glm::dot(glm::cross(spin, {0, double(radius), 0}), along);
            };
            Curve going{"speed, dt = " + step_text(dt) + " s", {}, {}, true},
                turning{"r w, dt = " + step_text(dt) + " s", {}, {}, true};
            const int sliding = steps_in(0.2, dt), all = steps_in(0.6, dt);
            double until = 0;
            for (int i = 1; i <= all; ++i) {
                world.step(float(dt));
                // The slip decreases from v0 at a constant rate.
                if (i == sliding) until = sliding * dt * v0 / (v0 - (go() - turn()));
                going.x.push_back(i * dt);
                going.y.push_back(go());
                turning.x.push_back(i * dt);
                turning.y.push_back(turn());
            }
            time.add(until);
            speed.add(go());
            way.add(glm::dot(world.body(ball).position(), along) - go() * (all * dt - until));
            if (dt == time_steps[0] && heading == 0) plot.curves = {going, turning};
        }
        result.rows.push_back(
            {"time until it rolls, the worst of 4 headings, s", dt, time.expected, time.value, 0.005});
        result.rows.push_back({"distance until it rolls, m", dt, way.expected, way.value, 0.005});
        result.rows.push_back({"rolling speed, m/s", dt, speed.expected, speed.value, 0.005});
    }
    plot.curves.push_back({"closed form", {0, seconds, 0.6}, {v0, rolling, rolling}});
    plot.curves.push_back({"closed form, r w", {0, seconds, 0.6}, {0, rolling, rolling}});
    result.plots.push_back(plot);
    return result;
}

namespace {

// Reference solution for a box that slides and spins on four corners, each of which carries a quarter of the weight,
// with Coulomb's law at each corner, integrated in small explicit steps. `reach`: from the center to a corner;
// `inertia`: divided by the mass, m^2.
struct FourCorners {
    double way = 0, time = 0;
    Curve speeds{"expected speed: Coulomb at four corners", {}, {}}, spins{"expected spin", {}, {}};

    FourCorners(double friction, double reach, double inertia, double heading, double speed, double spin) {
        constexpr double h = 1e-4;
        glm::dvec2 v{speed, 0};
        double angle = pi / 4 + heading;
        for (int i = 0; glm::length(v) > 0.01; ++i) {
            if (i % 100 == 0) {
                speeds.x.push_back(time);
                speeds.y.push_back(glm::length(v));
                spins.x.push_back(time);
                spins.y.push_back(spin);
            }
            glm::dvec2 force{0, 0}, arm = reach * glm::dvec2(std::cos(angle), std::sin(angle));
            double torque = 0;
            for (int corner = 0; corner < 4; ++corner) {
                const glm::dvec2 turned(-arm.y, arm.x), sliding = v + spin * turned;
                const glm::dvec2 f = -friction * gravity / 4 / std::max(glm::length(sliding), 1e-9) * sliding;
                force += f;
                torque += glm::dot(turned, f);
                arm = turned;
            }
            v += h * force;
            spin += h * torque / inertia;
            way += h * v.x;
            angle += h * spin;
            time += h;
        }
    }
};

} // namespace

Result measure_spinning_box() {
    Result result;
    constexpr double friction = 0.4, speed = 3, spin = 6;
    Plot plot{"Sliding and spinning, heading 30 degrees", "time, s", "m/s, rad/s", false, false, {}};
    for (const double dt : time_steps)
        for (const double heading : {0.0, 30.0, 45.0}) { // other headings are equivalent by symmetry
            const FourCorners law(friction, std::sqrt(0.5), 1.0 / 6, radians(heading), speed, spin);
            SlidingBox scene(float(friction), heading, speed, float(spin));
            double stopped = 0;
            Curve going{"speed, dt = " + step_text(dt) + " s", {}, {}, true},
                turning{"spin, dt = " + step_text(dt) + " s", {}, {}, true};
            for (int i = 1; i <= steps_in(2, dt); ++i) {
                scene.world.step(float(dt));
                if (scene.speed() > 0.01) stopped = i * dt;
                if (i > steps_in(1, dt)) continue;
                going.x.push_back(i * dt);
                going.y.push_back(scene.speed());
                turning.x.push_back(i * dt);
                turning.y.push_back(double(scene.world.body(scene.box).angular_velocity().y));
            }
            const std::string name = "heading " + std::to_string(int(heading)) + " degrees: ";
            result.rows.push_back(
                {name + "stopping distance, m", dt, law.way, scene.way(), 0.1, Bar::relative,
                 "one friction cone and one friction torque for the whole contact patch would give 1.147 m"});
            result.rows.push_back({name + "stopping time, s", dt, law.time, stopped, 0.1});
            if (dt == time_steps[0] && heading == 30) plot.curves = {going, turning, law.speeds, law.spins};
        }
    result.plots.push_back(plot);
    return result;
}

} // namespace cairn::validation
