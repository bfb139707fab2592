#include "bench/mass.h"
#include "bench/overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace cairn::bench;
using cairn::Position;
using cairn::Quat;
using cairn::Vec3;

const Scene no_scene;

PlacedPart round_at(PartShape shape, Position center, float radius, float half_height = 0,
                    Quat rotation = Quat(1, 0, 0, 0)) {
    Part part;
    part.shape = shape;
    part.radius = radius;
    part.half_height = half_height;
    return place(no_scene, part, {center, rotation, {}, {}});
}

PlacedPart sphere_at(Position center, float radius) { return round_at(PartShape::sphere, center, radius); }

PlacedPart box_at(Position center, Vec3 half_extents, Quat rotation = Quat(1, 0, 0, 0)) {
    Part part;
    part.half_extents = half_extents;
    return place(no_scene, part, {center, rotation, {}, {}});
}

Scene scene_of(const ConvexHull& hull) {
    Scene scene;
    scene.hulls.push_back(hull);
    return scene;
}

PlacedPart hull_at(const ConvexHull& hull, Position center, Quat rotation = Quat(1, 0, 0, 0)) {
    Part part;
    part.shape = PartShape::hull;
    return place(scene_of(hull), part, {center, rotation, {}, {}});
}

// Vertices at a distance of `size` from the center on each axis.
ConvexHull octahedron(float size) {
    ConvexHull hull;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-size, size}) {
            hull.points.emplace_back(0.0f);
            hull.points.back()[axis] = side;
        }
    hull.triangles = hull_triangles(hull.points);
    return hull;
}

// A box as triangles.
ConvexHull box_hull(Vec3 half_extents) {
    ConvexHull hull;
    for (int i = 0; i < 8; ++i)
        hull.points.push_back(half_extents * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    hull.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return hull;
}

Quat turn(Vec3 axis, double angle) {
    const double s = std::sin(angle / 2);
    return Quat(float(std::cos(angle / 2)), float(axis.x * s), float(axis.y * s), float(axis.z * s));
}

TEST(BenchPenetration, of_two_spheres_is_the_overlap_of_their_radii) {
    EXPECT_NEAR(penetration(sphere_at({0, 0, 0}, 1), sphere_at({1.5, 0, 0}, 1)), 0.5, 1e-12);
    EXPECT_NEAR(penetration(sphere_at({0, 0, 0}, 1), sphere_at({0, 3, 0}, 0.5)), -1.5, 1e-12);
}

TEST(BenchPenetration, of_a_sphere_and_a_box_counts_from_the_nearest_feature) {
    const PlacedPart box = box_at({0, 0, 0}, {1, 2, 3});
    EXPECT_NEAR(penetration(sphere_at({1.25, 0, 0}, 0.5), box), 0.25, 1e-12);           // face
    EXPECT_NEAR(penetration(box, sphere_at({1.25, 0, 0}, 0.5)), 0.25, 1e-12);           // in either order
    EXPECT_NEAR(penetration(sphere_at({1.3, 2.4, 0}, 0.75), box), 0.25, 1e-6);          // edge, 0.5 away
    EXPECT_NEAR(penetration(sphere_at({1 + 2.0, 2 + 1.0, 3 + 2.0}, 1), box), -2, 1e-9); // corner, 3 away
    EXPECT_NEAR(penetration(sphere_at({0.75, 0, 0}, 0.5), box), 0.75, 1e-12);           // center inside
}

TEST(BenchPenetration, of_boxes_is_least_along_a_face_or_an_edge) {
    const PlacedPart box = box_at({0, 0, 0}, {0.5f, 0.5f, 0.5f});
    EXPECT_NEAR(penetration(box, box_at({0.25, 0.9, 0.1}, {0.5f, 0.5f, 0.5f})), 0.1, 1e-9);
    EXPECT_NEAR(penetration(box, box_at({0.25, 1.2, 0.1}, {0.5f, 0.5f, 0.5f})), -0.2, 1e-9);
    // An edge that points down: its depth is half the diagonal.
    const double reach = std::sqrt(0.5);
    const PlacedPart on_edge =
        box_at({0, 0.5 + reach - 0.05, 0}, {0.5f, 0.5f, 0.5f}, turn({0, 0, 1}, std::acos(0.0) / 2));
    EXPECT_NEAR(penetration(box, on_edge), 0.05, 1e-6);
    // Two crossing edges: only the cross product of both edges separates them.
    const double quarter = std::acos(0.0) / 2;
    const PlacedPart along_z = box_at({0, 0, 0}, {0.5f, 0.5f, 2}, turn({0, 0, 1}, quarter));
    const PlacedPart along_x = box_at({0, 2 * reach - 0.03, 0}, {2, 0.5f, 0.5f}, turn({1, 0, 0}, quarter));
    EXPECT_NEAR(penetration(along_z, along_x), 0.03, 1e-6);
}

TEST(BenchPenetration, of_boxes_is_symmetric_and_no_shorter_move_separates_them) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int overlapping = 0;
    for (int i = 0; i < 500; ++i) {
        const auto any_box = [&](Position center) {
            const glm::dvec3 axis = glm::normalize(glm::dvec3(between(-1, 1), between(-1, 1), between(0.1, 1)));
            return box_at(center, Vec3(between(0.2, 1), between(0.2, 1), between(0.2, 1)),
                          turn(Vec3(axis), between(0, 3)));
        };
        const PlacedPart a = any_box({0, 0, 0}), b = any_box({between(-1, 1), between(-1, 1), between(-1, 1)});
        const double depth = penetration(a, b);
        EXPECT_NEAR(depth, penetration(b, a), 1e-12);
        if (depth <= 0.01) continue;
        ++overlapping;
        // No translation shorter than the depth separates them.
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 way = glm::normalize(glm::dvec3(between(-1, 1), between(-1, 1), between(-1, 1)));
            PlacedPart moved = b;
            moved.center += 0.99 * depth * way;
            least = std::min(least, penetration(a, moved));
        }
        EXPECT_GT(least, 0);
    }
    EXPECT_GT(overlapping, 100);
}

