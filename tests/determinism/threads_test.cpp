// The number of threads changes neither the state nor the events and their order.
#include "scenes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cairn_test {
namespace {

using namespace cairn;

constexpr int thread_counts[] = {2, 3, 4, 8};

class Threads : public testing::TestWithParam<NamedScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Threads, testing::ValuesIn(scenes().begin(), scenes().end()),
                         [](const testing::TestParamInfo<NamedScene>& info) { return std::string(info.param.name); });

TEST_P(Threads, AnyNumberGivesTheSameState) {
    const std::uint64_t alone = hash_after(GetParam().make(), golden_steps);
    for (const int threads : thread_counts)
        EXPECT_EQ(hash_after(GetParam().make(), golden_steps, threads), alone) << threads << " threads";
}

// Balls, cubes and bricks, some with restitution, that fall on a heap in which a paddle rotates: an island so large
// that all threads work on it, beside small ones, with the paths of the solver that are seldom taken.
struct Heap {
    World world;
    std::vector<std::uint64_t> events; // in order, encoded as numbers

    explicit Heap(int threads) {
        world.set_threads(threads);
        BodyDef ground;
        ground.type = BodyType::static_;
        world.add_shape(world.create_body(ground), Plane{});
        BodyDef paddle;
        paddle.type = BodyType::kinematic;
        paddle.position = {0, 1, 0};
        paddle.angular_velocity = {0, 2, 0};
        world.add_shape(world.create_body(paddle), Box{{6, 0.4f, 0.4f}});
        for (int i = 0; i < 1200; ++i) {
            BodyDef def;
            def.position = {1.1 * (i % 10) - 5 + 0.01 * (i % 7), 2 + 1.05 * (i / 100), 1.1 * (i / 10 % 10) - 5};
            def.rotation = Quat(1, 0.1f * float(i % 5), 0.2f * float(i % 3), 0);
            def.linear_velocity = {0, -4, 0};
            ShapeDef material;
            material.material.restitution = i % 4 == 0 ? 0.5f : 0.0f;
            const BodyId body = world.create_body(def);
            if (i % 3 == 0)
                world.add_shape(body, Sphere{0.5f}, material);
            else
                world.add_shape(body, i % 3 == 1 ? Box{} : Box{{0.5f, 0.3f, 0.2f}}, material);
        }
    }
    template <class Event> static std::uint64_t key(const Event& e, std::uint64_t kind) {
        return (kind << 60) | (std::uint64_t(e.shape_a.index()) << 28) | e.shape_b.index();
    }
    void step() {
        world.step(1.0f / 60);
        for (const ContactBegin& e : world.contact_begins()) events.push_back(key(e, 1));
        for (const ContactEnd& e : world.contact_ends()) events.push_back(key(e, 2));
        for (const ContactHit& e : world.contact_hits()) events.push_back(key(e, 3));
    }
};

TEST(ThreadsInAHeap, StateAndEventsAreTheSameAtEveryStep) {
    std::vector<std::uint64_t> hashes;
    Heap alone(1);
    for (int i = 0; i < 90; ++i) {
        alone.step();
        hashes.push_back(alone.world.state_hash());
    }
    EXPECT_GT(alone.world.statistics().contacts, 1000u);
    for (const int threads : thread_counts) {
        Heap heap(threads);
        for (std::size_t i = 0; i < hashes.size(); ++i) {
            heap.step();
            ASSERT_EQ(heap.world.state_hash(), hashes[i]) << threads << " threads, step " << i;
        }
        EXPECT_EQ(heap.events, alone.events) << threads << " threads";
        EXPECT_EQ(heap.world.statistics().max_penetration, alone.world.statistics().max_penetration);
        EXPECT_EQ(heap.world.statistics().clamped_speeds, alone.world.statistics().clamped_speeds);
    }
}

TEST(ThreadsInAHeap, NumberMayChangeBetweenStepsAndOutlivesARestore) {
    Heap steady(1), changing(1);
    for (int i = 0; i < 40; ++i) {
        changing.world.set_threads(1 + i % 4);
        if (i == 20) {
            changing.world.set_threads(3);
            changing.world.restore(changing.world.save());
            EXPECT_EQ(changing.world.threads(), 3);
        }
        steady.step();
        changing.step();
        ASSERT_EQ(changing.world.state_hash(), steady.world.state_hash()) << "step " << i;
    }
}

TEST(ThreadsInAHeap, RefusesImpossibleNumbers) {
    World world;
    EXPECT_EQ(world.threads(), 1);
    for (const int count : {0, -1, 257, 1 << 30}) EXPECT_THROW(world.set_threads(count), Error) << count;
    EXPECT_EQ(world.threads(), 1);
}

} // namespace
} // namespace cairn_test
