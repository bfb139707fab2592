// Floors and walls of triangles as game levels have them: adjacent tiles, T-junctions where an edge has more triangles
// on one side than on the other, sheets without thickness that are front-facing from both sides, and walls that are
// hardly thicker.
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cairn_test {
namespace {

WorldDef with_gravity(const Vec3& gravity) {
    WorldDef def = without_sleep();
    def.gravity = gravity;
    return def;
}

struct Triangles {
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> indices;

    // A grid over a rectangle at the given height, with triangles that face up or down.
    void add_grid(glm::vec2 lo, glm::vec2 hi, float height, int columns, int rows, bool is_seen_from_above) {
        const auto first = std::uint32_t(corners.size()), stride = std::uint32_t(rows) + 1;
        for (int i = 0; i <= columns; ++i)
            for (int k = 0; k <= rows; ++k)
                corners.push_back({lo.x + (hi.x - lo.x) * float(i) / float(columns), height,
                                   lo.y + (hi.y - lo.y) * float(k) / float(rows)});
        for (std::uint32_t i = 0; i < std::uint32_t(columns); ++i)
            for (std::uint32_t k = 0; k < std::uint32_t(rows); ++k) {
                const std::uint32_t a = first + i * stride + k, b = a + 1, c = a + stride, d = c + 1;
                if (is_seen_from_above)
                    indices.insert(indices.end(), {a, b, c, b, d, c});
                else
                    indices.insert(indices.end(), {a, c, b, b, c, d});
            }
    }
    Mesh mesh() const { return Mesh(corners, indices); }
};

constexpr int tile_kinds = 5;
void add_tile(World& world, BodyId floor, int kind, glm::vec2 lo, glm::vec2 hi, int cells, ShapeDef def) {
    const glm::vec2 half = 0.5f * (hi - lo), middle = 0.5f * (lo + hi);
    def.position = {middle.x, 0, middle.y};
    if (kind == 0) {
        def.position.y = -0.25f;
        world.add_shape(floor, Box{{half.x, 0.25f, half.y}}, def);
    } else if (kind == 1) {
        Triangles tile;
        tile.add_grid(-half, half, 0, cells, cells, true);
        world.add_shape(floor, tile.mesh(), def);
    } else if (kind == 2) {
        const std::vector<float> heights(std::size_t((cells + 1) * (cells + 1)), 0.0f);
        world.add_shape(floor, HeightField(cells + 1, cells + 1, 2.0f * half / float(cells), heights), def);
    } else if (kind == 3) {
        std::vector<Vec3> corners = box_corners({half.x, 0.25f, half.y});
        for (Vec3& p : corners)
            if (p.y < 0) p.x *= 0.5f, p.z *= 0.5f;
        def.position.y = -0.25f;
        world.add_shape(floor, Hull(corners), def);
    } else {
        world.add_shape(floor, Plane{{0, 1, 0}, {1, 0, 0}, half}, def);
    }
}

struct Bump {
    double up, turn; // velocity changes as fractions of the speed: upward, and sideways at the end
};
// A ball crosses two rows of tiles of two kinds.
Bump bump_on_tiles(RandomStart& random, int kind, int other_kind, bool rolls) {
    World world(with_gravity(Vec3(random.turned({0, -gravity, 0}))));
    const BodyId floor =
        world.create_body({.type = BodyType::static_, .position = random.place({0, 0, 0}), .rotation = random.quat()});
    ShapeDef tile;
    tile.material = surface(rolls ? 0.6f : 0, 0);
    const auto cells = [&] { return 1 + int(random.uniform(0, 4)); };
    float x = -1.5f;
    for (int i = 0; i < 6; ++i) {
        const float next = x + float(random.uniform(0.6, 1.4)), seam = float(random.uniform(-0.2, 0.2));
        add_tile(world, floor, i % 2 ? other_kind : kind, {x, -2}, {next, seam}, cells(), tile);
        add_tile(world, floor, i % 2 ? kind : other_kind, {x, seam}, {next, 2}, cells(), tile);
        x = next;
    }
    const double radius = random.uniform(0.05, 0.3), speed = std::exp(random.uniform(-1.2, 2)),
                 heading = random.uniform(-0.15, 0.15);
    const glm::dvec3 v{speed * std::cos(heading), 0, speed * std::sin(heading)};
    BodyDef def;
    def.position = random.place({-0.8, radius, 0});
    def.linear_velocity = Vec3(random.turned(v));
    if (rolls) def.angular_velocity = Vec3(random.turned({v.z / radius, 0, -v.x / radius}));
    const BodyId ball = add_body(world, Sphere{float(radius)}, def, tile.material);
    const auto along_floor = [&](const Position& p) { return (glm::conjugate(random.rotation()) * p).x; };
    const double end = along_floor(random.place({double(x) - 1.2, 0, 0}));
    Bump bump{0, 0};
    for (int i = 0; i < 240 && along_floor(world.body(ball).position()) < end; ++i) {
        world.step(1 / 60.0f);
        bump.up = std::max(bump.up, std::fabs(random.back(world.body(ball).linear_velocity()).y) / speed);
    }
    const glm::dvec3 last = random.back(world.body(ball).linear_velocity());
    bump.turn = std::fabs(std::atan2(last.z, last.x) - heading);
    return bump;
}

// Adds a rectangle of 4 m centered at `way`, of any kind that add_tile knows except the hull.
void add_ramp_part(World& world, BodyId body, int kind, const Quat& turn, const Vec3& way) {
    ShapeDef def;
    def.material = surface(0, 0);
    def.rotation = turn;
    def.position = turn * way;
    Triangles grid;
    grid.add_grid({-2, -2}, {2, 2}, 0, 1, 1, true);
    if (kind == 0) def.position = def.position - turn * Vec3{0, 0.2f, 0};
    if (kind == 0) world.add_shape(body, Box{{2, 0.2f, 2}}, def);
    if (kind == 1) world.add_shape(body, grid.mesh(), def);
    if (kind == 2) world.add_shape(body, HeightField(2, 2, {4, 4}, std::vector<float>(4, 0.0f)), def);
    if (kind == 3) world.add_shape(body, Plane{{0, 1, 0}, {1, 0, 0}, glm::vec2{2, 2}}, def);
}
// A box slides from a floor onto a ramp. Returns the remaining fraction of its speed, corrected for the height gained.
double speed_on_ramp(RandomStart& random, int floor_kind, int ramp_kind, double angle) {
    World world(with_gravity(Vec3(random.turned({0, -gravity, 0}))));
    const BodyId ground =
        world.create_body({.type = BodyType::static_, .position = random.place({0, 0, 0}), .rotation = random.quat()});
    const Quat turn = glm::angleAxis(float(angle), Vec3{0, 0, 1});
    add_ramp_part(world, ground, floor_kind, Quat{1, 0, 0, 0}, {-2, 0, 0});
    add_ramp_part(world, ground, ramp_kind, turn, {2, 0, 0});
    const double half = random.uniform(0.05, 0.3), speed = std::exp(random.uniform(0.5, 2.3));
    BodyDef def;
    def.position = random.place({-half - random.uniform(0.5, 0.9), half, 0});
    def.rotation = random.quat();
    def.linear_velocity = Vec3(random.turned({speed, 0, 0}));
    const BodyId box = add_body(world, Box{{float(half), float(half), float(half)}}, def, surface(0, 0));
    for (int i = 0; i < 120; ++i) {
        world.step(1 / 60.0f);
        const glm::dvec3 at =
            glm::conjugate(random.rotation()) * (world.body(box).position() - random.place({0, 0, 0}));
        if (at.x < half + 0.05) continue;
        const double v = double(glm::length(world.body(box).linear_velocity()));
        return std::sqrt(v * v + 2 * gravity * (at.y - half)) / speed;
    }
    return 0;
}

// A floor made of quarters of a rectangle, quarters of some of these, and so on, each with its own vertices, so that an
// edge may have more triangles on one side than on the other. Vertices at the same place have the same height.
class CrackedFloor {
  public:
    CrackedFloor(RandomStart& random, float roughness) : random_(random), roughness_(roughness) {}
    Mesh mesh() {
        for (int i = -2; i < 8; ++i)
            for (int k = -3; k < 3; ++k) add({2 * i, 2 * k}, {2 * i + 2, 2 * k + 2}, 4);
        return triangles_.mesh();
    }

  private:
    float height_at(glm::vec2 p) const {
        const auto seed = std::uint32_t(std::lround(p.x * 1e5f) * 1000003 + std::lround(p.y * 1e5f));
        return roughness_ * float(RandomStart(seed).uniform(-1, 1));
    }
    void add(glm::vec2 lo, glm::vec2 hi, int depth) {
        if (depth > 0 && random_.uniform(0, 3) > 1) {
            const glm::vec2 middle{lo.x + (hi.x - lo.x) * float(random_.uniform(0.1, 0.9)), 0.5f * (lo.y + hi.y)};
            add(lo, middle, depth - 1), add(middle, hi, depth - 1);
            add({middle.x, lo.y}, {hi.x, middle.y}, depth - 1), add({lo.x, middle.y}, {middle.x, hi.y}, depth - 1);
            return;
        }
        const auto first = std::uint32_t(triangles_.corners.size());
        for (const glm::vec2 p : {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}})
            triangles_.corners.push_back({p.x, height_at(p), p.y});
        for (const std::uint32_t corner : {0u, 2u, 1u, 0u, 3u, 2u}) triangles_.indices.push_back(first + corner);
    }
    RandomStart& random_;
    const float roughness_; // m
    Triangles triangles_;
};

constexpr int thrown_kinds = 6;
BodyId add_thrown(World& world, RandomStart& random, int kind, const BodyDef& def) {
    const float h = float(random.uniform(0.03, 0.3));
    const BodyId body = world.create_body(def);
    if (kind == 0) world.add_shape(body, Sphere{h});
    if (kind == 1) world.add_shape(body, Box{{h, h * float(random.uniform(0.3, 1)), h}});
    if (kind == 2) world.add_shape(body, Capsule{h, h * 0.6f, {}});
    if (kind == 3) world.add_shape(body, Cylinder{h, h * 0.7f});
    if (kind == 4) {
        std::vector<Vec3> points;
        for (int i = 0; i < 14; ++i)
            points.push_back(h *
                             glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))));
        world.add_shape(body, Hull(points));
    }
    if (kind == 5) {
        world.add_shape(body, Box{{h, h * 0.4f, h * 0.4f}});
        world.add_shape(body, Box{{h * 0.3f, h * 0.6f, h * 0.3f}}, {.position = {0, h, 0}});
    }
    return body;
}

