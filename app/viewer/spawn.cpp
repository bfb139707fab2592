#include "viewer/spawn.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cairn::viewer {

namespace {

using Kind = SpawnSettings::Kind;

constexpr int max_tries = 256;
constexpr std::size_t max_hulls = 64; // cached for later bodies of the same kind and size
constexpr float polyhedron_radius = 0.65f;
constexpr float golden = 1.6180340f;

// Adds all sign combinations of (0, a, b) and their cyclic permutations.
void add_rectangles(std::vector<Vec3>& points, float a, float b) {
    for (const float s : {-1.0f, 1.0f})
        for (const float t : {-1.0f, 1.0f})
            points.insert(points.end(), {{0.0f, s * a, t * b}, {s * a, t * b, 0.0f}, {t * b, 0.0f, s * a}});
}

// Evenly distributed points of a sphere (a Fibonacci lattice), each moved inward by a different amount.
std::vector<Vec3> rock_points() {
    constexpr int count = 18;
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const float height = 1.0f - (2.0f * float(i) + 1.0f) / float(count), around = 2.3999632f * float(i);
        const float ring = std::sqrt(1.0f - height * height);
        const float bump = 0.72f + 0.28f * std::abs(std::sin(float(i * i) * 1.7f));
        points.push_back(Vec3(ring * std::cos(around), 0.8f * height, 0.9f * ring * std::sin(around)) * bump);
    }
    return points;
}

// Corners scaled so that the farthest one is at distance 1 from the origin.
std::vector<Vec3> corners_of(Kind kind) {
    std::vector<Vec3> points;
    switch (kind) {
    case Kind::tetrahedron:
        points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
        break;
    case Kind::octahedron:
        points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        break;
    case Kind::dodecahedron:
        for (int i = 0; i < 8; ++i)
            points.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
        add_rectangles(points, 1.0f / golden, golden);
        break;
    case Kind::icosahedron:
        add_rectangles(points, 1.0f, golden);
        break;
    default:
        points = rock_points();
        break;
    }
    float farthest = 0.0f;
    for (const Vec3& point : points) farthest = std::max(farthest, glm::length(point));
    for (Vec3& point : points) point /= farthest;
    return points;
}

} // namespace

const char* name_of(Kind kind) {
    constexpr const char* names[spawn_kind_count] = {"box",         "sphere",      "capsule",    "cylinder",
                                                     "cone",        "tetrahedron", "octahedron", "dodecahedron",
                                                     "icosahedron", "rock"};
    return names[int(kind)];
}

SpawnSettings box_preset() { return {}; }

SpawnSettings large_sphere_preset() {
    SpawnSettings settings;
    settings.kind = Kind::sphere;
    settings.size = 1.0f;
    return settings;
}

SpawnSettings small_sphere_preset() {
    SpawnSettings settings = large_sphere_preset();
    settings.size = 0.4f;
    return settings;
}

SpawnSettings preset_of(Kind kind) {
    SpawnSettings settings;
    settings.kind = kind;
    if (kind == Kind::capsule) settings.size = 0.9f;
    return settings;
}

// The displacement after time t is v t + g t^2 / 2. For a given |v| this is a quadratic equation in t^2; the least
// speed is the one at which its two solutions coincide.
Vec3 velocity_to_reach(const Vec3& way, float speed, const Vec3& gravity) {
    const glm::dvec3 w(way), g(gravity);
    const double distance = glm::length(w), pull = glm::length(g);
    const double square = std::max(double(speed) * double(speed), pull * distance - glm::dot(w, g));
    const double middle = square + glm::dot(w, g);
    const double root = std::sqrt(std::max(middle * middle - pull * pull * distance * distance, 0.0));
    if (middle + root <= 0.0) return Vec3(0.0f); // zero speed without gravity, or zero displacement
    const double time = std::sqrt(2.0 * distance * distance / (middle + root));
    return Vec3(w / time - 0.5 * time * g);
}

const Hull& Spawner::hull_of(Kind kind, float size) {
    if (!(size > 0.0f))
        throw Error(ErrorCode::invalid_value, "SpawnSettings.size", std::to_string(size), "must be > 0");
    const auto found = hulls_.find({kind, size});
    if (found != hulls_.end()) return found->second;
    std::vector<Vec3> points = corners_of(kind);
    for (Vec3& point : points) point *= polyhedron_radius * size;
    if (hulls_.size() >= max_hulls) hulls_.clear();
    return hulls_.emplace(std::pair(kind, size), Hull(points)).first->second;
}

Shape Spawner::shape_of(const SpawnSettings& settings) {
    const float half = 0.5f * settings.size;
    switch (settings.kind) {
    case Kind::box:
        return Box{Vec3(half)};
    case Kind::sphere:
        return Sphere{half};
    case Kind::capsule:
        return Capsule{0.5f * half, 0.5f * half, {}};
    case Kind::cylinder:
        return Cylinder{half, half, {}};
    case Kind::cone:
        return cone(half, half);
    default:
        return hull_of(settings.kind, settings.size);
    }
}

BodyId Spawner::spawn(World& world, const SpawnSettings& settings, const Position& position, const Vec3& velocity) {
    const Shape shape = shape_of(settings);
    BodyDef def;
    def.position = position;
    def.linear_velocity = velocity;
    ShapeDef shape_def;
    shape_def.density = settings.density;
    shape_def.material.static_friction = shape_def.material.dynamic_friction = settings.friction;
    shape_def.material.restitution = settings.restitution;
    const BodyId body = world.create_body(def);
    try {
        world.add_shape(body, shape, shape_def);
    } catch (const Error&) {
        world.destroy_body(body);
        throw;
    }
    return body;
}

Position Spawner::free_place(const World& world, const SpawnSettings& settings, const Position& wanted) {
    const Shape shape = shape_of(settings);
    Position place = wanted;
    for (int i = 0; i < max_tries; ++i) {
        if (world.overlap(shape, Transform{place, Quat(1.0f, 0.0f, 0.0f, 0.0f)}).empty()) return place;
        place.y += 0.5 * double(settings.size);
    }
    return place;
}

} // namespace cairn::viewer
