// Structures that must stand: stacks, towers, heavy loads on light boxes, cards; and a scene that is shifted or rotated
// (rows 20, 21 and 22).
#include "validation/cases.h"
#include "validation/measures.h"
#include "validation/text.h"
#include "validation/worlds.h"

#include <iterator>
#include <string>
#include <vector>

namespace cairn::validation {
namespace {

constexpr float density = 1000; // kg/m^3, unless noted otherwise

// Boxes on the ground, and their initial positions.
struct Stack {
    World world;
    std::vector<BodyId> boxes;
    std::vector<Position> start;

    explicit Stack(bool sleep) : world(sleep ? WorldDef{} : without_sleep()) { add_ground(world); }

    void add(const Position& position, const Vec3& half_extents = {0.5f, 0.5f, 0.5f}, float box_density = density,
             const Quat& rotation = {1, 0, 0, 0}) {
        BodyDef def;
        def.position = position;
        def.rotation = rotation;
        ShapeDef shape;
        shape.density = box_density;
        boxes.push_back(world.create_body(def));
        world.add_shape(boxes.back(), Box{half_extents}, shape);
        start.push_back(position);
    }
    void add_column(int count) {
        for (int i = 0; i < count; ++i) add({0, 0.5 + i, 0});
    }
    std::vector<Position> positions() {
        std::vector<Position> all;
        for (const BodyId box : boxes) all.push_back(world.body(box).position());
        return all;
    }
};

// The greatest displacement of any box from `start`: downward, sideways, and in total.
struct Moved {
    double down = 0, sideways = 0, any = 0;

    Moved(const std::vector<Position>& start, const std::vector<Position>& now) {
        for (std::size_t i = 0; i < start.size(); ++i) {
            const Position way = now[i] - start[i];
            down = std::max(down, -way.y);
            sideways = std::max(sideways, std::hypot(way.x, way.z));
            any = std::max(any, glm::length(way));
        }
    }
};

} // namespace

Result measure_stack_forces() {
    Result result;
    constexpr int count = 10;
    Plot plot{"Forces in a stack of ten boxes of 1,000 kg", "boxes above the contact", "force, N", false, false, {}};
    for (const double dt : time_steps) {
        Stack stack(false);
        stack.add_column(count);
        run(stack.world, float(dt), steps_in(4, dt));
        std::vector<double> force(count, 0.0); // under each box
        for (const Contact& contact : stack.world.contacts()) {
            std::size_t upper = 0; // the higher of the two boxes
            for (std::size_t i = 0; i < count; ++i)
                if (contact.body_a == stack.boxes[i] || contact.body_b == stack.boxes[i]) upper = i;
            force[upper] += normal_impulse(contact) / dt;
        }
        Curve seen{"dt = " + step_text(dt) + " s", {}, {}, true};
        std::size_t worst = 0;
        auto law = [](std::size_t level) { return double(count - level) * double(density) * gravity; };
        for (std::size_t level = 0; level < count; ++level) {
            if (std::fabs(force[level] / law(level) - 1) > std::fabs(force[worst] / law(worst) - 1)) worst = level;
            seen.x.push_back(double(count - level));
            seen.y.push_back(force[level]);
        }
        plot.curves.push_back(seen);
        result.rows.push_back({"force under the lowest of ten boxes, N", dt, law(0), force[0], 0.01});
        result.rows.push_back(
            {"force under box " + std::to_string(worst + 1) + ", the worst, N", dt, law(worst), force[worst], 0.01});
    }
    plot.curves.push_back({"expected: (N - k) m g", {0, count}, {0, count * double(density) * gravity}});
    result.plots.push_back(plot);
    return result;
}

namespace {

// A rigid motion of a whole world: point p of one world corresponds to rotation p + shift in the other.
struct Motion {
    const char* name;
    glm::dvec3 shift;
    Quat rotation;

