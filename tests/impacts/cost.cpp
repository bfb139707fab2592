// The cost of fast bodies: worlds at rest, with and without projectiles. tools/impact_cost.py counts the instructions.
//
// usage: cairn_impact_cost BODIES PROJECTILES STEPS asleep|awake   Prints time and statistics of a step, means.
#include <cairn/cairn.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <vector>

using namespace cairn;

namespace {

constexpr double pitch = 1.5; // m, spacing of the bodies, which are boxes of 1 m on the ground
constexpr float speed = 200;  // m/s, of the projectiles
constexpr int warm_up = 40;   // steps; bodies that may sleep fall asleep

int columns_of(int bodies) { return int(std::ceil(std::sqrt(double(bodies)))); }

void add_bodies(World& world, int bodies, bool may_sleep) {
    BodyDef ground;
    ground.type = BodyType::static_;
    world.add_shape(world.create_body(ground), Plane{});
    const int columns = columns_of(bodies);
    for (int i = 0; i < bodies; ++i) {
        BodyDef body;
        body.position = {pitch * (i % columns), 0.5, pitch * (i / columns)};
        body.allow_sleep = may_sleep;
        world.add_shape(world.create_body(body), Box{{0.5f, 0.5f, 0.5f}});
    }
}

// Adds balls that fly into the boxes from above.
void add_projectiles(World& world, int projectiles, double width) {
    for (int i = 0; i < projectiles; ++i) {
        BodyDef body;
        const double along = width * ((i * 389) % 1000) / 1000;
        body.position = {along, 2 + 0.02 * (i % 50), width * ((i * 619 + 7) % 1000) / 1000};
        const double turn = 2.399963 * i; // the golden angle, so that no two directions agree
        body.linear_velocity = speed * glm::normalize(Vec3(std::cos(turn), -0.15, std::sin(turn)));
        world.add_shape(world.create_body(body), Sphere{0.05f});
    }
}

} // namespace

// The function whose instructions are counted.
extern "C" [[gnu::noinline]] void measured_steps(World& world, int steps, std::vector<Statistics>& seen) {
    for (int i = 0; i < steps; ++i) {
        world.step(1.0f / 60);
        seen.push_back(world.statistics());
    }
}

int main(int argc, char** argv) {
    const int bodies = argc == 5 ? std::atoi(argv[1]) : 0, projectiles = argc == 5 ? std::atoi(argv[2]) : -1;
    const int steps = argc == 5 ? std::atoi(argv[3]) : 0;
    const std::string_view state = argc == 5 ? argv[4] : "";
    if (bodies < 1 || projectiles < 0 || steps < 1 || (state != "asleep" && state != "awake")) {
        std::fprintf(stderr, "usage: cairn_impact_cost BODIES PROJECTILES STEPS asleep|awake\n");
        return 2;
    }
    World world;
    add_bodies(world, bodies, state == "asleep");
    for (int i = 0; i < warm_up; ++i) world.step(1.0f / 60);
    add_projectiles(world, projectiles, pitch * columns_of(bodies));
    std::vector<Statistics> seen;
    seen.reserve(std::size_t(steps));
    const std::clock_t begin = std::clock();
    measured_steps(world, steps, seen);
    const double milliseconds = 1000 * double(std::clock() - begin) / CLOCKS_PER_SEC;
    double pairs = 0, swept = 0, impacts = 0, stopped = 0;
    for (const Statistics& s : seen)
        pairs += double(s.candidate_pairs), swept += double(s.swept_pairs), impacts += double(s.impacts),
            stopped += double(s.stopped_bodies);
    std::printf("%.3f ms of processor time a step: %.0f candidate pairs, %.1f looked at along their ways, %.1f "
                "impacts, %.2f stopped\n",
                milliseconds / steps, pairs / steps, swept / steps, impacts / steps, stopped / steps);
}
