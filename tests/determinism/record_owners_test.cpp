// Each rank has the records of its own contacts alone. The course of the world, its events and reports must be the same
// as with one process, whatever happens to bodies, shapes and owners.
#include "rank_courses.h"

#include <gtest/gtest.h>

#include <string>

namespace cairn_test {
namespace {

using namespace cairn;

// Heaps on adjacent tiles and on hills, bricks that slide over the tiles, fast bouncing balls, a chain that falls among
// them and is removed, a stack that falls asleep and is hit; materials change, bodies are created and destroyed.
class Yard : public Scene {
  public:
    void build(World& world) override {
        for (int i = 0; i < 16; ++i)
            add_fixed(world, Box{{1.5f, 0.5f, 1.5f}}, {3.0 * (i % 4) - 6, -0.5, 3.0 * (i / 4) - 4.5});
        Numbers numbers(31);
        std::vector<float> heights(13 * 13);
        for (float& height : heights) height = 0.4f * numbers.next();
        add_fixed(world, HeightField(13, 13, {0.6f, 0.6f}, heights), {9, 0, 0});
        ShapeDef zone;
        zone.is_trigger = true;
        add_fixed(world, Box{{2, 1, 2}}, {0, 1, 0}, zone);
        const Hull stone = rock(numbers, 14);
        for (int i = 0; i < 90; ++i) {
            ShapeDef def;
            def.material.restitution = i % 4 == 0 ? 0.6f : 0.0f;
            const Shape shapes[] = {Sphere{0.3f},
                                    Box{{0.3f, 0.3f, 0.3f}},
                                    stone,
                                    Cylinder{0.3f, 0.25f, {}},
                                    Box{{0.4f, 0.15f, 0.25f}},
                                    Capsule{0.25f, 0.2f, {}}};
            const double side = i % 2 == 0 ? 0.0 : 9.0;
            put(world, shapes[i % 6], {side + 0.7 * (i / 2 % 4) - 1, 0.8 + 0.7 * (i / 32), 0.7 * (i / 8 % 4) - 1}, def)
                .set_rotation(numbers.rotation());
        }
        for (int i = 0; i < 4; ++i)
            put(world, Box{{0.4f, 0.2f, 0.3f}}, {-7, 0.21, 1.5 * i - 3.2}).set_linear_velocity({7, 0, 0.3f});
        for (int i = 0; i < 4; ++i) put(world, Box{{0.4f, 0.4f, 0.4f}}, {-5, 0.4 + 0.8 * i, -4.5});
        BodyId last;
        for (int i = 0; i < 6; ++i) {
            Body ball = put(world, Sphere{0.2f}, {0.45 * i - 1, 4, 0.2});
            ball.set_name("chain");
            if (i > 0)
                world.create_joint(world.joint_at(last, ball.id(), {0.45 * i - 1.225, 4, 0.2}, {1, 0, 0}, BallJoint{}));
            last = ball.id();
        }
    }
    void before_step(World& world) override {
        const std::uint64_t step = world.step_count();
        ShapeDef lively;
        lively.material.restitution = 0.8f;
        if (step % 25 == 20) put(world, Sphere{0.25f}, {-12, 1.2, 0.1}, lively).set_linear_velocity({70, -4, 0});
        if (step % 25 == 10) put(world, Box{{0.2f, 0.05f, 0.2f}}, {12, 9, 0}, lively).set_linear_velocity({-3, -60, 1});
        if (step == 100)
            while (const auto link = world.find_body("chain")) world.destroy_body(*link);
        if (step == 60) {
            const std::vector<BodyId> bodies = world.bodies();
            for (std::size_t k = 30; k < 40; ++k) world.destroy_body(bodies[k]);
        }
        if (step == 75) {
            Material icy;
            icy.dynamic_friction = icy.static_friction = 0.02f;
            for (const BodyId body : world.bodies())
                if (world.body(body).type() == BodyType::dynamic)
                    for (const ShapeId shape : world.body(body).shapes()) world.set_material(shape, icy);
        }
        if (step == 110) put(world, Sphere{0.3f}, {-5, 0.31, -7}).set_linear_velocity({0, 0, 3});
    }

  private:
    static Body put(World& world, const Shape& shape, const Position& at, const ShapeDef& shape_def = {}) {
        BodyDef def;
        def.type = BodyType::dynamic;
        def.position = at;
        return world.body(add(world, shape, def, shape_def));
    }
};

TEST(RecordOwners, EventsContactsAndBytesAreThoseOfOneProcess) {
    Yard scene;
    World world(scene.settings());
    scene.build(world);
    const Snapshot start = world.save();
    constexpr int steps = 140, asked_every = 9;
    const Course alone = run_alone(scene, world, steps, asked_every);
    EXPECT_GT(alone.hits, 20u);
    for (const auto& [ranks, threads] : {std::pair(2, 1), std::pair(3, 2), std::pair(5, 1)}) {
        const std::vector<Course> courses = run_on_ranks(scene, start, ranks, steps, threads, asked_every);
        for (std::size_t rank = 0; rank < courses.size(); ++rank)
            expect_same(alone, courses[rank], std::to_string(rank) + " of " + std::to_string(ranks) + " ranks");
    }
}

} // namespace
} // namespace cairn_test