constexpr double quarter = 1.5707963267948966;

TEST(BenchPenetration, of_hulls_is_that_of_the_boxes_that_they_are) {
    std::mt19937 random(11);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int overlapping = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 size_a(between(0.2, 1), between(0.2, 1), between(0.2, 1));
        const Vec3 size_b(between(0.2, 1), between(0.2, 1), between(0.2, 1));
        const Quat turn_a = turn(glm::normalize(Vec3(between(-1, 1), between(-1, 1), 1)), between(0, 3));
        const Quat turn_b = turn(glm::normalize(Vec3(between(-1, 1), between(-1, 1), 1)), between(0, 3));
        const Position at(between(-1, 1), between(-1, 1), between(-1, 1));
        const double depth = penetration(box_at({0, 0, 0}, size_a, turn_a), box_at(at, size_b, turn_b));
        const ConvexHull hull_a = box_hull(size_a), hull_b = box_hull(size_b);
        overlapping += depth > 0;
        for (const double other : {penetration(hull_at(hull_a, {0, 0, 0}, turn_a), hull_at(hull_b, at, turn_b)),
                                   penetration(hull_at(hull_a, {0, 0, 0}, turn_a), box_at(at, size_b, turn_b))}) {
            // For separated hulls both searches stop at the first separating axis.
            if (depth > 0) {
                EXPECT_NEAR(other, depth, 1e-6);
            } else {
                EXPECT_LE(other, 0);
            }
        }
    }
    EXPECT_GT(overlapping, 100);
}