Vec3 random_vector(RandomStart& random, double most) {
    return {random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
}

// Two bodies are pressed onto a wall from its two sides: the number that is behind it after three seconds, and their
// greatest speed.
struct Held {
    int lost = 0;
    double fastest = 0; // m/s
};
enum class Sheets { one_mesh, two_meshes, rectangles, mesh_and_rectangle };
Held press_on_wall(RandomStart& random, int kind, Sheets sheets, float thickness) {
    World world(with_gravity({0, 0, 0}));
    Triangles wall;
    const auto cells = [&] { return 1 + int(random.uniform(0, 4)); };
    const BodyId ground =
        world.create_body({.type = BodyType::static_, .position = random.place({0, 0, 0}), .rotation = random.quat()});
    for (const float side : {1.0f, -1.0f}) {
        if (sheets == Sheets::rectangles || (sheets == Sheets::mesh_and_rectangle && side < 0)) {
            const Vec3 middle{0, 0.5f * side * thickness, 0};
            world.add_shape(ground, Plane{{0, side, 0}, {1, 0, 0}, glm::vec2{20, 20}}, {.position = middle});
            continue;
        }
        wall.add_grid({-20, -20}, {20, 20}, 0.5f * side * thickness, cells(), cells(), side > 0);
        if (sheets == Sheets::one_mesh && side > 0) continue;
        world.add_shape(ground, wall.mesh());
        wall = {};
    }
    std::vector<BodyId> bodies;
    for (const double side : {1.0, -1.0}) {
        BodyDef def;
        def.position = random.place({random.uniform(-0.8, 0.8), 0.6 * side, random.uniform(-0.8, 0.8)});
        def.linear_velocity = Vec3(random.turned({0, -side * random.uniform(0.1, 6), 0}));
        def.rotation = RandomStart(std::uint32_t(random.uniform(0, 1e6))).quat();
        def.angular_velocity = random_vector(random, 5);
        bodies.push_back(add_thrown(world, random, kind, def));
    }
    Held held;
    for (int i = 0; i < 180; ++i) {
        for (int k = 0; k < 2; ++k) {
            Body body = world.body(bodies[std::size_t(k)]);
            body.add_force(body.mass() * Vec3(random.turned({0, k == 0 ? -gravity : gravity, 0})));
        }
        world.step(1 / 60.0f);
        for (const BodyId body : bodies)
            held.fastest = std::max(held.fastest, double(glm::length(world.body(body).linear_velocity())));
    }
    for (int k = 0; k < 2; ++k) {
        const glm::dvec3 way = world.body(bodies[std::size_t(k)]).center_of_mass() - random.place({0, 0, 0});
        held.lost += (k == 0 ? 1 : -1) * glm::dot(way, random.turned({0, 1, 0})) < 0 ? 1 : 0;
    }
    return held;
}

// The greatest energy of a body that is thrown at a closed plate of triangles, relative to its initial energy.
double greatest_energy(RandomStart& random, int kind, float thickness) {
    World world(with_gravity({0, 0, 0}));
    const std::vector<std::uint32_t> triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                                  2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    BodyDef plate;
    plate.type = BodyType::static_;
    plate.position = random.place({0, 0, 0});
    plate.rotation = random.quat();
    add_body(world, Mesh(box_corners({0.5f, 0.5f * thickness, 0.4f}), triangles), plate, Material{});
    const Vec3 heading = glm::normalize(random_vector(random, 1));
    BodyDef def;
    def.position = random.place(random_vector(random, 0.6)) - 1.5 * glm::dvec3(heading);
    def.linear_velocity = float(std::exp(random.uniform(0, 3.2))) * heading;
    def.rotation = RandomStart(std::uint32_t(random.uniform(0, 1e6))).quat();
    def.angular_velocity = random_vector(random, 5);
    const BodyId body = add_thrown(world, random, kind, def);
    const double first = world.kinetic_energy();
    double greatest = first;
    for (int i = 0; i < 120; ++i) {
        world.step(1 / 60.0f);
        greatest = std::max(greatest, world.kinetic_energy());
    }
    EXPECT_TRUE(world.is_valid(body));
    return greatest / first;
}

// Eight adjacent rooms, each a surface of its own that faces inward, with 24 fast bodies inside. The number of bodies
// that are in another room after four seconds.
enum class Walls { one_mesh_a_room, rectangles, one_mesh };
int count_outside(RandomStart& random, Walls walls, float thickness, double speed) {
    World world(without_sleep());
    const BodyId building =
        world.create_body({.type = BodyType::static_, .position = random.place({0, 0, 0}), .rotation = random.quat()});
    const auto middle_of = [](int room) { return Vec3{room & 1 ? 1 : -1, room & 2 ? 1 : -1, room & 4 ? 1 : -1}; };
    const float half = 1 - 0.5f * thickness;
    Triangles all;
    for (int room = 0; room < 8; ++room) {
        ShapeDef def;
        if (walls == Walls::rectangles) {
            for (int side = 0; side < 6; ++side) {
                Vec3 normal{0, 0, 0};
                normal[side / 2] = side % 2 ? 1.0f : -1.0f;
                def.position = middle_of(room) - half * normal;
                const Vec3 tangent = side / 2 == 0 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
                world.add_shape(building, Plane{normal, tangent, glm::vec2{half, half}}, def);
            }
            continue;
        }
        const auto first = std::uint32_t(all.corners.size());
        for (const Vec3& corner : box_corners({half, half, half})) all.corners.push_back(middle_of(room) + corner);
        for (const std::uint32_t corner : {0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7, 0, 4, 1, 1, 4, 5,
                                           2, 3, 6, 3, 7, 6, 0, 2, 4, 2, 6, 4, 1, 5, 3, 3, 5, 7})
            all.indices.push_back(first + corner);
        if (walls == Walls::one_mesh) continue;
        world.add_shape(building, all.mesh(), def);
        all = {};
    }
    if (walls == Walls::one_mesh) world.add_shape(building, all.mesh());
    std::vector<BodyId> bodies;
    for (int i = 0; i < 24; ++i) {
        BodyDef def;
        def.position = random.place(middle_of(i % 8) +
                                    Vec3{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 0.5 * (i / 8 - 1)});
        def.linear_velocity = float(speed) * glm::normalize(random_vector(random, 1));
        def.rotation = RandomStart(std::uint32_t(random.uniform(0, 1e6))).quat();
        bodies.push_back(add_thrown(world, random, int(random.uniform(0, 4)), def));
    }
    for (int i = 0; i < 240; ++i) world.step(1 / 60.0f);
    int outside = 0;
    for (int i = 0; i < 24; ++i) {
        const glm::dvec3 way = world.body(bodies[std::size_t(i)]).position() - random.place({0, 0, 0});
        const glm::dvec3 off = glm::conjugate(random.rotation()) * way - glm::dvec3(middle_of(i % 8));
        outside += std::max({std::fabs(off.x), std::fabs(off.y), std::fabs(off.z)}) > 1 ? 1 : 0;
    }
    return outside;
}

// A body that is created deep in an edge or corner of a room of triangles: how far its center of mass is at most
// outside of the room after two seconds, m, and its greatest penetration, m.
struct Sunk {
    double outside, depth;
};
Sunk sink_into_corner(RandomStart& random, int kind, int walls) {
    World world(with_gravity({0, 0, 0}));
    Triangles room;
    room.corners = box_corners({1, 1, 1});
    room.indices = {0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7, 0, 4, 1, 1, 4, 5,
                    2, 3, 6, 3, 7, 6, 0, 2, 4, 2, 6, 4, 1, 5, 3, 3, 5, 7};
    BodyDef def;
    def.type = BodyType::static_;
    def.position = random.place({0, 0, 0});
    def.rotation = random.quat();
    add_body(world, room.mesh(), def, Material{});
    Vec3 from = random_vector(random, 0.5);
    for (int wall = 0; wall < walls; ++wall)
        from[wall] = (random.uniform(-1, 1) < 0 ? -1.0f : 1.0f) * float(1 - random.uniform(0.005, 0.15));
    def = {};
    def.position = random.place(from);
    def.rotation = RandomStart(std::uint32_t(random.uniform(0, 1e6))).quat();
    const BodyId body = add_thrown(world, random, kind, def);
    for (int i = 0; i < 120; ++i) world.step(1 / 60.0f);
    const glm::dvec3 off =
        glm::conjugate(random.rotation()) * (world.body(body).center_of_mass() - random.place({0, 0, 0}));
    Sunk sunk{std::max({std::fabs(off.x), std::fabs(off.y), std::fabs(off.z)}) - 1, 0};
    for (const Contact& c : world.contacts(body))
        for (int i = 0; i < c.point_count; ++i) sunk.depth = std::max(sunk.depth, -double(c.points[i].separation));
    return sunk;
}

} // namespace

