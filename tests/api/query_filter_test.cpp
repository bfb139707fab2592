// Query filters: every kind of query with every part of the filter.
#include "test_world.h"

#include <functional>
#include <set>

namespace cairn::test {
namespace {

// Boxes of different body types side by side along x, 2 m apart; queries go along the row.
struct Row {
    World world{weightless()};
    BodyId fixed, kinematic, dynamic, trigger, aloof;
    Row() {
        fixed = add_body(world, body_at({0, 0, 0}, BodyType::static_), Box{});
        kinematic = add_body(world, body_at({2, 0, 0}, BodyType::kinematic), Box{});
        dynamic = add_body(world, body_at({4, 0, 0}), Box{});
        ShapeDef def;
        def.is_trigger = true;
        trigger = add_body(world, body_at({6, 0, 0}, BodyType::static_), Box{}, def);
        def.is_trigger = false;
        def.filter = {4, 2}; // in layer 4, collides with layer 2
        aloof = add_body(world, body_at({8, 0, 0}, BodyType::static_), Box{}, def);
    }
};

using Bodies = std::set<BodyId>;

// One function per kind of query, which returns the bodies of the row that the query finds.
std::vector<std::function<Bodies(const World&, const QueryFilter&)>> queries() {
    const auto bodies_of = [](const World& world, const std::vector<ShapeId>& shapes) {
        Bodies bodies;
        for (const ShapeId id : shapes) bodies.insert(world.body_of(id));
        return bodies;
    };
    // Queries for the nearest shape only are made once from above each body.
    const auto each = [](auto ask) {
        return [ask](const World& world, const QueryFilter& filter) {
            Bodies bodies;
            for (int i = 0; i < 5; ++i)
                if (const auto hit = ask(world, Position(2.0 * i, 3, 0), filter)) bodies.insert(hit->body);
            return bodies;
        };
    };
    return {
        [](const World& world, const QueryFilter& filter) {
            Bodies bodies;
            for (const RayHit& hit : world.cast_ray_all({-5, 0, 0}, {1, 0, 0}, 20, filter)) bodies.insert(hit.body);
            return bodies;
        },
        [=](const World& world, const QueryFilter& filter) {
            return bodies_of(world, world.overlap(Box{{20, 1, 1}}, {}, filter));
        },
        [=](const World& world, const QueryFilter& filter) {
            return bodies_of(world, world.overlap_bounds({{-20, -1, -1}, {20, 1, 1}}, filter));
        },
        each([](const World& world, const Position& at, const QueryFilter& filter) {
            return world.cast_ray(at, {0, -1, 0}, 5, filter);
        }),
        each([](const World& world, const Position& at, const QueryFilter& filter) {
            return world.cast_shape(Sphere{0.1f}, {at, Quat(1, 0, 0, 0)}, {0, -5, 0}, filter);
        }),
        each([](const World& world, const Position& at, const QueryFilter& filter) {
            return world.closest_point(at, 2.6, filter);
        }),
    };
}

TEST(QueryFilter, EveryQueryHeedsEveryPart) {
    const Row row;
    const auto [fixed, kinematic, dynamic, trigger, aloof] =
        std::tuple(row.fixed, row.kinematic, row.dynamic, row.trigger, row.aloof);
    for (const auto& ask : queries()) {
        const auto sees = [&](const QueryFilter& filter) { return ask(row.world, filter); };
        EXPECT_EQ(sees({}), (Bodies{fixed, kinematic, dynamic, aloof}));
        EXPECT_EQ(sees({.static_bodies = false}), (Bodies{kinematic, dynamic}));
        EXPECT_EQ(sees({.kinematic_bodies = false}), (Bodies{fixed, dynamic, aloof}));
        EXPECT_EQ(sees({.dynamic_bodies = false}), (Bodies{fixed, kinematic, aloof}));
        EXPECT_EQ(sees({.triggers = true}), (Bodies{fixed, kinematic, dynamic, trigger, aloof}));
        EXPECT_EQ(sees({.layers = 4}), (Bodies{aloof}));
        EXPECT_EQ(sees({.layers = 1}), (Bodies{fixed, kinematic, dynamic}));
        EXPECT_EQ(sees({.own_layers = 1}), (Bodies{fixed, kinematic, dynamic}));
        EXPECT_EQ(sees({.own_layers = 2}), (Bodies{fixed, kinematic, dynamic, aloof}));
        EXPECT_EQ(sees({.ignored_bodies = {kinematic, aloof}}), (Bodies{fixed, dynamic}));
        EXPECT_EQ(sees({.static_bodies = false, .ignored_bodies = {dynamic}}), (Bodies{kinematic}));
    }
}

TEST(QueryFilter, AnyIsOneOfAll) {
    World world(weightless());
    for (int i = 0; i < 200; ++i) add_body(world, body_at({0.7 * i, 0, 0}, BodyType::static_), Box{});
    const QueryFilter any{.any = true};
    EXPECT_EQ(world.overlap(Box{{200, 1, 1}}, {}, any).size(), 1u);
    EXPECT_EQ(world.overlap_bounds({{-200, -1, -1}, {200, 1, 1}}, any).size(), 1u);
    EXPECT_EQ(world.cast_ray_all({-5, 0, 0}, {1, 0, 0}, 200, any).size(), 1u);
    EXPECT_TRUE(world.cast_ray({-5, 0, 0}, {1, 0, 0}, 200, any));
    EXPECT_TRUE(world.cast_shape(Sphere{}, {{-5, 0, 0}, Quat(1, 0, 0, 0)}, {200, 0, 0}, any));
    EXPECT_TRUE(world.closest_point({-5, 0, 0}, 300, any));
    // Queries that miss every shape find nothing.
    EXPECT_TRUE(world.overlap(Box{}, {{0, 9, 0}, Quat(1, 0, 0, 0)}, any).empty());
    EXPECT_FALSE(world.cast_ray({-5, 9, 0}, {1, 0, 0}, 200, any));
    EXPECT_FALSE(world.cast_shape(Sphere{}, {{-5, 9, 0}, Quat(1, 0, 0, 0)}, {200, 0, 0}, any));
    EXPECT_FALSE(world.closest_point({-5, 9, 0}, 3, any));
}

TEST(QueryFilter, BodiesThatAreNoMoreCannotBeIgnored) {
    Row row;
    row.world.destroy_body(row.kinematic);
    row.world.step(frame);
    int refused = 0;
    for (const auto& ask : queries()) {
        for (const BodyId id : {row.kinematic, BodyId{}}) {
            try {
                ask(row.world, {.ignored_bodies = {id}});
            } catch (const Error& error) {
                refused += error.code() == ErrorCode::invalid_handle && error.field() == "BodyId";
            }
        }
    }
    EXPECT_EQ(refused, 12);
}

} // namespace
} // namespace cairn::test