    Position place(const Position& p) const { return glm::dquat(rotation) * p + shift; }
    Position back(const Position& p) const { return glm::conjugate(glm::dquat(rotation)) * (p - shift); }
};

const Motion motions[] = {
    {"shifted by 10,000 km along each axis", {1e7, 1e7, 1e7}, {1, 0, 0, 0}},
    {"rotated by 90 degrees about the vertical", {0, 0, 0}, glm::angleAxis(float(pi / 2), Vec3(0, 1, 0))},
    {"rotated by 90 degrees about a horizontal axis, with gravity",
     {0, 0, 0},
     glm::angleAxis(float(pi / 2), Vec3(0, 0, 1))},
};

// A column of ten boxes; beside it a ball that bounces and rolls, a box that slides and spins, and one that tumbles
// onto a corner.
struct MovedWorld {
    Motion motion;
    World world;
    std::vector<BodyId> bodies;

    explicit MovedWorld(const Motion& m) : motion(m), world(settings(m)) {
        BodyDef ground;
        ground.type = BodyType::static_;
        ground.position = m.place({0, 0, 0});
        ground.rotation = m.rotation;
        add_body(world, Plane{}, ground, material(1));
        for (int i = 0; i < 10; ++i) add(Box{}, {0, 0.5 + i, 0}, {0, 0, 0}, {0, 0, 0}, 0);
        add(Sphere{0.5f}, {3, 2, 0}, {2, 0, 1}, {0, 0, 0}, 0.8f);
        add(Box{{0.5f, 0.25f, 0.5f}}, {-3, 0.25, 0}, {-3, 0, 1}, {0, 4, 0}, 0);
        add(Box{{0.4f, 0.3f, 0.5f}}, {0, 1.5, 4}, {0.5f, 0, 0.3f}, {1, 2, 3}, 0);
    }
    // Only the ball bounces: a resting body with restitution would bounce a little in every substep, and rounding would
    // decide at which corner.
    static Material material(float restitution) {
        Material result = surface(0.5f, restitution);
        result.restitution_combine = CombineRule::multiply;
        return result;
    }
    static WorldDef settings(const Motion& m) {
        WorldDef def = without_sleep();
        def.gravity = m.rotation * def.gravity;
        return def;
    }
    void add(const Shape& shape, const Position& position, const Vec3& velocity, const Vec3& spin, float restitution) {
        BodyDef def;
        def.position = motion.place(position);
        def.rotation = motion.rotation;
        def.linear_velocity = motion.rotation * velocity;
        def.angular_velocity = motion.rotation * spin;
        bodies.push_back(add_body(world, shape, def, material(restitution)));
    }
    Position position(std::size_t i) { return motion.back(world.body(bodies[i]).position()); }
};

} // namespace

Result measure_moved_worlds() {
    Result result;
    Plot plot{"Shifted and rotated worlds, dt = 1/60 s", "time, s", "greatest deviation of a body, m", false, true, {}};
    for (const double dt : time_steps)
        for (const Motion& motion : motions) {
            MovedWorld here({"", {0, 0, 0}, {1, 0, 0, 0}}), there(motion);
            double most = 0;
            Curve curve{motion.name, {}, {}};
            for (int step = 1; step <= steps_in(5, dt); ++step) {
                here.world.step(float(dt));
                there.world.step(float(dt));
                double apart = 0;
                for (std::size_t i = 0; i < here.bodies.size(); ++i)
                    apart = std::max(apart, glm::distance(here.position(i), there.position(i)));
                if (!(apart <= most)) most = apart;
                curve.x.push_back(step * dt);
                curve.y.push_back(std::max(apart, 1e-9)); // resolution of a double at 10,000 km
            }
            const std::string name = motion.name;
            result.rows.push_back(
                {name + ": greatest deviation from the run at the origin, 5 s, m", dt, 0, most, 0.002, Bar::at_most});
            result.rows.push_back({name + ": height of a column of ten boxes, m", dt, here.position(9).y,
                                   there.position(9).y, 1e-5, Bar::absolute});
            if (dt == time_steps[0]) plot.curves.push_back(curve);
        }
    result.plots.push_back(plot);
    return result;
}

namespace {

// A structure that must stand, and how far its boxes may move from their initial positions.
struct Structure {
    const char* name;
    void (*build)(Stack&);
    double down, sideways; // m
    bool at_every_step;    // of time_steps, or only at the first one
};

void build_tower(Stack& stack) { stack.add_column(40); }

void build_loaded_column(Stack& stack, float ratio) {
    stack.add_column(4);
    stack.add({0, 4.5, 0}, {0.5f, 0.5f, 0.5f}, ratio * density);
}

void build_table(Stack& stack) {
    for (const double x : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0}) stack.add({x, 0.5, z});
    stack.add({0, 1.5, 0}, {1.5f, 0.5f, 1.5f}, 100 * density / 9); // 3 m x 1 m x 3 m
}

// Three storeys of cards of 1 m that lean against each other at 20 degrees.
void build_card_house(Stack& stack) {
    const double length = 1, thickness = 0.02, tilt = radians(20), spacing = 1;
    const Vec3 card{float(thickness / 2), float(length / 2), 0.35f}, roof{0.499f, float(thickness / 2), 0.35f};
    const double rise = length / 2 * std::cos(tilt) + thickness / 2 * std::sin(tilt); // height of a card's center
    const double reach = length / 2 * std::sin(tilt) + thickness / 2 * std::cos(tilt);
    const double storey = 2 * rise + thickness;
    for (int level = 0; level < 3; ++level)
        for (int i = 0; i < 3 - level; ++i) {
            const double x = spacing * (i - 0.5 * (2 - level)), y = level * storey;
            for (const double side : {-1.0, 1.0})
                stack.add({x + side * reach, y + rise, 0}, card, density,
                          glm::angleAxis(float(side * tilt), Vec3(0, 0, 1)));
            if (i > 0) stack.add({x - spacing / 2, y + 2 * rise + thickness / 2, 0}, roof);
        }
}

// Courses of bricks on both sides, each reaching out by 90 % of what balance allows.
void build_arch(Stack& stack) {
    constexpr int courses = 6;
    double reach = 0; // of the current course, from the lowest one
    double x[courses];
    for (int i = 0; i < courses; ++i) {
        x[i] = reach;
        if (i + 1 < courses) reach += 0.9 * 0.5 / (courses - 1 - i);
    }
    const double gap = 0.4, half = reach + 0.5 + gap / 2; // the top bricks end at gap / 2 from the middle
    for (const double side : {-1.0, 1.0})
        for (int i = 0; i < courses; ++i) stack.add({side * (half - x[i]), 0.15 + 0.3 * i, 0}, {0.5f, 0.15f, 0.25f});
}

// 18 layers of three blocks, of which some are removed.
void build_jenga(Stack& stack) {
    const Vec3 along{0.75f, 0.15f, 0.25f}, across{0.25f, 0.15f, 0.75f};
    for (int layer = 0; layer < 18; ++layer)
        for (int i = -1; i <= 1; ++i) {
            if (layer % 3 == 1 && i == 0) continue;               // the middle block is removed
            if (layer % 3 == 2 && layer < 17 && i == 1) continue; // a side block is removed
            const double y = 0.15 + 0.3 * layer;
            if (layer % 2 == 0)
                stack.add({0, y, 0.5 * i}, along);
            else
                stack.add({0.5 * i, y, 0}, across);
        }
}

void build_pyramid(Stack& stack) {
    constexpr int rows = 100;
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < rows - row; ++i) stack.add({i + 0.5 * (row - rows + 1), 0.5 + row, 0});
}

