// The number of ranks that step a world together does not matter: after every step, each rank has the state of a single
// process.
#include "rank_courses.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cairn_test {
namespace {

using namespace cairn;

class Ranks : public testing::TestWithParam<NamedScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Ranks, testing::ValuesIn(scenes().begin(), scenes().end()),
                         [](const testing::TestParamInfo<NamedScene>& info) { return std::string(info.param.name); });

TEST_P(Ranks, AnyNumberGivesTheSameState) {
    Scene& scene = GetParam().make();
    World world(scene.settings());
    scene.build(world);
    const Snapshot start = world.save();
    constexpr int steps = 150;
    const Course alone = run_alone(scene, world, steps);
    for (const int ranks : {2, 3}) {
        const std::vector<Course> courses = run_on_ranks(scene, start, ranks, steps, 1);
        for (std::size_t rank = 0; rank < courses.size(); ++rank)
            expect_same(alone, courses[rank], std::to_string(rank) + " of " + std::to_string(ranks) + " ranks");
    }
}

// A heap in a pit, which is partitioned among the ranks: balls, cubes, bricks, rocks and rods, some with restitution or
// damping, a rotating paddle, a conveyor below, and a lid in contact with more bodies than there are graph colors. One
// body is so fast that its speed is clamped.
class CutHeap : public Scene {
  public:
    explicit CutHeap(Integrator integrator) : integrator_(integrator) {}
    WorldDef settings() const override {
        WorldDef def;
        def.integrator = integrator_;
        return def;
    }
    void build(World& world) override {
        ShapeDef belt;
        belt.surface_velocity = {1, 0, 0};
        add_fixed(world, Box{{12, 1, 12}}, {0, -1, 0}, belt);
        add_moved(world, Box{{4, 0.4f, 0.4f}}, {0, 1, 0}, BodyType::kinematic).set_angular_velocity({0, 2, 0});
        for (const float side : {-1.0f, 1.0f}) {
            add_fixed(world, Box{{0.5f, 10, 6}}, {5.0 * side, 9, 0});
            add_fixed(world, Box{{6, 10, 0.5f}}, {0, 9, 5.0 * side});
        }
        Numbers numbers(5);
        const Hull stone = rock(numbers, 12);
        // With the other integrators thin rods gain speed until it is not a number (docs/scale.md).
        const float thickness = integrator_ == Integrator::semi_implicit_euler ? 0.02f : 0.3f;
        const Box rod{{0.7f, thickness, thickness}};
        for (int i = 0; i < 500; ++i) {
            ShapeDef def;
            def.material.restitution = i % 4 == 0 ? 0.5f : 0.0f;
            def.material.rolling_friction = i % 6 == 0 ? 0.05f : 0.0f;
            const Shape shapes[] = {Sphere{0.5f}, Box{}, Box{{0.5f, 0.3f, 0.2f}}, stone, rod};
            const Position at{0.9 * (i % 9) - 3.6, 1.2 + 0.8 * (i / 81), 0.9 * (i / 9 % 9) - 3.6};
            const float damping = i % 7 == 0 ? 0.5f : 0.0f;
            add_moved(world, shapes[i % 5], at, BodyType::dynamic, def, damping).set_rotation(numbers.rotation());
        }
        ShapeDef light;
        light.density = 100;
        add_moved(world, Box{{4.3f, 0.2f, 4.3f}}, {0, 7, 0}, BodyType::dynamic, light);
        for (int i = 0; i < 100; ++i)
            add_moved(world, Sphere{0.2f}, {0.75 * (i % 10) - 3.4, 7.4, 0.75 * (i / 10) - 3.4}, BodyType::dynamic);
        add_moved(world, Sphere{0.3f}, {0, 60, 0}, BodyType::dynamic).set_linear_velocity({0, 1900, 1000});
    }

  private:
    static Body add_moved(World& world, const Shape& shape, const Position& at, BodyType type,
                          const ShapeDef& shape_def = {}, float damping = 0) {
        BodyDef def;
        def.type = type;
        def.angular_damping = damping;
        def.position = at;
        return world.body(add(world, shape, def, shape_def));
    }
    Integrator integrator_;
};

class RanksInAHeap : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Integrators, RanksInAHeap,
                         testing::Values(Integrator::semi_implicit_euler, Integrator::rk4, Integrator::explicit_euler));

