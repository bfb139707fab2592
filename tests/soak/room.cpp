// A closed room of 2 m with walls of 1 cm, and 200 bodies of all kinds in it that never come to rest: none may leave
// it, whatever their collisions.
//
// usage: cairn_room [STEPS]   Default: 1,000,000. Prints a line for each tenth; exit status 1 if a body is outside.
#include <cairn/cairn.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

using namespace cairn;

constexpr int bodies = 200, tenths = 10;
constexpr int steps_between_pushes = 60;
constexpr double half = 1, thick = 0.005; // m
constexpr float speed = 50, spin = 20;    // m/s, rad/s

class Room {
  public:
    Room() {
        WorldDef def;
        def.gravity = {0, 0, 0};
        world_ = World(def);
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                BodyDef wall;
                wall.type = BodyType::static_;
                wall.position[axis] = side * (half + thick);
                Vec3 extents(float(half + 2 * thick));
                extents[axis] = float(thick);
                world_.add_shape(world_.create_body(wall), Box{extents}, surface());
            }
        for (int i = 0; i < bodies; ++i) {
            BodyDef body;
            body.position = 0.3 * Position(i % 6, i / 6 % 6, i / 36) - 0.75;
            bodies_.push_back(world_.create_body(body));
            world_.add_shape(bodies_.back(), shape(i), surface());
        }
    }

    void step() {
        if (world_.step_count() % steps_between_pushes == 0) push();
        world_.step(1.0f / 60);
        impacts_ += world_.statistics().impacts, stopped_ += world_.statistics().stopped_bodies;
    }
    // The number of bodies whose center of mass is outside of the room.
    int outside() const {
        int count = 0;
        for (const BodyId id : bodies_) {
            const Position p = world_.body(id).center_of_mass();
            count += !(std::fabs(p.x) < half && std::fabs(p.y) < half && std::fabs(p.z) < half); // or not finite
        }
        return count;
    }
    const World& world() const { return world_; }
    std::size_t impacts() const { return impacts_; }
    std::size_t stopped() const { return stopped_; }

  private:
    float uniform() { return float(random_() >> 8) / float(1 << 24); }
    Vec3 direction() {
        for (;;) {
            const float x = 2 * uniform() - 1, y = 2 * uniform() - 1, z = 2 * uniform() - 1;
            const float length = std::sqrt(x * x + y * y + z * z);
            if (length > 0.1f && length < 1) return Vec3(x, y, z) / length;
        }
    }
    static ShapeDef surface() {
        ShapeDef def;
        def.material.restitution = 0.9f;
        def.material.static_friction = def.material.dynamic_friction = 0.3f;
        return def;
    }
    Shape shape(int i) {
        const float a = 0.02f + 0.06f * uniform(), b = 0.02f + 0.06f * uniform(), c = 0.02f + 0.06f * uniform();
        switch (i % 6) {
        case 0:
            return Sphere{a};
        case 1:
            return Box{{a, b, c}};
        case 2:
            return Capsule{a, b, {}};
        case 3:
            return Cylinder{a, b};
        case 4:
            return cone(a, b);
        default:
            std::vector<Vec3> points;
            for (int k = 0; k < 10; ++k) points.push_back(0.02f * direction() + a * direction());
            return Hull(points);
        }
    }
    // Gives bodies that have become slow their initial speed again.
    void push() {
        for (const BodyId id : bodies_) {
            Body body = world_.body(id);
            const Vec3 to = direction(), about = direction();
            if (glm::length(body.linear_velocity()) > speed / 2) continue;
            body.set_linear_velocity(speed * to);
            body.set_angular_velocity(spin * about);
        }
    }

    std::mt19937 random_{1};
    World world_;
    std::vector<BodyId> bodies_;
    std::size_t impacts_ = 0, stopped_ = 0;
};

} // namespace

int main(int argc, char** argv) {
    const long steps = argc > 1 ? std::atol(argv[1]) : 1000000;
    if (argc > 2 || steps < tenths) {
        std::fprintf(stderr, "usage: cairn_room [STEPS]   (at least %d)\n", tenths);
        return 2;
    }
    Room room;
    if (room.outside() > 0) return 2;
    for (long i = 1; i <= steps; ++i) {
        room.step();
        if (const int outside = room.outside()) {
            std::fprintf(stderr, "cairn_room: step %ld: %d of %d bodies are outside\n", i, outside, bodies);
            return 1;
        }
        if (i % (steps / tenths) != 0) continue;
        std::printf("%10ld steps  %10zu impacts  %6zu stops  all inside\n", i, room.impacts(), room.stopped());
        std::fflush(stdout);
    }
    return 0;
}