TEST(BenchPenetration, of_octahedra_is_known) {
    const ConvexHull hull = octahedron(1);
    // Vertex against vertex along an axis: the minimal translation is along the face normals (1, 1, 1) / sqrt 3.
    EXPECT_NEAR(penetration(hull_at(hull, {0, 0, 0}), hull_at(hull, {0, 1.97, 0})), 0.03 / std::sqrt(3.0), 1e-6);
    EXPECT_LE(penetration(hull_at(hull, {0, 0, 0}), hull_at(hull, {0, 2.01, 0})), 0);
    // A vertex against a floor.
    EXPECT_NEAR(penetration(box_at({0, -1, 0}, {5, 1, 5}), hull_at(hull, {0.3, 0.98, 0})), 0.02, 1e-6);
    // A ball above a vertex, and one beside a face.
    EXPECT_NEAR(penetration(sphere_at({0, 1.4, 0}, 0.5), hull_at(hull, {0, 0, 0})), 0.1, 1e-5);
    const double face = (1 / std::sqrt(3.0) + 0.45) / std::sqrt(3.0); // the coordinates of a point 0.45 off a face
    EXPECT_NEAR(penetration(sphere_at({face, face, face}, 0.5), hull_at(hull, {0, 0, 0})), 0.05, 1e-6);
}

TEST(BenchPenetration, of_capsules_counts_from_axis_to_axis) {
    const auto capsule = [](Position center, Quat rotation = Quat(1, 0, 0, 0)) {
        return round_at(PartShape::capsule, center, 0.5f, 1.0f, rotation);
    };
    EXPECT_NEAR(penetration(capsule({0, 0, 0}), capsule({0.9, 0.5, 0})), 0.1, 1e-9); // parallel
    EXPECT_NEAR(penetration(capsule({0, 0, 0}), capsule({0, 2.95, 0})), 0.05, 1e-9); // end on
    EXPECT_NEAR(penetration(capsule({0, 0, 0}), capsule({0, 0, 0.92}, turn({0, 0, 1}, quarter))), 0.08, 1e-6); // across
    EXPECT_NEAR(penetration(capsule({0, 0, 0}), capsule({0, 3.2, 0})), -0.2, 1e-9);
    EXPECT_NEAR(penetration(capsule({0, 0, 0}), sphere_at({0.6, 0.4, 0}, 0.2f)), 0.1, 1e-6);
    // A capsule on a floor, standing and lying, and over the edge of a box.
    const PlacedPart floor = box_at({0, -1, 0}, {5, 1, 5});
    EXPECT_NEAR(penetration(floor, capsule({0, 1.48, 0})), 0.02, 1e-9);
    EXPECT_NEAR(penetration(capsule({0, 0.47, 0}, turn({0, 0, 1}, quarter)), floor), 0.03, 1e-6);
    EXPECT_NEAR(penetration(floor, capsule({5.3, 0.3, 0}, turn({1, 0, 0}, quarter))), 0.5 - 0.3 * std::sqrt(2.0), 1e-5);
}

TEST(BenchPenetration, of_cylinders_counts_from_ends_sides_and_rims) {
    const auto cylinder = [](Position center, Quat rotation = Quat(1, 0, 0, 0)) {
        return round_at(PartShape::cylinder, center, 0.5f, 1.0f, rotation);
    };
    const PlacedPart floor = box_at({0, -1, 0}, {5, 1, 5});
    EXPECT_NEAR(penetration(floor, cylinder({0, 0.99, 0})), 0.01, 1e-9);                           // on an end
    EXPECT_NEAR(penetration(floor, cylinder({0, 0.48, 0}, turn({0, 0, 1}, quarter))), 0.02, 1e-6); // on its side
    const double lean = std::sqrt(1.25); // on its rim: the corner of its silhouette is vertically below its center
    EXPECT_NEAR(penetration(floor, cylinder({0, lean - 0.03, 0}, turn({0, 0, 1}, std::atan(0.5)))), 0.03, 1e-6);
    EXPECT_NEAR(penetration(cylinder({0, 0, 0}), cylinder({0.6, 0.2, 0.75})), 1 - std::hypot(0.6, 0.75), 1e-6);
    EXPECT_NEAR(penetration(cylinder({0, 0, 0}), cylinder({0.1, 1.96, 0})), 0.04, 1e-9); // ends
    EXPECT_NEAR(penetration(cylinder({0, 0, 0}), cylinder({0, 0, 0.95}, turn({0, 0, 1}, quarter))), 0.05,
                1e-6); // across
    EXPECT_LE(penetration(cylinder({0, 0, 0}), cylinder({0.8, 0, 0.8})), 0);
}