TEST(MeshFloors, NothingBumpsWhereTilesOfAnyKindMeet) {
    for (int kind = 0; kind < tile_kinds; ++kind)
        for (int other = 0; other < tile_kinds; ++other)
            for (const bool rolls : {false, true})
                for (std::uint32_t seed = 0; seed < 6; ++seed) {
                    RandomStart random(seed * 101 + std::uint32_t(kind * tile_kinds + other));
                    const Bump bump = bump_on_tiles(random, kind, other, rolls);
                    EXPECT_LT(bump.up, 0.01) << kind << ' ' << other << ' ' << rolls << ' ' << seed;
                    EXPECT_LT(bump.turn, 0.003) << kind << ' ' << other << ' ' << rolls << ' ' << seed;
                }
}

// A box at rest penetrates its floor by some micrometers, but must not collide with the edge of the ramp from the side.
// Where it is within a hundredth of its size beyond that edge, box and ramp must not collide as two corners do.
TEST(MeshFloors, BoxesSlideOntoRampsOfAnyKind) {
    int caught = 0;
    for (int floor = 0; floor < 4; ++floor)
        for (int ramp = 0; ramp < 4; ++ramp)
            for (const double degrees : {0.5, 2.0, 10.0})
                for (std::uint32_t seed = 0; seed < 100; ++seed) {
                    RandomStart random(seed * 61 + std::uint32_t(floor * 4 + ramp));
                    const double angle = degrees * pi / 180, left = speed_on_ramp(random, floor, ramp, angle);
                    caught += std::fabs(left - std::cos(angle)) > 0.04;
                }
    std::printf("caught %d of 4800\n", caught);
    EXPECT_LE(caught, 1);
}

