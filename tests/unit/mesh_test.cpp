// Meshes and height fields: building, searching and rejecting them.
#include "mesh_test_support.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <string>

namespace cairn {

namespace {

using math::DVec3;
using test::Random;
using test::Soup;

MeshData build(const Soup& soup) { return build_mesh(soup.vertices, soup.indices); }

using Key = std::array<float, 9>;

// A triangle's vertices, rotated so that the least is first: the key does not depend on the start vertex.
Key key_of(const Triangle& t) {
    const math::Vec3 corners[3] = {t.a, t.b, t.c};
    Key best{};
    for (int first = 0; first < 3; ++first) {
        Key key;
        for (int i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis) key[std::size_t(3 * i + axis)] = corners[(first + i) % 3][axis] + 0.0f;
        if (first == 0 || key < best) best = key;
    }
    return best;
}

bool has_area(const Triangle& t) {
    const DVec3 a = math::to_double(t.a);
    return math::length(math::cross(math::to_double(t.b) - a, math::to_double(t.c) - a)) > 0;
}

template <class F> void expect_refused(F&& make, const std::string& field, const std::string& value) {
    try {
        make();
        FAIL() << "was not refused";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::invalid_value);
        EXPECT_EQ(e.field(), field);
        EXPECT_EQ(e.value(), value);
    }
}

TEST(MeshBuild, KeepsEachTriangleWithAreaAndItsWinding) {
    Random random(1);
    for (const std::size_t count : {1u, 7u, 8u, 9u, 64u, 65u, 1000u}) {
        const Soup soup = test::random_soup(random, count, 5);
        std::vector<Key> expected, got;
        for (std::size_t i = 0; i < soup.indices.size(); i += 3) {
            const Triangle t{soup.vertices[soup.indices[i]], soup.vertices[soup.indices[i + 1]],
                             soup.vertices[soup.indices[i + 2]]};
            if (has_area(t)) expected.push_back(key_of(t));
        }
        const MeshData mesh = build(soup);
        for (std::uint32_t i = 0; i < triangle_count(mesh); ++i) got.push_back(key_of(triangle_of(mesh, i)));
        std::sort(expected.begin(), expected.end());
        std::sort(got.begin(), got.end());
        EXPECT_EQ(got, expected);
        EXPECT_EQ(mesh.dropped, count - expected.size());
    }
}

TEST(MeshBuild, TakesCornersAtTheSamePlaceForOne) {
    // Two triangles of one square that share no index; one vertex is at -0 and +0.
    const std::vector<math::Vec3> vertices = {{-0.0f, 0, 0}, {0, 0, 1}, {1, 0, 1}, {0, -0.0f, 0}, {1, 0, 1}, {1, 0, 0}};
    const MeshData mesh = build_mesh(vertices, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
    EXPECT_EQ(mesh.vertices.size(), 4u);
    for (const math::Vec3& v : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(std::signbit(v[axis]));
    EXPECT_EQ(neighbor_of(mesh, 0, 2), 1u);
    EXPECT_EQ(neighbor_of(mesh, 1, 0), 0u);
}

TEST(MeshBuild, LeavesOutVerticesThatNoTriangleHas) {
    const std::vector<math::Vec3> vertices = {{100, 0, 0}, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const MeshData mesh = build_mesh(vertices, std::vector<std::uint32_t>{1, 2, 3});
    EXPECT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.hi.x, 1);
    EXPECT_NEAR(mesh.bounding_radius, 1, 3e-7);
    EXPECT_GE(mesh.bounding_radius, 1);
}

TEST(MeshBuild, CountsTrianglesWithoutArea) {
    const std::vector<math::Vec3> vertices = {{0, 0, 0},          {0, 0, 1},          {1, 0, 0}, {0.1f, 0.1f, 0.1f},
                                              {0.2f, 0.2f, 0.2f}, {0.3f, 0.3f, 0.3f}, {0, 0, 1}};
    const std::vector<std::uint32_t> indices = {0, 0, 1,  // a repeated vertex
                                                3, 4, 5,  // collinear, up to rounding
                                                0, 1, 6,  // two vertices at the same position
                                                0, 1, 2}; // a valid one
    const MeshData mesh = build_mesh(vertices, indices);
    EXPECT_EQ(mesh.dropped, 3u);
    EXPECT_EQ(triangle_count(mesh), 1u);
}

TEST(MeshBuild, KeepsSmallAndSlenderTriangles) {
    const std::vector<math::Vec3> vertices = {{0, 0, 0}, {0, 0, 1e-20f}, {1e-20f, 0, 0}, {1e6f, 0, 0}, {0, 1, 0}};
    const MeshData mesh = build_mesh(vertices, std::vector<std::uint32_t>{0, 1, 2, 0, 3, 4});
    EXPECT_EQ(mesh.dropped, 0u);
}

TEST(MeshBuild, PutsBoxesOverAllThatIsBelowThem) {
    Random random(2);
    for (const std::size_t count : {1u, 8u, 9u, 65u, 512u, 513u, 3000u}) {
        const MeshData mesh = build(test::random_soup(random, count, 5));
        struct Box {
            math::Vec3 lo, hi;
        };
        std::vector<Box> boxes;
        for (std::uint32_t i = 0; i < triangle_count(mesh); ++i) {
            const Triangle t = triangle_of(mesh, i);
            boxes.push_back({math::min(math::min(t.a, t.b), t.c), math::max(math::max(t.a, t.b), t.c)});
        }
        for (const auto& level : mesh.levels) {
            ASSERT_EQ(level.size(), (boxes.size() + 7) / 8);
            std::vector<Box> above(level.size());
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                ASSERT_TRUE(level[i / 8].lo_of(i % 8) == boxes[i].lo && level[i / 8].hi_of(i % 8) == boxes[i].hi);
                Box& box = above[i / 8];
                box = i % 8 == 0 ? boxes[i] : Box{math::min(box.lo, boxes[i].lo), math::max(box.hi, boxes[i].hi)};
            }
            for (std::size_t i = boxes.size(); i < 8 * level.size(); ++i)
                ASSERT_EQ(level[i / 8].meets({-1e6f, -1e6f, -1e6f}, {1e6f, 1e6f, 1e6f}) >> (i % 8) & 1, 0u);
            boxes = above;
        }
        ASSERT_EQ(boxes.size(), 1u);
        EXPECT_TRUE(boxes[0].lo == mesh.lo && boxes[0].hi == mesh.hi);
    }
}

// The leaves of the tree are compact patches, far smaller than the surface, although the triangles are in random order.
TEST(MeshBuild, PutsTrianglesNearEachOtherInOneLeaf) {
    Random random(3);
    Soup soup = test::ball_soup(100, 100, 1);
    for (std::size_t i = soup.indices.size() / 3 - 1; i > 0; --i) {
        const std::size_t other = random.below(i + 1);
        for (std::size_t k = 0; k < 3; ++k) std::swap(soup.indices[3 * i + k], soup.indices[3 * other + k]);
    }
    const MeshData mesh = build(soup);
    EXPECT_EQ(triangle_count(mesh), 19800u);
    double sum = 0;
    for (std::size_t leaf = 0; leaf < mesh.levels[0].size(); ++leaf) {
        const BoxBlock& leaves = mesh.levels[1][leaf / 8];
        sum += double(math::length(leaves.hi_of(leaf % 8) - leaves.lo_of(leaf % 8)));
    }
    EXPECT_LT(sum / double(mesh.levels[0].size()), 0.15);
}

TEST(MeshBuild, OfWhatItBuiltIsTheSameAgain) {
    Random random(4);
    for (const Soup& soup : {test::random_soup(random, 2000, 5), test::ball_soup(30, 30, 2)}) {
        const MeshData once = build(soup), twice = build_mesh(once.vertices, once.indices);
        EXPECT_EQ(once.indices, twice.indices);
        EXPECT_EQ(once.neighbors, twice.neighbors);
        ASSERT_EQ(once.vertices.size(), twice.vertices.size());
        for (std::size_t i = 0; i < once.vertices.size(); ++i) ASSERT_TRUE(once.vertices[i] == twice.vertices[i]);
        EXPECT_EQ(twice.dropped, 0u);
    }
}

// Neighbors by brute force over all pairs of directed edges.
std::vector<std::uint32_t> neighbors_by_search(const MeshData& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges; // directed
    auto end = [&](std::uint32_t t, std::uint32_t e) { return mesh.indices[3 * t + e % 3]; };
    for (std::uint32_t t = 0; t < triangle_count(mesh); ++t)
        for (std::uint32_t e = 0; e < 3; ++e) edges[{end(t, e), end(t, e + 1)}].push_back(t);
    std::vector<std::uint32_t> found;
    for (std::uint32_t t = 0; t < triangle_count(mesh); ++t)
        for (std::uint32_t e = 0; e < 3; ++e) {
            const auto& same = edges[{end(t, e), end(t, e + 1)}];
            const auto& opposite = edges[{end(t, e + 1), end(t, e)}];
            found.push_back(same.size() == 1 && opposite.size() == 1 ? opposite[0] : no_triangle);
        }
    return found;
}

TEST(MeshNeighbors, AreThoseThatShareAnEdgeTheOtherWayRound) {
    Random random(5);
    const MeshData ball = build(test::ball_soup(20, 30, 2));
    EXPECT_EQ(ball.neighbors, neighbors_by_search(ball));
    EXPECT_EQ(std::count(ball.neighbors.begin(), ball.neighbors.end(), no_triangle), 0);
    // Few vertices and many triangles: edges with one, two and more triangles.
    Soup soup;
    for (int i = 0; i < 30; ++i) soup.vertices.push_back(math::to_float(random.point(1)));
    for (int i = 0; i < 3 * 200; ++i) soup.indices.push_back(std::uint32_t(random.below(30)));
    const MeshData mesh = build(soup);
    EXPECT_EQ(mesh.neighbors, neighbors_by_search(mesh));
    EXPECT_LT(std::count(mesh.neighbors.begin(), mesh.neighbors.end(), no_triangle),
              std::ptrdiff_t(mesh.indices.size()));
}

TEST(MeshRefusal, NamesWhatIsWrong) {
    using Vertices = std::vector<math::Vec3>;
    using Indices = std::vector<std::uint32_t>;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Vertices good = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    expect_refused([&] { build_mesh(good, Indices{0, 1}); }, "Mesh indices", "2");
    expect_refused([&] { build_mesh(good, Indices{0, 1, 2, 0, 3, 1}); }, "Mesh indices[4]", "3");
    expect_refused([&] { build_mesh(Vertices{{0, 0, 0}, {0, nan, 1}}, Indices{}); }, "Mesh vertices[1]", "(0, nan, 1)");
    expect_refused([&] { build_mesh(Vertices{{0, 0, 1.5e6f}}, Indices{}); }, "Mesh vertices[0]", "(0, 0, 1.5e+06)");
    expect_refused([&] { build_mesh(good, Indices{}); }, "Mesh indices", "0");
    expect_refused([&] { build_mesh(good, Indices{0, 1, 1}); }, "Mesh indices", "3");
    EXPECT_NO_THROW(build_mesh(Vertices{{0, 0, 0}, {0, 0, 1e6f}, {-1e6f, 0, 0}}, Indices{0, 1, 2}));
}

TEST(MeshShape, GivesBackWhatItHolds) {
    const std::vector<Vec3> vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const Mesh mesh(vertices, std::vector<std::uint32_t>{0, 1, 2, 2, 2, 1});
    ASSERT_EQ(mesh.vertices().size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(mesh.vertices()[i], vertices[i]);
    EXPECT_EQ(std::vector<std::uint32_t>(mesh.indices().begin(), mesh.indices().end()),
              (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(mesh.dropped_triangles(), 1u);
    EXPECT_EQ(Mesh(mesh).data(), mesh.data());
}

template <class Data>
void expect_all_found(const Data& data, math::Vec3 lo, math::Vec3 hi, std::size_t* most = nullptr) {
    std::vector<std::uint32_t> expected, got;
    for (std::uint32_t i = 0; i < triangle_count(data); ++i) {
        const Triangle t = triangle_of(data, i);
        const math::Vec3 least = math::min(math::min(t.a, t.b), t.c), greatest = math::max(math::max(t.a, t.b), t.c);
        bool meets = true;
        for (int axis = 0; axis < 3; ++axis) meets = meets && least[axis] <= hi[axis] && greatest[axis] >= lo[axis];
        if (meets) expected.push_back(i);
    }
    for_each_triangle(data, lo, hi, [&](std::uint32_t i) { got.push_back(i); });
    ASSERT_EQ(got, expected);
    if (most) *most = std::max(*most, got.size());
}

TEST(TriangleSearch, FindsAllOfAMeshThatMeetABoxInOrder) {
    Random random(6);
    for (const std::size_t count : {1u, 8u, 9u, 64u, 65u, 700u, 4096u}) {
        const MeshData mesh = build(test::random_soup(random, count, 5));
        std::size_t most = 0;
        for (int round = 0; round < 200; ++round) {
            const DVec3 center = random.point(6), half = scaled(random.point(3), random.point(1));
            const math::Vec3 size = math::abs(math::to_float(half));
            expect_all_found(mesh, math::to_float(center) - size, math::to_float(center) + size, &most);
        }
        EXPECT_GE(most, count / 64);
        expect_all_found(mesh, mesh.lo, mesh.hi);
    }
}

TEST(TriangleSearch, FindsAllOfAHeightFieldThatMeetABoxInOrder) {
    Random random(7);
    const float inf = std::numeric_limits<float>::infinity();
    for (const auto& [columns, rows, x, z] : {std::tuple(2, 2, 1.0f, 1.0f), std::tuple(20, 9, 0.3f, 1.7f),
                                              std::tuple(2, 50, 0.1f, 0.1f), std::tuple(33, 32, 1e-3f, 100.0f)}) {
        const HeightFieldData field = test::random_field(random, columns, rows, x, z);
        const DVec3 reach{0.6 * columns * double(x), 1.2, 0.6 * rows * double(z)};
        std::size_t most = 0;
        for (int round = 0; round < 300; ++round) {
            const math::Vec3 center = math::to_float(scaled(reach, random.point(1)));
            const math::Vec3 size = math::abs(math::to_float(scaled(reach, random.point(0.5))));
            expect_all_found(field, center - size, center + size, &most);
            // Sides in the planes of grid lines, where touching counts as overlap.
            const float line_x = grid_line(columns, x, int(random.below(std::size_t(columns))));
            const float line_z = grid_line(rows, z, int(random.below(std::size_t(rows))));
            expect_all_found(field, {line_x, -inf, line_z}, {line_x, inf, line_z}, &most);
            expect_all_found(field, {-inf, center.y, line_z}, {line_x, inf, inf}, &most);
        }
        EXPECT_GT(most, 1u);
    }
}

// Far from the middle the spacing of floats exceeds the width of a cell: the search must still find all triangles.
TEST(TriangleSearch, FindsAllOfAHeightFieldWhoseLinesFloatCannotTellApart) {
    Random random(8);
    const HeightFieldData field = test::random_field(random, 3000, 2, 1e-5f + 1e-12f, 1.0f);
    for (int round = 0; round < 300; ++round) {
        const float at = grid_line(3000, field.spacing_x, int(random.below(3000)));
        expect_all_found(field, {at, -2, -2}, {at, 2, 2});
        expect_all_found(field, {std::nextafter(at, -1.0f), -2, -2}, {std::nextafter(at, -1.0f), 2, 2});
    }
}

TEST(HeightFieldTriangles, FaceUpAndStandWhereTheGridSays) {
    std::vector<float> heights(4 * 3);
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = float(i);
    const HeightFieldData field = build_height_field(4, 3, 2.0f, 0.5f, heights);
    ASSERT_EQ(triangle_count(field), 12u);
    for (std::uint32_t i = 0; i < 12; ++i) {
        const Triangle t = triangle_of(field, i);
        EXPECT_GT(math::cross(t.b - t.a, t.c - t.a).y, 0);
        for (const math::Vec3 v : {t.a, t.b, t.c}) {
            const float column = v.x / 2 + 1.5f, row = v.z / 0.5f + 1;
            EXPECT_EQ(v.y, row * 4 + column);
        }
        // Each cell is divided by the diagonal from its corner of least x and z to the opposite one.
        const bool second = i % 2 == 1;
        const math::Vec3 far = second ? t.b : t.c;
        EXPECT_EQ(far.x, t.a.x + 2);
        EXPECT_EQ(far.z, t.a.z + 0.5f);
    }
}

TEST(HeightFieldTriangles, HaveAcrossAnEdgeTheOneThatHasItToo) {
    Random random(9);
    for (const auto& [columns, rows] : {std::pair(2, 2), std::pair(2, 5), std::pair(5, 2), std::pair(6, 7)}) {
        const HeightFieldData field = test::random_field(random, columns, rows, 1, 2);
        // The same triangles as a mesh, which searches its neighbors itself.
        using Edge = std::array<float, 6>;
        std::map<Edge, std::uint32_t> owner;
        auto edge_of = [](math::Vec3 a, math::Vec3 b) { return Edge{a.x, a.y, a.z, b.x, b.y, b.z}; };
        for (std::uint32_t i = 0; i < triangle_count(field); ++i) {
            const Triangle t = triangle_of(field, i);
            owner[edge_of(t.a, t.b)] = owner[edge_of(t.b, t.c)] = owner[edge_of(t.c, t.a)] = i;
        }
        for (std::uint32_t i = 0; i < triangle_count(field); ++i) {
            const Triangle t = triangle_of(field, i);
            const math::Vec3 corners[4] = {t.a, t.b, t.c, t.a};
            for (int e = 0; e < 3; ++e) {
                const auto other = owner.find(edge_of(corners[e + 1], corners[e]));
                EXPECT_EQ(neighbor_of(field, i, e), other == owner.end() ? no_triangle : other->second);
            }
        }
    }
}

TEST(HeightFieldRefusal, NamesWhatIsWrong) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> six(6);
    auto make = [&](int columns, int rows, glm::vec2 spacing, std::vector<float> heights) {
        return [=] { HeightField(columns, rows, spacing, heights); };
    };
    expect_refused(make(1, 6, {1, 1}, six), "HeightField columns", "1");
    expect_refused(make(6, -1, {1, 1}, six), "HeightField rows", "-1");
    expect_refused(make(1 << 15, 1 << 14, {1, 1}, six), "HeightField columns x rows", "536870912");
    expect_refused(make(3, 2, {0, 1}, six), "HeightField spacing.x", "0");
    expect_refused(make(3, 2, {1, nan}, six), "HeightField spacing.y", "nan");
    expect_refused(make(3, 3, {1, 1}, six), "HeightField heights", "6");
    std::vector<float> bad = six;
    bad[4] = 2e6f;
    expect_refused(make(3, 2, {1, 1}, bad), "HeightField heights[4]", "2e+06");
    bad[4] = nan;
    expect_refused(make(3, 2, {1, 1}, bad), "HeightField heights[4]", "nan");
}

TEST(HeightFieldShape, GivesBackWhatItHolds) {
    const std::vector<float> heights = {1, 2, 3, 4, 5, -6};
    const HeightField field(3, 2, {0.5f, 2.0f}, heights);
    EXPECT_EQ(field.columns(), 3);
    EXPECT_EQ(field.rows(), 2);
    EXPECT_EQ(field.spacing(), glm::vec2(0.5f, 2.0f));
    EXPECT_EQ(std::vector<float>(field.heights().begin(), field.heights().end()), heights);
    EXPECT_EQ(field.data()->least, -6);
    EXPECT_EQ(field.data()->greatest, 5);
    EXPECT_NEAR(field.data()->bounding_radius, std::sqrt(0.25 + 36 + 1), 1e-5);
}

} // namespace

} // namespace cairn
