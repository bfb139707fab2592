#include "bench/rollback.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace cairn::bench {

namespace {

constexpr float frame = 1.0f / 60;
constexpr int chains = 10, links = 6, stacks = 12, stack_height = 5;
constexpr int heap = 500 - chains * links - stacks * stack_height;

BodyId add(World& world, const Position& position, const Shape& shape, BodyType type = BodyType::dynamic) {
    BodyDef def;
    def.type = type;
    def.position = position;
    const BodyId body = world.create_body(def);
    world.add_shape(body, shape);
    return body;
}

void build(World& world) {
    add(world, {}, Plane{}, BodyType::static_);
    for (int side = 0; side < 4; ++side) {
        const double way = side % 2 == 0 ? -3.5 : 3.5;
        const bool along_x = side < 2;
        add(world, along_x ? Position(way, 1, 0) : Position(0, 1, way), along_x ? Box{{0.5f, 1, 4}} : Box{{3, 1, 0.5f}},
            BodyType::static_);
    }
    for (int i = 0; i < heap; ++i)
        add(world, {0.8 * (i % 6) - 2 + 0.05 * (i % 7), 0.6 + 0.8 * (i / 36), 0.8 * (i / 6 % 6) - 2 + 0.05 * (i % 5)},
            i % 2 == 0 ? Shape(Sphere{0.35f}) : Shape(Box{{0.3f, 0.3f, 0.3f}}));
    for (int chain = 0; chain < chains; ++chain) {
        BodyId last{};
        for (int i = 0; i < links; ++i) {
            const Position top(8, 6, 1.5 * chain);
            const BodyId link = add(world, top + Position(0.5 * i + 0.25, 0, 0), Box{{0.22f, 0.08f, 0.08f}});
            world.create_joint(world.joint_at(last, link, top + Position(0.5 * i, 0, 0), {0, 0, 1}, BallJoint{}));
            last = link;
        }
    }
    for (int stack = 0; stack < stacks; ++stack)
        for (int i = 0; i < stack_height; ++i) add(world, {-8, 0.5 + i, 2.0 * stack}, Box{});
}

// The input of the remote player in a frame: a push on one body of the heap or of the chains.
void push(World& world, const std::vector<BodyId>& bodies, int stride) {
    const std::size_t first = 5, count = std::size_t(heap + chains * links);
    Body body = world.body(bodies[first + world.step_count() * std::size_t(stride) % count]);
    body.apply_impulse(body.mass() * Vec3(0.5f, 1.5f, -0.5f));
}

class Stopwatch {
  public:
    double lap() { // ms
        const auto now = Clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
        return ms;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

} // namespace

RollbackResult measure_rollback(const RollbackOptions& options) {
    World world, straight;
    world.set_threads(options.threads);
    build(world);
    build(straight);
    const std::vector<BodyId> bodies = world.bodies(), straight_bodies = straight.bodies();
    for (int i = 0; i < 120; ++i) world.step(frame), straight.step(frame); // until the stacks have come to rest

    RollbackResult result;
    result.bodies = result.min_awake = straight.statistics().dynamic_bodies;
    Snapshot known = world.save();                              // the last frame whose inputs are all known
    for (int i = 0; i < options.frames; ++i) world.step(frame); // predicted without pushes
    for (int r = 0; r < options.rollbacks; ++r) {
        const std::clock_t processor = std::clock();
        Stopwatch watch;
        world.restore(known);
        const double restore = watch.lap();
        push(world, bodies, options.stride);
        world.step(frame);
        const double first = watch.lap();
        known = world.save();
        const double save = watch.lap();
        for (int i = 1; i < options.frames; ++i) world.step(frame);
        const double steps = first + watch.lap();
        result.processor += 1000.0 * double(std::clock() - processor) / CLOCKS_PER_SEC;
        result.milliseconds.push_back(restore + steps + save);
        result.restore += restore, result.save += save, result.step += steps / options.frames;

        push(straight, straight_bodies, options.stride);
        straight.step(frame);
        World check;
        check.restore(known);
        // The broad phase is compared too: with other fat boxes pairs would be found in another order.
        result.wrong += check.state_hash() != straight.state_hash() ||
                        known.sizes().broad_phase != straight.save().sizes().broad_phase;
        const std::size_t awake = straight.statistics().awake_bodies;
        result.min_awake = std::min(result.min_awake, awake);
        result.max_awake = std::max(result.max_awake, awake);
    }
    result.restore /= options.rollbacks, result.save /= options.rollbacks, result.step /= options.rollbacks;
    result.processor /= options.rollbacks;
    result.contacts = straight.statistics().contacts;
    result.joints = straight.joints().size();
    result.sizes = known.sizes();
    result.bytes = known.bytes.size();
    return result;
}

} // namespace cairn::bench