// The least overlap over many directions, refined around the best one: slow, and independent of the code under test.
double by_many_directions(const PlacedPart& a, const PlacedPart& b) {
    const auto reach = [](const PlacedPart& part, const glm::dvec3& d) {
        const double along = std::abs(glm::dot(d, part.axes[1]));
        if (part.shape == PartShape::capsule) return part.radius + part.half_height * along;
        if (part.shape == PartShape::cylinder)
            return part.half_height * along + part.radius * std::sqrt(std::max(0.0, 1 - along * along));
        double sum = 0;
        for (int i = 0; i < 3; ++i) sum += std::abs(glm::dot(d, part.axes[i])) * part.half_extents[i];
        return sum;
    };
    glm::dvec3 best(0, 1, 0);
    double least = std::numeric_limits<double>::infinity();
    const auto try_direction = [&](const glm::dvec3& d) {
        const double overlap = reach(a, d) + reach(b, d) - glm::dot(d, b.center - a.center);
        if (overlap < least) least = overlap, best = d;
    };
    constexpr int count = 60000;
    for (int i = 0; i < count; ++i) { // a Fibonacci lattice
        const double y = 1 - 2 * (i + 0.5) / count, r = std::sqrt(1 - y * y), angle = i * 2.399963229728653;
        try_direction({r * std::cos(angle), y, r * std::sin(angle)});
    }
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (double spread = 0.02; spread > 1e-6; spread *= 0.7)
        for (int i = 0; i < 200; ++i)
            try_direction(glm::normalize(best + spread * glm::dvec3(normal(random), normal(random), normal(random))));
    return least;
}

TEST(BenchPenetration, of_round_shapes_is_as_small_as_a_dense_search_finds) {
    std::mt19937 random(5);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int overlapping = 0;
    for (int i = 0; i < 60; ++i) {
        const auto any_part = [&](PartShape shape, Position center) {
            const Quat rotation =
                turn(glm::normalize(Vec3(between(-1, 1), between(-1, 1), between(0.1, 1))), between(0, 3));
            if (shape == PartShape::box)
                return box_at(center, Vec3(between(0.2, 0.5), between(0.2, 0.5), between(0.2, 0.5)), rotation);
            return round_at(shape, center, float(between(0.15, 0.35)), float(between(0.15, 0.5)), rotation);
        };
        const PartShape others[] = {PartShape::capsule, PartShape::cylinder, PartShape::box};
        const PlacedPart a = any_part(PartShape::cylinder, {0, 0, 0});
        const PlacedPart b = any_part(others[i % 3], {between(-0.6, 0.6), between(-0.6, 0.6), between(-0.6, 0.6)});
        const double depth = penetration(a, b), expected = by_many_directions(a, b);
        if (expected < 1e-4) {
            EXPECT_LT(depth, 1e-4);
            continue;
        }
        ++overlapping;
        EXPECT_GE(depth, expected - 1e-5) << i;
        EXPECT_LE(depth, 1.005 * expected + 1e-5) << i;
    }
    EXPECT_GT(overlapping, 20);
}

// A ramp that rises by `slope` per meter along x, with a peak of height `tip` in its middle.
SurfaceMesh ramp(float slope, float tip = 0) {
    SurfaceMesh mesh;
    mesh.columns = mesh.rows = 5;
    mesh.spacing = 1;
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column)
            mesh.vertices.emplace_back(column - 2, slope * float(column - 2) + (row == 2 && column == 2 ? tip : 0.0f),
                                       row - 2);
    for (std::uint32_t row = 0; row < 4; ++row)
        for (std::uint32_t column = 0; column < 4; ++column) {
            const std::uint32_t corner = row * 5 + column;
            for (const std::uint32_t i : {corner, corner + 5, corner + 6, corner, corner + 6, corner + 1})
                mesh.indices.push_back(i);
        }
    return mesh;
}

