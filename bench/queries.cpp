#include "bench/queries.h"

#include "bench/builder.h"

#include <cairn/world.h>

#include <algorithm>
#include <ctime>
#include <functional>

namespace cairn::bench {

namespace {

constexpr float frame = 1.0f / 60;
constexpr int steps_to_rest = 400;
constexpr int across = 20; // bodies per layer along x and along z
constexpr float spacing = 1.1f, pen = 0.5f * spacing * across + 0.5f;
constexpr Quat unturned{1, 0, 0, 0};

void add(World& world, const Position& position, const Quat& rotation, const Shape& shape, BodyType type) {
    BodyDef def;
    def.type = type;
    def.position = position;
    def.rotation = rotation;
    world.add_shape(world.create_body(def), shape);
}

Hull random_hull(Random& random) {
    std::vector<Vec3> points;
    for (int i = 0; i < 16; ++i) points.push_back(0.5f * random.direction());
    return Hull(points);
}

void build(World& world, int bodies) {
    Random random(7);
    add(world, {}, unturned, Plane{}, BodyType::static_);
    for (const float side : {-1.0f, 1.0f}) {
        add(world, {side * (pen + 0.5f), 20, 0}, unturned, Box{{0.5f, 20, pen + 1}}, BodyType::static_);
        add(world, {0, 20, side * (pen + 0.5f)}, unturned, Box{{pen, 20, 0.5f}}, BodyType::static_);
    }
    for (int i = 0; i < bodies; ++i) {
        const int x = i % across, z = i / across % across, layer = i / across / across;
        const Position place(spacing * (float(x) - 0.5f * (across - 1)), 0.6f + spacing * float(layer),
                             spacing * (float(z) - 0.5f * (across - 1)));
        const float size = random.between(0.2f, 0.5f);
        const Shape shapes[] = {Sphere{size}, Box{{size, random.between(0.2f, 0.5f), 0.3f}}, Capsule{0.2f, size},
                                Cylinder{0.3f, size}, random_hull(random)};
        add(world, place, random.rotation(), shapes[random.below(5)], BodyType::dynamic);
    }
    for (int i = 0; i < steps_to_rest; ++i) world.step(frame);
}

struct Place {
    Position from;
    Vec3 direction;
    float length;
    Quat rotation;
};

} // namespace

std::vector<QueryRate> measure_queries(const QueryOptions& options) {
    World world;
    build(world, options.bodies);
    Random random(11);
    std::vector<Place> places;
    const float top = 1.5f * float(options.bodies) / float(across * across);
    for (int i = 0; i < options.queries; ++i) {
        const Position from(random.between(-pen, pen), random.between(0, top), random.between(-pen, pen));
        places.push_back({from, random.direction(), random.between(0.1f, 30), random.rotation()});
    }
    const Shape box = Box{{0.25f, 0.25f, 0.25f}}, ball = Sphere{0.25f};
    std::vector<Place> free; // positions without overlap, as for bodies that move through a world
    for (const Place& place : places)
        if (world.overlap(box, {place.from, place.rotation}).empty()) free.push_back(place);
    const auto cast = [&](const Shape& shape) {
        return [&](const Place& p) {
            return world.cast_shape(shape, {p.from, p.rotation}, p.length * p.direction).has_value();
        };
    };
    const struct {
        const char* name;
        const std::vector<Place>& places;
        std::function<bool(const Place&)> ask;
    } kinds[] = {
        {"rays", free, [&](const Place& p) { return world.cast_ray(p.from, p.direction, p.length).has_value(); }},
        {"box casts", free, cast(box)},
        {"ball casts", free, cast(ball)},
        {"closest points", places, [&](const Place& p) { return world.closest_point(p.from, 30).has_value(); }},
        {"box overlaps", places,
         [&](const Place& p) {
             return !world.overlap(box, {p.from, p.rotation}).empty();
         }},
        {"ball overlaps", places,
         [&](const Place& p) {
             return !world.overlap(ball, {p.from, p.rotation}).empty();
         }},
        {"rays from all", places,
         [&](const Place& p) { return world.cast_ray(p.from, p.direction, p.length).has_value(); }},
        {"casts from all", places, cast(box)},
    };
    std::vector<std::vector<double>> rates(std::size(kinds));
    std::vector<QueryRate> results(std::size(kinds));
    for (int round = 0; round < options.rounds; ++round)
        for (std::size_t k = 0; k < std::size(kinds); ++k) {
            const std::vector<Place>& asked = kinds[k].places;
            int met = 0;
            const std::clock_t begin = std::clock();
            for (const Place& place : asked) met += kinds[k].ask(place);
            const double seconds = double(std::max<std::clock_t>(std::clock() - begin, 1)) / CLOCKS_PER_SEC;
            rates[k].push_back(double(asked.size()) / seconds);
            results[k] = {kinds[k].name, 0, double(met) / double(asked.size())};
        }
    for (std::size_t k = 0; k < std::size(kinds); ++k) {
        std::sort(rates[k].begin(), rates[k].end());
        results[k].per_second = rates[k][rates[k].size() / 2];
    }
    return results;
}

} // namespace cairn::bench
