// Triggers detect bodies that forces do not move (kinematic bodies, however they are moved, and characters), and the
// time at which they enter.
#include "support.h"

#include "validation/random_starts.h"

#include <cmath>
#include <string>
#include <vector>

namespace cairn_test {
namespace {

constexpr float frame = 1.0f / 60; // s

BodyId add(World& world, const Shape& shape, const Position& place, BodyType type, bool is_trigger,
           const Quat& turn = Quat(1, 0, 0, 0)) {
    BodyDef def;
    def.type = type;
    def.position = place;
    def.rotation = turn;
    const BodyId body = world.create_body(def);
    ShapeDef shape_def;
    shape_def.is_trigger = is_trigger;
    world.add_shape(body, shape, shape_def);
    return body;
}

// Events between these two bodies alone.
int entries_of(const World& world, BodyId trigger, BodyId other, bool inside) {
    int count = 0;
    for (const TriggerEvent& e : world.trigger_events())
        count += e.trigger_body == trigger && e.other_body == other && e.inside == inside;
    return count;
}

enum class Way { velocity, move_to, set_transform };

// Moves a body immediately, or in the step that follows.
void move(World& world, BodyId body, Way way, const glm::dvec3& by) {
    const Position to = world.body(body).position() + by;
    if (way == Way::velocity) world.body(body).set_linear_velocity(Vec3(by / double(frame)));
    if (way == Way::move_to) world.body(body).move_to({to, world.body(body).rotation()}, frame);
    if (way == Way::set_transform) world.body(body).set_transform(to, world.body(body).rotation());
}

// The bodies inside at the start of each step are those that have an enter event without a leave event.
void expect_seen(const Shape& zone, BodyType zone_type, Way way, std::uint32_t seed) {
    RandomStart random(seed);
    World world(without_sleep());
    const BodyId trigger = add(world, zone, random.place({0, 0, 0}), zone_type, true, random.quat());
    const double aside = random.uniform(-0.2, 0.2);
    const Sphere ball{0.3f};
    const BodyId body =
        add(world, ball, random.place({random.uniform(-2.2, -2.1), aside, 0}), BodyType::kinematic, false);
    bool inside = false, was_inside = false;
    QueryFilter triggers;
    triggers.triggers = true;
    triggers.kinematic_bodies = zone_type == BodyType::kinematic;
    triggers.static_bodies = zone_type == BodyType::static_;
    triggers.ignored_bodies = {body};
    for (int step = 0; step < 45; ++step) {
        move(world, body, way, random.turned({0.1, 0, 0}));
        const bool is_inside = !world.overlap(ball, {world.body(body).position(), Quat(1, 0, 0, 0)}, triggers).empty();
        world.step(frame);
        const int in = entries_of(world, trigger, body, true), out = entries_of(world, trigger, body, false);
        ASSERT_EQ(world.trigger_events().size(), std::size_t(in + out));
        inside = in - out + int(inside) != 0;
        was_inside |= inside;
        ASSERT_EQ(inside, is_inside) << "step " << step;
    }
    EXPECT_TRUE(was_inside);
}

class TriggerBodies : public ::testing::TestWithParam<Way> {};

TEST_P(TriggerBodies, SeeKinematicBodies) {
    const Shape zones[] = {Box{Vec3(0.5f, 1, 1)}, Sphere{0.8f}, Capsule{0.5f, 0.5f}, Cylinder{0.6f, 0.6f}, Plane{}};
    for (const Shape& zone : zones)
        for (const BodyType type : {BodyType::static_, BodyType::kinematic})
            for (std::uint32_t i = 0; i < 12; ++i) {
                if (type == BodyType::kinematic && std::holds_alternative<Plane>(zone)) continue;
                SCOPED_TRACE(std::to_string(zone.index()) + " " + std::to_string(int(type)) + " " + std::to_string(i));
                if (std::holds_alternative<Plane>(zone)) {
                    // A plane is approached along its normal, from above.
                    World world(without_sleep());
                    RandomStart random(i);
                    const Quat turn = random.quat(); // rotation of the plane, whose normal is y
                    const BodyId trigger = add(world, zone, random.place({0, 0, 0}), type, true, turn);
                    const BodyId body = add(world, Sphere{0.3f}, random.place({0, random.uniform(1, 2), 0}),
                                            BodyType::kinematic, false);
                    int in = 0, out = 0;
                    for (int step = 0; step < 40; ++step) {
                        move(world, body, GetParam(), random.turned({0, -0.1, 0}));
                        world.step(frame);
                        in += entries_of(world, trigger, body, true), out += entries_of(world, trigger, body, false);
                    }
                    EXPECT_EQ(in, 1);
                    EXPECT_EQ(out, 0);
                    continue;
                }
                expect_seen(zone, type, GetParam(), 100 + i);
                if (::testing::Test::HasFailure()) return;
            }
}
INSTANTIATE_TEST_SUITE_P(Ways, TriggerBodies, ::testing::Values(Way::velocity, Way::move_to, Way::set_transform),
                         [](const auto& info) {
                             return info.param == Way::velocity  ? "ByVelocity"
                                    : info.param == Way::move_to ? "ByTarget"
                                                                 : "ByTransform";
                         });

TEST(TriggerBodies, SeeCharactersThatWalkThroughThem) {
    for (std::uint32_t i = 0; i < 20; ++i) {
        RandomStart random(500 + i);
        World world(without_sleep());
        add(world, Plane{}, {0, 0, 0}, BodyType::static_, false);
        const double angle = random.uniform(0, 6.28), reach = random.uniform(0.1, 0.5);
        const glm::dvec3 way(std::cos(angle), 0, std::sin(angle));
        const BodyId zone = add(world, Box{Vec3(float(reach), 1, 3)}, {0, 1, 0}, BodyType::static_, true,
                                Quat(glm::angleAxis(-angle, glm::dvec3(0, 1, 0))));
        const BodyId body =
            add(world, Capsule{0.5f, 0.3f}, -3.0 * way + glm::dvec3(0, 0.82, 0), BodyType::kinematic, false);
        world.body(body).set_character(CharacterDef{});
        world.body(body).set_walk_velocity(Vec3(3.0 * way));
        double in = -10, out = -10; // x of the body at enter and leave
        for (int step = 0; step < 130; ++step) {
            const double at = glm::dot(world.body(body).position(), way);
            world.step(frame);
            if (entries_of(world, zone, body, true)) in = in == -10 ? at : 10;
            if (entries_of(world, zone, body, false)) out = out == -10 ? at : 10;
        }
        EXPECT_NEAR(in, -(reach + 0.3), 0.06);
        EXPECT_NEAR(out, reach + 0.3, 0.06);
    }
}

// A moving sensor reports the level that it enters; a static trigger does not, and two triggers do not report each
// other.
TEST(TriggerBodies, SeeStaticBodiesOnlyWhereTheyMove) {
    World world(without_sleep());
    const BodyId wall = add(world, Box{Vec3(0.1f, 2, 2)}, {0, 0, 0}, BodyType::static_, false);
    const BodyId fixed = add(world, Box{Vec3(1)}, {0, 0, 0}, BodyType::static_, true);
    const BodyId sensor = add(world, Sphere{0.5f}, {-2.05, 0, 0}, BodyType::kinematic, true);
    int in = 0, out = 0;
    for (int step = 0; step < 60; ++step) {
        move(world, sensor, Way::velocity, {0.1, 0, 0});
        world.step(frame);
        in += entries_of(world, sensor, wall, true), out += entries_of(world, sensor, wall, false);
        for (const TriggerEvent& e : world.trigger_events())
            EXPECT_TRUE(e.trigger_body == sensor && e.other_body == wall);
    }
    EXPECT_EQ(in, 1);
    EXPECT_EQ(out, 1);
    world.destroy_body(fixed);
}

TEST(TriggerBodies, TellThatAKinematicBodyIsGone) {
    World world(without_sleep());
    const BodyId zone = add(world, Box{Vec3(1)}, {0, 0, 0}, BodyType::static_, true);
    const BodyId body = add(world, Sphere{0.5f}, {0.5, 0, 0}, BodyType::kinematic, false);
    world.step(frame);
    EXPECT_EQ(entries_of(world, zone, body, true), 1);
    for (int step = 0; step < 5; ++step) {
        world.step(frame);
        EXPECT_TRUE(world.trigger_events().empty());
    }
    world.destroy_body(body);
    world.step(frame);
    ASSERT_EQ(world.trigger_events().size(), 1u);
    EXPECT_FALSE(world.trigger_events()[0].inside);
}

// The result does not depend on which of the two is the mesh, or on which of them moves.
TEST(TriggerBodies, SeeMeshesThatMoveAndAreMeshes) {
    const std::vector<Vec3> corners{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    const std::vector<std::uint32_t> triangles{0, 2, 1, 0, 3, 2};
    const Shape surfaces[] = {Mesh(corners, triangles), HeightField(2, 2, {2, 2}, std::vector<float>(4, 0.0f))};
    for (const Shape& surface : surfaces)
        for (const bool surface_is_trigger : {true, false})
            for (const bool surface_moves : {true, false})
                for (const Way way : {Way::velocity, Way::set_transform}) {
                    World world(without_sleep());
                    const auto type = [](bool moves) { return moves ? BodyType::kinematic : BodyType::static_; };
                    const BodyId sheet = add(world, surface, {0, 0, 0}, type(surface_moves), surface_is_trigger);
                    const BodyId box =
                        add(world, Box{Vec3(0.2f)}, {0.1, 1.03, 0.1}, type(!surface_moves), !surface_is_trigger);
                    const BodyId trigger = surface_is_trigger ? sheet : box, other = surface_is_trigger ? box : sheet;
                    int in = 0, out = 0;
                    for (int step = 0; step < 25; ++step) {
                        move(world, surface_moves ? sheet : box, way, {0, surface_moves ? 0.1 : -0.1, 0});
                        world.step(frame);
                        in += entries_of(world, trigger, other, true), out += entries_of(world, trigger, other, false);
                    }
                    EXPECT_EQ(in, 1) << surface.index() << surface_is_trigger << surface_moves << int(way);
                    EXPECT_EQ(out, 1) << surface.index() << surface_is_trigger << surface_moves << int(way);
                }
}

// A body that passes through a gate within a step, by velocity or by being moved, enters and leaves at the times that
// follow from its path.
TEST(TriggerBodies, SayWhenSomethingPassed) {
    for (const BodyType type : {BodyType::dynamic, BodyType::kinematic})
        for (std::uint32_t i = 0; i < 30; ++i) {
            RandomStart random(700 + i);
            WorldDef weightless = without_sleep();
            weightless.gravity = {0, 0, 0};
            World world(weightless);
            const double half = random.uniform(0.01, 0.1), radius = random.uniform(0.03, 0.1);
            const double speed = random.uniform(100, 300), start = -random.uniform(3, 6);
            const BodyId zone = add(world, Box{Vec3(float(half), 2, 2)}, random.place({0, 0, 0}), BodyType::static_,
                                    true, random.quat());
            const BodyId body =
                add(world, Sphere{float(radius)}, random.place({start, random.uniform(-1, 1), 0}), type, false);
            world.body(body).set_linear_velocity(Vec3(random.turned({speed, 0, 0})));
            double in = -1, out = -1; // s
            for (int step = 0; step < 8; ++step) {
                world.step(frame);
                for (const TriggerEvent& e : world.trigger_events()) {
                    EXPECT_EQ(e.trigger_body, zone);
                    (e.inside ? in : out) = double(frame) * step + double(e.time);
                }
            }
            const double first = (-start - half - radius) / speed, last = (-start + half + radius) / speed;
            const auto step_of = [](double time) { return std::floor(time / double(frame)); };
            if (step_of(first) != step_of(last)) continue; // reported at the beginning of the step after it
            EXPECT_NEAR(in, first, 2e-5) << i;
            EXPECT_NEAR(out, last, 2e-5) << i;
        }
}

// n triggers in one place must not make n^2 pairs.
TEST(TriggerBodies, ThousandsInOnePlaceCostLittle) {
    World world(without_sleep());
    for (int i = 0; i < 4000; ++i) add(world, Box{Vec3(1)}, {0, 0, 0}, BodyType::kinematic, true);
    for (int step = 0; step < 3; ++step) world.step(frame);
    EXPECT_EQ(world.statistics().candidate_pairs, 0u);
    EXPECT_TRUE(world.trigger_events().empty());
}

} // namespace
} // namespace cairn_test