const Structure structures[] = {
    {"tower of 40 boxes", build_tower, 0.05, 0.01, true},
    {"box 100 times heavier on four boxes", [](Stack& stack) { build_loaded_column(stack, 100); }, 0.05, 0.01, true},
    {"box 1,000 times heavier on four boxes", [](Stack& stack) { build_loaded_column(stack, 1000); }, 0.05, 0.02, true},
    {"slab 100 times heavier on four legs", build_table, 0.02, 0.01, true},
    {"card house", build_card_house, 0.02, 0.02, false},
    {"corbelled arch", build_arch, 0.02, 0.02, false},
    {"Jenga tower with blocks removed", build_jenga, 0.03, 0.03, false},
};

struct StabilityResult {
    double overlap = 0, down = 0, sideways = 0, creep = 0; // m; creep: during the last quarter of the time

    void stand(const Structure& structure, bool sleep, double seconds, double dt, int every, Curve& sag) {
        Stack stack(sleep);
        structure.build(stack);
        const int steps = steps_in(seconds, dt);
        std::vector<Position> before;
        for (int i = 1; i <= steps; ++i) {
            stack.world.step(float(dt));
            if (i == steps - steps / 4) before = stack.positions();
            if (i % every != 0) continue;
            overlap = std::max(overlap, deepest_overlap(stack.world));
            if (i % (6 * every) != 0) continue;
            sag.x.push_back(i * dt);
            sag.y.push_back(1000 * Moved(stack.start, stack.positions()).down);
        }
        const Moved moved(stack.start, stack.positions());
        down = std::max(down, moved.down);
        sideways = std::max(sideways, moved.sideways);
        creep = std::max(creep, Moved(before, stack.positions()).any);
    }
    void report(const std::string& name, const Structure& structure, double dt, Result& result,
                const std::string& note = {}, double known_bar = 0) const {
        result.rows.push_back({name + "deepest overlap, m", dt, 0, overlap, 0.01, Bar::at_most, note});
        result.rows.push_back({name + "sinking, m", dt, 0, down, structure.down, Bar::at_most, note});
        result.rows.push_back(
            {name + "sideways displacement, m", dt, 0, sideways, structure.sideways, Bar::at_most, note, known_bar});
        result.rows.push_back(
            {name + "displacement in the last quarter, m", dt, 0, creep, 0.001, Bar::at_most, note, known_bar});
    }
};

} // namespace

