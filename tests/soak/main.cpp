// A world that runs for a very long time while bodies and joints are created and destroyed at random. Memory must not
// grow, steps must not become slower, and the checks of each step must hold.
//
// usage: cairn_soak [STEPS]   Default: 1,000,000. Prints a line for each tenth; exit status 1 if anything does not
// hold.
#include "../sanitized.h"

#include <cairn/cairn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>
#include <vector>

#include <unistd.h>

namespace {

using namespace cairn;

constexpr std::size_t min_bodies = 20, max_bodies = 40;
constexpr int tenths = 10, warm_up = 20000;
constexpr double room = 3, top = 12; // m: half width of the room; height at which bodies begin

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double resident_megabytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0, resident = 0;
    file >> pages >> resident;
    return resident * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

class Soak {
  public:
    Soak() {
        BodyDef def;
        def.type = BodyType::static_;
        const BodyId walls = world_.create_body(def);
        world_.add_shape(walls, Plane{});
        for (const float side : {-1.0f, 1.0f})
            for (const Vec3 axis : {Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
                ShapeDef shape;
                shape.position = float(room) * side * axis;
                world_.add_shape(walls, Plane{-side * axis, axis.x != 0 ? Vec3(0, 0, 1) : Vec3(1, 0, 0), {}}, shape);
            }
        std::vector<float> heights(64);
        for (float& height : heights) height = 0.5f * uniform();
        world_.add_shape(walls, HeightField(8, 8, {0.9f, 0.9f}, heights));
    }

    void step() {
        const unsigned what = random_() % 24;
        if ((what == 0 || bodies_.size() < min_bodies) && bodies_.size() < max_bodies) create();
        if (what == 1 && bodies_.size() > min_bodies) destroy(random_() % bodies_.size());
        if (what == 2 && bodies_.size() > min_bodies) destroy(0); // the oldest
        if (what == 3) join();
        world_.step(1.0f / 60);
        check();
    }

    // Fills the room with twice the greatest later number of bodies, so that all buffers have their final size.
    void crowd() {
        while (bodies_.size() < 2 * max_bodies) {
            create();
            for (int i = 0; i < 5; ++i) world_.step(1.0f / 60);
        }
        for (int i = 0; i < 300; ++i) {
            join();
            world_.step(1.0f / 60);
        }
        check();
        while (bodies_.size() > max_bodies) destroy(0);
    }

    const World& world() const { return world_; }

  private:
    float uniform() { return float(random_() >> 8) / float(1 << 24); }
    Shape shape() {
        const float a = 0.1f + 0.3f * uniform(), b = 0.1f + 0.3f * uniform();
        switch (random_() % 6) {
        case 0:
            return Sphere{a};
        case 1:
            return Box{{a, b, a}};
        case 2:
            return Capsule{a, b, {}};
        case 3:
            return Cylinder{a, b};
        case 4:
            return cone(a, b);
        default:
            std::array<Vec3, 10> points;
            for (Vec3& point : points) point = 2 * a * (Vec3(uniform(), uniform(), uniform()) - 0.5f);
            return Hull(points);
        }
    }
    void create() {
        BodyDef def;
        def.position = {(2 * double(uniform()) - 1) * (room - 1), top, (2 * double(uniform()) - 1) * (room - 1)};
        def.rotation = Quat(1, uniform(), uniform(), uniform());
        bodies_.push_back(world_.create_body(def));
        world_.add_shape(bodies_.back(), shape());
    }
    void destroy(std::size_t i) {
        world_.destroy_body(bodies_[i]);
        bodies_.erase(bodies_.begin() + std::ptrdiff_t(i));
    }
    void join() {
        const BodyId a = bodies_[random_() % bodies_.size()], b = bodies_[random_() % bodies_.size()];
        if (a == b || !world_.joints(a).empty() || !world_.joints(b).empty()) return;
        const Position middle = 0.5 * (world_.body(a).position() + world_.body(b).position());
        if (glm::length(world_.body(a).position() - middle) > 0.6) return;
        world_.create_joint(world_.joint_at(a, b, middle, {0, 1, 0}, BallJoint{}));
    }
    void check() {
        const char* broken = nullptr;
        for (const BodyId id : bodies_) {
            const Body body = world_.body(id);
            const Position p = body.position();
            const Vec3 v = body.linear_velocity(), w = body.angular_velocity();
            // A body that is pushed out at a corner of the room may leave it by its own size.
            if (!(std::fabs(p.x) < room + 1 && std::fabs(p.z) < room + 1 && p.y > -1 && p.y < top + 5))
                broken = "a body has left the room";
            if (!(glm::length(v) < 60 && glm::length(w) < 1000)) broken = "a body is too fast";
        }
        if (world_.bodies().size() != bodies_.size() + 1) broken = "bodies() is not what was made and not removed";
        if (world_.statistics().clamped_speeds > 0) broken = "a speed had to be cut";
        for (const JointId id : world_.joints())
            if (!(world_.joint_state(id).linear_error < 1)) broken = "a joint has come apart";
        if (!broken) return;
        std::fprintf(stderr, "cairn_soak: step %llu: %s\n", static_cast<unsigned long long>(world_.step_count()),
                     broken);
        std::exit(1);
    }

    std::mt19937 random_{1};
    World world_;
    std::vector<BodyId> bodies_; // oldest first
};

struct Tenth {
    double microseconds, megabytes; // mean step time; resident memory at the end
};

} // namespace

int main(int argc, char** argv) {
    const long steps = argc > 1 ? std::atol(argv[1]) : 1000000;
    if (argc > 2 || steps < 1000) {
        std::fprintf(stderr, "usage: cairn_soak [STEPS]   (at least 1000)\n");
        return 2;
    }
    Soak soak;
    soak.crowd();
    for (int i = 0; i < warm_up; ++i) soak.step();
    // This first output also loads the pages that measuring touches, so that they do not count as growth.
    std::printf("%10llu steps  to warm up        %8.2f MB\n",
                static_cast<unsigned long long>(soak.world().step_count()), resident_megabytes());
    std::array<Tenth, tenths> all{};
    for (int k = 0; k < tenths; ++k) {
        const double start = processor_seconds();
        for (long i = 0; i < steps / tenths; ++i) soak.step();
        all[std::size_t(k)] = {1e6 * (processor_seconds() - start) / double(steps / tenths), resident_megabytes()};
        std::printf("%10llu steps  %6.1f us a step  %8.2f MB\n",
                    static_cast<unsigned long long>(soak.world().step_count()), all[std::size_t(k)].microseconds,
                    all[std::size_t(k)].megabytes);
        std::fflush(stdout);
    }
    // The median of three tenths: bodies come and go, and now and then many are fast.
    const auto middle_of = [&](int from) {
        std::array<double, 3> times{};
        for (int k = 0; k < 3; ++k) times[std::size_t(k)] = all[std::size_t(from + k)].microseconds;
        std::sort(times.begin(), times.end());
        return times[1];
    };
    const double growth = all[tenths - 1].megabytes / all[0].megabytes - 1;
    const double slower = middle_of(tenths - 3) / middle_of(0) - 1;
    std::printf("memory %+.2f %%, time of a step %+.1f %%, from the first tenths to the last\n", 100 * growth,
                100 * slower);
    const bool is_flat = cairn_test::is_sanitized || growth <= 0.01;
    constexpr double max_slower = 0.5; // tolerance for a busy machine
    return is_flat && slower <= max_slower ? 0 : 1;
}