// Steps of up to 0.2 mm between triangles. A correct collision with such an edge deflects the body upward by some
// percent of its speed.
TEST(MeshFloors, WhatIsRoundSlidesOverCracks) {
    for (const bool is_ball : {false, true}) {
        double lost = 0;
        constexpr int count = 12;
        for (std::uint32_t seed = 0; seed < count; ++seed) {
            RandomStart random(seed + 77);
            World world(without_sleep());
            add_body(world, CrackedFloor(random, 1e-4f).mesh(), {.type = BodyType::static_}, surface(0, 0));
            const float radius = float(random.uniform(0.05, 0.3)), speed = float(random.uniform(1, 8));
            BodyDef def;
            def.position = {0, double(radius) + 1e-4, 0};
            def.linear_velocity = {speed, 0, speed * float(random.uniform(-0.15, 0.15))};
            const float turn = float(random.uniform(0, 3.1));
            def.rotation = glm::angleAxis(turn, Vec3{0, 1, 0}) * glm::angleAxis(float(0.5 * pi), Vec3{1, 0, 0});
            const BodyId body = is_ball ? add_body(world, Sphere{radius}, def, surface(0, 0))
                                        : add_body(world, Capsule{radius, radius, {}}, def, surface(0, 0));
            const double first = double(glm::length(def.linear_velocity));
            for (int i = 0; i < std::min(120, int(600 / speed)); ++i) world.step(1 / 60.0f);
            lost = std::max(lost, 1 - double(glm::length(world.body(body).linear_velocity())) / first);
        }
        EXPECT_LT(lost, 0.03) << is_ball;
    }
}