TEST(BenchPenetration, of_a_part_in_a_mesh_is_its_depth_below_the_triangles) {
    Scene scene;
    scene.meshes.push_back(ramp(0.75f)); // the normal is (-0.6, 0.8, 0)
    Part part;
    part.shape = PartShape::mesh;
    const PlacedPart surface = place(scene, part, {{10, 5, 0}, Quat(1, 0, 0, 0), {}, {}});
    const auto above = [](double x, double height) { // at that distance from the surface along its normal
        return Position(10 + x - 0.6 * height, 5 + 0.75 * x + 0.8 * height, 0.3);
    };
    const Quat along = turn({0, 0, 1}, std::atan(0.75));
    EXPECT_NEAR(penetration(sphere_at(above(0.2, 0.45), 0.5), surface), 0.05, 1e-6);
    EXPECT_NEAR(penetration(surface, sphere_at(above(0.2, 0.7), 0.5)), -0.2, 1e-6);
    EXPECT_NEAR(penetration(box_at(above(0, 0.28), {0.4f, 0.3f, 0.2f}, along), surface), 0.02, 1e-6);
    EXPECT_NEAR(penetration(round_at(PartShape::capsule, above(0, 0.96), 0.5f, 0.5f, along), surface), 0.04, 1e-6);
    EXPECT_NEAR(penetration(round_at(PartShape::cylinder, above(0, 0.49), 0.3f, 0.5f, along), surface), 0.01, 1e-6);
    EXPECT_LT(penetration(box_at({20, 0, 0}, {0.4f, 0.3f, 0.2f}), surface), -1); // beside the surface
}

TEST(BenchPenetration, of_a_part_on_a_tip_of_a_mesh_counts_from_the_tip) {
    Scene scene;
    scene.meshes.push_back(ramp(0, 0.5f));
    Part part;
    part.shape = PartShape::mesh;
    const PlacedPart surface = place(scene, part, {{0, 0, 0}, Quat(1, 0, 0, 0), {}, {}});
    EXPECT_NEAR(penetration(surface, box_at({0.05, 0.97, 0}, {0.4f, 0.5f, 0.4f})), 0.03, 1e-6);
    EXPECT_NEAR(penetration(surface, hull_at(octahedron(1), {0, 1.46, 0})), 0.04 * 2 / std::sqrt(5.0), 1e-6);
}

TEST(BenchMass, of_parts_is_that_of_the_textbook) {
    Scene scene;
    scene.hulls.push_back(octahedron(2));
    Part part;
    part.shape = PartShape::hull; // edge s = 2 sqrt 2: volume sqrt(2)/3 s^3, moments m s^2 / 10
    MassProperties mass = mass_of(scene, part, 3);
    EXPECT_NEAR(mass.mass, 3 * 32.0 / 3, 1e-9);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(mass.inertia[i][i], mass.mass * 0.8, 1e-9);
    EXPECT_NEAR(mass.inertia[0][1], 0, 1e-9);

    part.shape = PartShape::cylinder;
    part.radius = 2;
    part.half_height = 1.5f;
    mass = mass_of(scene, part, 1);
    EXPECT_NEAR(mass.mass, 12 * 2 * quarter, 1e-6);
    EXPECT_NEAR(mass.inertia[1][1] / mass.mass, 2, 1e-6);
    EXPECT_NEAR(mass.inertia[0][0] / mass.mass, 1 + 0.75, 1e-6);

    part.half_height = 0; // a capsule of zero length is a ball
    part.shape = PartShape::capsule;
    mass = mass_of(scene, part, 1);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(mass.inertia[i][i] / mass.mass, 0.4 * 4, 1e-6);
    // A capsule much longer than thick approximates a rod.
    part.half_height = 1000;
    mass = mass_of(scene, part, 1);
    EXPECT_NEAR(mass.inertia[2][2] / mass.mass, 1000.0 * 1000 / 3, 3000);
}

TEST(BenchMass, of_a_hull_that_is_no_simple_polyhedron_is_refused) {
    std::vector<Vec3> points = octahedron(1).points;
    points.emplace_back(0.1f, 0.2f, 0.1f); // an interior point
    EXPECT_THROW(hull_triangles(points), std::invalid_argument);
    EXPECT_THROW(hull_triangles(box_hull({1, 1, 1}).points), std::invalid_argument); // four points in a plane
}

} // namespace
