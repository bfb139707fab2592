#include "bench/shape_scenes.h"

#include "bench/mass.h"

#include <algorithm>

namespace cairn::bench {

namespace {

// Random vertices on a sphere with a minimum distance from each other, so that the polyhedron has no thin parts.
ConvexHull random_hull(Random& random, std::size_t corners, float radius) {
    constexpr float gap_lower_bound = 0.35f; // relative to the radius
    ConvexHull hull;
    while (hull.points.size() < corners) {
        const Vec3 point = random.direction();
        const auto is_near = [&](const Vec3& other) { return glm::length(point - other) < gap_lower_bound; };
        if (std::none_of(hull.points.begin(), hull.points.end(), is_near)) hull.points.push_back(point);
    }
    for (Vec3& point : hull.points) point *= radius;
    hull.triangles = hull_triangles(hull.points);
    const Vec3 center(mass_of(hull).center);
    for (Vec3& point : hull.points) point -= center;
    return hull;
}

// Value noise: random heights on a lattice with cells of `spacing`, interpolated smoothly.
class Noise {
  public:
    Noise(int cells, float spacing, float greatest, Random& random) : columns_(cells + 1), spacing_(spacing) {
        for (int i = 0; i < columns_ * columns_; ++i) heights_.push_back(random.between(-greatest, greatest));
    }
    // x and z are relative to the corner of the lattice.
    float operator()(float x, float z) const {
        const int column = cell_of(x), row = cell_of(z);
        const float u = smooth(x / spacing_ - static_cast<float>(column));
        const float v = smooth(z / spacing_ - static_cast<float>(row));
        const float low = mix(at(column, row), at(column + 1, row), u);
        const float high = mix(at(column, row + 1), at(column + 1, row + 1), u);
        return mix(low, high, v);
    }

  private:
    static float smooth(float t) { return t * t * (3 - 2 * t); }
    static float mix(float a, float b, float t) { return a + (b - a) * t; }
    int cell_of(float x) const { return std::clamp(static_cast<int>(x / spacing_), 0, columns_ - 2); }
    float at(int column, int row) const { return heights_[static_cast<std::size_t>(row * columns_ + column)]; }

    int columns_;
    float spacing_;
    std::vector<float> heights_;
};

constexpr int terrain_cells = 100;
constexpr float terrain_spacing = 0.5f, terrain_width = terrain_cells * terrain_spacing;

// Hills, with a rim that keeps rolling bodies on the terrain.
SurfaceMesh hills() {
    Random random(7);
    const Noise large(5, 10, 2.5f, random), small(20, 2.5f, 0.35f, random);
    SurfaceMesh mesh;
    mesh.columns = mesh.rows = terrain_cells + 1;
    mesh.spacing = terrain_spacing;
    constexpr float half = 0.5f * terrain_width, rim = 0.8f * half, slope = 1.2f;
    for (int row = 0; row < mesh.rows; ++row)
        for (int column = 0; column < mesh.columns; ++column) {
            const float x = static_cast<float>(column) * terrain_spacing, z = static_cast<float>(row) * terrain_spacing;
            const float outward = std::max(std::max(std::abs(x - half), std::abs(z - half)) - rim, 0.0f);
            mesh.vertices.emplace_back(x - half, large(x, z) + small(x, z) + slope * outward, z - half);
        }
    const auto columns = static_cast<std::uint32_t>(mesh.columns);
    for (std::uint32_t row = 0; row < terrain_cells; ++row)
        for (std::uint32_t column = 0; column < terrain_cells; ++column) {
            const std::uint32_t corner = row * columns + column;
            for (const std::uint32_t i :
                 {corner, corner + columns, corner + columns + 1, corner, corner + columns + 1, corner + 1})
                mesh.indices.push_back(i);
        }
    return mesh;
}

std::vector<Part> table(Random& random) {
    const float x = random.between(0.35f, 0.5f), z = random.between(0.25f, 0.35f), leg = random.between(0.2f, 0.3f);
    constexpr float thickness = 0.07f; // half thickness
    std::vector<Part> parts = {box_part({x, thickness, z})};
    for (const float side : {-1.0f, 1.0f})
        for (const float end : {-1.0f, 1.0f})
            parts.push_back(box_part({thickness, leg, thickness},
                                     {side * (x - thickness), -thickness - leg, end * (z - thickness)}));
    return parts;
}

// A chair: a table with a back.
std::vector<Part> chair(Random& random) {
    constexpr float seat = 0.28f, thickness = 0.07f, leg = 0.2f;
    const float back = random.between(0.2f, 0.3f);
    std::vector<Part> parts = {box_part({seat, thickness, seat}),
                               box_part({seat, back, thickness}, {0, thickness + back, thickness - seat})};
    for (const float side : {-1.0f, 1.0f})
        for (const float end : {-1.0f, 1.0f})
            parts.push_back(box_part({thickness, leg, thickness},
                                     {side * (seat - thickness), -thickness - leg, end * (seat - thickness)}));
    return parts;
}

// Three perpendicular bars, some with balls at their ends.
std::vector<Part> jack(Random& random) {
    constexpr float thickness = 0.08f, ball = 0.14f;
    const float reach = random.between(0.4f, 0.6f);
    std::vector<Part> parts;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 half_extents(thickness);
        half_extents[axis] = reach;
        parts.push_back(box_part(half_extents));
    }
    const int balls = static_cast<int>(random.below(5));
    for (int i = 0; i < balls; ++i) {
        Vec3 end(0.0f);
        end[i / 2] = i % 2 ? -reach : reach;
        parts.push_back(sphere_part(ball, end));
    }
    return parts;
}

} // namespace

