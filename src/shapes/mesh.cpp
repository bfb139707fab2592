// Builds a mesh: merges equal vertices, drops triangles without area, sorts the others in kd-tree order below an
// implicit tree of boxes, and finds the triangle across each edge.
#include "shapes/mesh.h"

#include "shapes/refuse.h"
#include "shapes/surface_materials.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cairn {

using math::DVec3;

namespace {

using Corners = std::array<std::uint32_t, 3>;

struct Extent {
    math::Vec3 lo, hi;
};

constexpr float farthest = 1e6f;                                // greatest absolute coordinate of a vertex, m
constexpr std::size_t max_indices = 3 * (std::size_t(1) << 28); // such that three times a triangle's index fits 32 bits

// The least height of a triangle over its longest side, relative to that side. Below it, the triangle could result from
// rounding its corners to float, and its normal would be meaningless.
constexpr double min_height = 1.0 / (1 << 22);

void check(std::span<const math::Vec3> vertices, std::span<const std::uint32_t> indices) {
    if (vertices.size() > max_indices)
        refuse("Mesh vertices", std::to_string(vertices.size()), "must be at most 3 x 2^28");
    if (indices.size() > max_indices)
        refuse("Mesh indices", std::to_string(indices.size()), "must be at most 3 x 2^28");
    if (indices.size() % 3 != 0)
        refuse("Mesh indices", std::to_string(indices.size()), "their number must be a multiple of three");
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::fabs(vertices[i][axis]) <= farthest))
                refuse("Mesh vertices[" + std::to_string(i) + "]", number_text(vertices[i]),
                       "must be finite and within 1e6 m");
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (indices[i] >= vertices.size())
            refuse("Mesh indices[" + std::to_string(i) + "]", std::to_string(indices[i]),
                   "must be less than the number of vertices, " + std::to_string(vertices.size()));
}

// For each vertex, the first vertex at the same position.
std::vector<std::uint32_t> weld(std::span<const math::Vec3> vertices) {
    struct Item {
        math::Vec3 at;
        std::uint32_t index;
    };
    std::vector<Item> items(vertices.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) items[i] = {vertices[i], i};
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
        for (int axis = 0; axis < 3; ++axis)
            if (a.at[axis] != b.at[axis]) return a.at[axis] < b.at[axis];
        return a.index < b.index;
    });
    std::vector<std::uint32_t> first(vertices.size());
    for (std::size_t i = 0; i < items.size(); ++i)
        first[items[i].index] = i > 0 && items[i - 1].at == items[i].at ? first[items[i - 1].index] : items[i].index;
    return first;
}

bool has_area(math::Vec3 a, math::Vec3 b, math::Vec3 c) {
    const DVec3 p = math::to_double(a), q = math::to_double(b), r = math::to_double(c);
    const DVec3 u = q - p, v = r - p, w = r - q;
    const double longest = std::max({math::dot(u, u), math::dot(v, v), math::dot(w, w)});
    return math::length(math::cross(u, v)) > min_height * longest;
}

Extent bounds_of(math::Vec3 a, math::Vec3 b, math::Vec3 c) {
    return {math::min(math::min(a, b), c), math::max(math::max(a, b), c)};
}

// Median splits whose lower halves have 8 x 2^k triangles, so that 8 consecutive triangles form a leaf, and 8 leaves a
// node.
struct Item {
    math::Vec3 center; // times two
    std::uint32_t index;
};

void put_in_kd_order(Item* items, std::size_t count) {
    if (count <= 8) {
        std::sort(items, items + count, [](const Item& a, const Item& b) { return a.index < b.index; });
        return;
    }
    math::Vec3 low = items[0].center, high = low;
    for (std::size_t i = 1; i < count; ++i)
        low = math::min(low, items[i].center), high = math::max(high, items[i].center);
    const math::Vec3 extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    std::size_t middle = 8;
    while (middle * 2 < count) middle *= 2;
    auto select = [&](auto coordinate) {
        std::nth_element(items, items + middle, items + count, [&](const Item& a, const Item& b) {
            return coordinate(a) < coordinate(b) || (coordinate(a) == coordinate(b) && a.index < b.index);
        });
    };
    if (axis == 0) select([](const Item& i) { return i.center.x; });
    if (axis == 1) select([](const Item& i) { return i.center.y; });
    if (axis == 2) select([](const Item& i) { return i.center.z; });
    put_in_kd_order(items, middle);
    put_in_kd_order(items + middle, count - middle);
}