TEST(MeshWalls, HoldOnBothSidesHoweverThin) {
    for (const Sheets sheets : {Sheets::one_mesh, Sheets::two_meshes, Sheets::rectangles, Sheets::mesh_and_rectangle})
        for (const float thickness : {0.0f, 1e-6f, 1e-4f, 1e-3f, 1e-2f})
            for (int kind = 0; kind < thrown_kinds; ++kind)
                for (std::uint32_t seed = 0; seed < 3; ++seed) {
                    RandomStart random(seed * 31 + std::uint32_t(kind));
                    const Held held = press_on_wall(random, kind, sheets, thickness);
                    EXPECT_EQ(held.lost, 0) << int(sheets) << ' ' << thickness << ' ' << kind << ' ' << seed;
                    EXPECT_LT(held.fastest, 8) << int(sheets) << ' ' << thickness << ' ' << kind << ' ' << seed;
                }
}

TEST(MeshWalls, KeepWhatIsInARoomInIt) {
    for (const Walls walls : {Walls::one_mesh_a_room, Walls::rectangles, Walls::one_mesh})
        for (const float thickness : {0.0f, 1e-3f})
            for (const double speed : {2.0, 40.0}) {
                RandomStart random(std::uint32_t(speed) + 7);
                EXPECT_EQ(count_outside(random, walls, thickness, speed), 0)
                    << int(walls) << ' ' << thickness << ' ' << speed;
            }
}

TEST(MeshWalls, GiveNothingToWhatIsThrownAtThem) {
    for (const float thickness : {1e-4f, 1e-3f, 1e-2f, 0.1f})
        for (int kind = 0; kind < thrown_kinds; ++kind)
            for (std::uint32_t seed = 0; seed < 30; ++seed) {
                RandomStart random(seed * 53 + std::uint32_t(kind));
                EXPECT_LT(greatest_energy(random, kind, thickness), 1.02) << thickness << ' ' << kind << ' ' << seed;
            }
}

TEST(MeshWalls, PushWhatIsSunkIntoACornerBackIntoTheRoom) {
    for (const int walls : {2, 3})
        for (int kind = 0; kind < thrown_kinds; ++kind)
            for (std::uint32_t seed = 0; seed < 30; ++seed) {
                RandomStart random(seed * 71 + std::uint32_t(kind));
                const Sunk sunk = sink_into_corner(random, kind, walls);
                EXPECT_LT(sunk.outside, 0) << walls << ' ' << kind << ' ' << seed;
                EXPECT_LT(sunk.depth, 0.01) << walls << ' ' << kind << ' ' << seed;
            }
}

} // namespace cairn_test