void convex(Builder& b, int size) {
    constexpr std::uint32_t hulls = 20;
    Random random(77);
    for (std::uint32_t i = 0; i < hulls; ++i) {
        const std::size_t corners = 12 + random.below(13);
        b.scene.hulls.push_back(random_hull(random, corners, random.between(0.5f, 0.7f)));
    }
    b.pile(size, 8, 1.75f, 5, [&](Random& any, Vec3 position) {
        Part part;
        part.shape = PartShape::hull;
        part.index = any.below(hulls);
        b.body(Motion::dynamic, position, part, 1000, any.rotation());
    });
}

void terrain(Builder& b, int size) {
    b.scene.meshes.push_back(hills());
    Part ground;
    ground.shape = PartShape::mesh;
    b.body(Motion::fixed, {0, 0, 0}, ground);
    float lowest = 1e9f, highest = -1e9f;
    for (const Vec3& vertex : b.scene.meshes[0].vertices) {
        lowest = std::min(lowest, vertex.y);
        if (std::abs(vertex.x) < 0.4f * terrain_width && std::abs(vertex.z) < 0.4f * terrain_width)
            highest = std::max(highest, vertex.y);
    }
    constexpr float half = 0.5f * terrain_width;
    b.scene.lower_bound = {-half, lowest - 0.5f, -half};
    b.scene.upper_bound = {half, 1e9f, half};
    constexpr float spacing = 1.6f;
    constexpr int max_across = 25; // 40 m
    const int across = std::min(static_cast<int>(std::ceil(std::sqrt(size / 4.0))), max_across);
    Random random(6);
    for (int i = 0; i < size; ++i) {
        const int x = i % across, z = i / across % across, y = i / (across * across);
        const float middle = 0.5f * static_cast<float>(across - 1);
        const Vec3 position((static_cast<float>(x) - middle) * spacing,
                            highest + 1.0f + static_cast<float>(y) * spacing,
                            (static_cast<float>(z) - middle) * spacing);
        const float a = random.between(0.2f, 0.45f), c = random.between(0.2f, 0.45f), d = random.between(0.2f, 0.45f);
        b.box(Motion::dynamic, position, {a, c, d}, 1000, random.rotation());
    }
}

void props(Builder& b, int size) {
    b.pile(size, 10, 1.85f, 8, [&](Random& random, Vec3 position) {
        const std::uint32_t kind = random.below(3);
        const std::vector<Part> parts = kind == 0 ? table(random) : kind == 1 ? chair(random) : jack(random);
        b.body(Motion::dynamic, position, parts, 600, random.rotation());
    });
}

void capsules(Builder& b, int size) {
    b.pile(size, 14, 1.8f, 9, [&](Random& random, Vec3 position) {
        Part part;
        part.shape = random.next() & 1024 ? PartShape::capsule : PartShape::cylinder;
        part.radius = random.between(0.15f, 0.35f);
        part.half_height = random.between(0.15f, 0.5f);
        b.body(Motion::dynamic, position, part, 1000, random.rotation());
    });
}

} // namespace cairn::bench