// Stores the triangles, and their material indices if there are any, in kd-tree order. Vertices are numbered in the
// order of first use, so that neighbors in space are neighbors in memory.
void store_in_order(MeshData& mesh, std::span<const math::Vec3> vertices, std::span<const Corners> triangles,
                    std::span<const std::uint16_t> numbers) {
    std::vector<Item> items(triangles.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        const Corners& t = triangles[i];
        const Extent box = bounds_of(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
        items[i] = {box.lo + box.hi, i};
    }
    put_in_kd_order(items.data(), items.size());
    std::vector<std::uint32_t> number(vertices.size(), no_triangle);
    mesh.indices.reserve(3 * items.size());
    if (!numbers.empty()) mesh.materials.numbers.reserve(items.size());
    for (const Item& item : items) {
        if (!numbers.empty()) mesh.materials.numbers.push_back(numbers[item.index]);
        for (const std::uint32_t corner : triangles[item.index]) {
            if (number[corner] == no_triangle) {
                number[corner] = std::uint32_t(mesh.vertices.size());
                mesh.vertices.push_back(vertices[corner] + math::Vec3{0, 0, 0}); // turns -0 into +0
            }
            mesh.indices.push_back(number[corner]);
        }
    }
    mesh.vertices.shrink_to_fit();
}

void build_levels(MeshData& mesh) {
    std::vector<Extent> boxes(triangle_count(mesh));
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const Triangle t = triangle_of(mesh, i);
        boxes[i] = bounds_of(t.a, t.b, t.c);
    }
    do {
        std::vector<Extent> parents((boxes.size() + 7) / 8);
        std::vector<BoxBlock> blocks(parents.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            Extent& parent = parents[i / 8];
            parent =
                i % 8 == 0 ? boxes[i] : Extent{math::min(parent.lo, boxes[i].lo), math::max(parent.hi, boxes[i].hi)};
            blocks[i / 8].set(i % 8, boxes[i].lo, boxes[i].hi);
        }
        mesh.levels.push_back(std::move(blocks));
        boxes.swap(parents);
    } while (boxes.size() > 1);
    mesh.lo = boxes[0].lo;
    mesh.hi = boxes[0].hi;
    double square = 0;
    for (const math::Vec3& v : mesh.vertices)
        square = std::max(square, math::dot(math::to_double(v), math::to_double(v)));
    mesh.bounding_radius = float(std::sqrt(square) * (1 + 1e-7)); // rounded up
}

// Finds the triangle across each edge. Edges are sorted into buckets by their lower vertex, and within a bucket by the
// other vertex.
void find_neighbors(MeshData& mesh) {
    struct Edge {
        std::uint32_t other, place; // place: 3 x triangle + edge
        bool is_upward;             // whether it runs from the lower vertex to the other
    };
    const std::size_t count = mesh.indices.size();
    auto ends = [&](std::size_t place) {
        const std::size_t next = place % 3 == 2 ? place - 2 : place + 1;
        return std::pair(mesh.indices[place], mesh.indices[next]);
    };
    std::vector<std::uint32_t> start(mesh.vertices.size() + 1);
    for (std::size_t place = 0; place < count; ++place) {
        const auto [a, b] = ends(place);
        ++start[std::min(a, b) + 1];
    }
    for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
    std::vector<Edge> edges(count);
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (std::size_t place = 0; place < count; ++place) {
        const auto [a, b] = ends(place);
        edges[fill[std::min(a, b)]++] = {std::max(a, b), std::uint32_t(place), a < b};
    }
    mesh.neighbors.assign(count, no_triangle);
    for (std::size_t v = 0; v + 1 < start.size(); ++v) {
        Edge *bucket = edges.data() + start[v], *end = edges.data() + start[v + 1];
        std::sort(bucket, end, [](const Edge& a, const Edge& b) {
            return a.other < b.other || (a.other == b.other && a.place < b.place);
        });
        while (bucket != end) {
            Edge* next = bucket;
            while (next != end && next->other == bucket->other) ++next;
            if (next - bucket == 2 && bucket[0].is_upward != bucket[1].is_upward) {
                mesh.neighbors[bucket[0].place] = bucket[1].place / 3;
                mesh.neighbors[bucket[1].place] = bucket[0].place / 3;
            }
            bucket = next;
        }
    }
}

} // namespace

MeshData build_mesh(std::span<const math::Vec3> vertices, std::span<const std::uint32_t> indices,
                    const SurfaceMaterials& materials) {
    check(vertices, indices);
    check_materials("Mesh", materials, indices.size() / 3);
    const std::vector<std::uint32_t> first = weld(vertices);
    std::vector<Corners> triangles;
    std::vector<std::uint16_t> numbers;
    triangles.reserve(indices.size() / 3);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const Corners t = {first[indices[i]], first[indices[i + 1]], first[indices[i + 2]]};
        if (!has_area(vertices[t[0]], vertices[t[1]], vertices[t[2]])) continue;
        triangles.push_back(t);
        if (!materials.numbers.empty()) numbers.push_back(materials.numbers[i / 3]);
    }
    if (triangles.empty())
        refuse("Mesh indices", std::to_string(indices.size()), "must name at least one triangle that has an area");
    MeshData mesh;
    mesh.dropped = indices.size() / 3 - triangles.size();
    mesh.materials.materials = materials.materials;
    store_in_order(mesh, vertices, triangles, numbers);
    build_levels(mesh);
    find_neighbors(mesh);
    return mesh;
}

} // namespace cairn