TEST_P(RanksInAHeap, StateIsTheSameAtEveryStep) {
    CutHeap scene(GetParam());
    World world(scene.settings());
    scene.build(world);
    run_alone(scene, world, 60);
    for (int i = 0; i < 100 && world.statistics().overflow_contacts == 0; ++i) run_alone(scene, world, 1);
    // The lid lies on the heap.
    const Snapshot start = world.save();
    constexpr int steps = 9;
    const Course alone = run_alone(scene, world, steps);
    EXPECT_GT(world.statistics().contacts, 300u);
    EXPECT_GT(alone.overflow_contacts, 0u);
    EXPECT_GT(alone.clamped_speeds, 0u);
    for (const auto& [ranks, threads] : {std::pair(2, 1), std::pair(4, 1), std::pair(3, 2)}) {
        const std::vector<Course> courses = run_on_ranks(scene, start, ranks, steps, threads);
        for (std::size_t rank = 0; rank < courses.size(); ++rank) {
            expect_same(alone, courses[rank], std::to_string(rank) + " of " + std::to_string(ranks) + " ranks");
            EXPECT_GT(courses[rank].exchanges, 1000); // the heap was partitioned
        }
        // Each rank has sent its share of the contact records, and no more.
        std::size_t whole = 0;
        for (const Course& course : courses) whole += course.bytes_of_end;
        EXPECT_GT(whole, 150 * world.statistics().candidate_pairs);
        for (const Course& course : courses) {
            EXPECT_GT(course.bytes_of_end, whole / std::size_t(2 * ranks));
            EXPECT_LT(course.bytes_of_end, 3 * whole / std::size_t(2 * ranks));
        }
    }
}

// Balls that fill a narrow shaft: whether they count as a column that could buckle depends on the normals of contacts
// with the walls, of which each rank has a part.
class FilledShaft : public Scene {
  public:
    void build(World& world) override {
        add_fixed(world, Box{{1, 0.1f, 1}}, {0, -0.1, 0});
        for (const float side : {-1.0f, 1.0f}) {
            add_fixed(world, Box{{0.1f, 4, 0.5f}}, {0.35 * side, 4, 0});
            add_fixed(world, Box{{0.5f, 4, 0.1f}}, {0, 4, 0.35 * side});
        }
        for (int i = 0; i < 640; ++i) {
            BodyDef def;
            const double aside = i / 16 % 2 * 0.05 - 0.025; // otherwise each would stand on the one below
            def.position = {0.115 * (i % 4 - 1.5) + aside, 0.06 + 0.11 * (i / 16), 0.115 * (i / 4 % 4 - 1.5) - aside};
            add(world, Sphere{0.05f}, def);
        }
    }
};

TEST(RanksInAShaft, StateIsTheSameAtEveryStep) {
    FilledShaft scene;
    World world(scene.settings());
    scene.build(world);
    run_alone(scene, world, 25);
    const Snapshot start = world.save();
    constexpr int steps = 12;
    const Course alone = run_alone(scene, world, steps);
    EXPECT_LE(world.statistics().max_substeps, 8);
    for (const int ranks : {2, 3}) {
        const std::vector<Course> courses = run_on_ranks(scene, start, ranks, steps, 1);
        for (std::size_t rank = 0; rank < courses.size(); ++rank) {
            expect_same(alone, courses[rank], std::to_string(rank) + " of " + std::to_string(ranks) + " ranks");
            EXPECT_GT(courses[rank].exchanges, 100); // the shaft was partitioned
        }
    }
}

TEST(RanksOfAWorld, RefusesARankThatIsNoneOfThem) {
    World world;
    const auto post = std::make_shared<Post>(2);
    EXPECT_THROW(world.set_communicator(std::make_shared<LocalRank>(post, 2)), Error);
    EXPECT_THROW(world.set_communicator(std::make_shared<LocalRank>(post, -1)), Error);
    world.step(0.1f); // alone, as before
}

// A run continues with any number of ranks from a state that several ranks have reached.
TEST(RanksOfAWorld, AnotherNumberOfThemGoesOnWhereTheLastOnesWere) {
    CutHeap scene(Integrator::semi_implicit_euler);
    World world(scene.settings());
    scene.build(world);
    const Snapshot start = world.save();
    const Course whole = run_alone(scene, world, 40);
    const Snapshot half = run_on_ranks(scene, start, 3, 20, 1)[1].end;
    EXPECT_EQ(run_on_ranks(scene, half, 2, 20, 1)[0].end.bytes, whole.end.bytes);
}

} // namespace
} // namespace cairn_test