Result measure_towers() {
    Result result;
    Plot plot{
        "Structures that stand, dt = 1/60 s, without sleeping", "time, s", "greatest sinking, mm", false, false, {}};
    for (const Structure& structure : structures)
        for (const double dt : time_steps) {
            if (dt != time_steps[0] && !structure.at_every_step) continue;
            const double seconds = dt == time_steps[0] ? 60 : dt == time_steps[1] ? 15 : 5;
            StabilityResult stood;
            Curve unused, sag{structure.name, {}, {}};
            stood.stand(structure, true, seconds, dt, 10, unused);
            stood.stand(structure, false, seconds, dt, 10, sag);
            if (dt == time_steps[0]) plot.curves.push_back(sag);
            stood.report(structure.name + std::string(", ") + text(seconds) + " s: ", structure, dt, result);
        }
    const Structure pyramid{"pyramid of 100 rows", build_pyramid, 0.2, 0.1, false};
    for (const bool sleep : {true, false}) {
        const double seconds = sleep ? 60 : 8;
        StabilityResult stood;
        Curve sag{pyramid.name, {}, {}};
        stood.stand(pyramid, sleep, seconds, time_steps[0], 20, sag);
        if (!sleep) plot.curves.push_back(sag);
        stood.report(pyramid.name + std::string(sleep ? ", sleeping, " : ", not sleeping, ") + text(seconds) + " s: ",
                     pyramid, time_steps[0], result,
                     sleep ? "asleep after 6 s"
                           : "a wall 1 m thick and 100 m high on soft contacts: it buckles out of its plane, 1.8 times "
                             "as far each second, and falls after 14 s unless it has fallen asleep",
                     sleep ? 0 : 0.5);
    }
    result.plots.push_back(plot);
    return result;
}

} // namespace cairn::validation
