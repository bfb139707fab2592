#include "viewer/minkowski.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

namespace cairn::viewer {

namespace {

constexpr int most_iterations = 64;
constexpr double tolerance = 1e-9;      // relative to the squared distance: least decrease per iteration
constexpr std::size_t most_others = 24; // number of nearest bodies that are considered
constexpr int rings = 12, sides = 24;   // of the sphere grid of sampling directions

// Support point in the shape's own frame, in the unit direction `d`.
struct Support {
    glm::dvec3 d;

    glm::dvec3 operator()(const Sphere& sphere) const { return d * double(sphere.radius); }
    glm::dvec3 operator()(const Box& box) const {
        return glm::dvec3(std::copysign(double(box.half_extents.x), d.x),
                          std::copysign(double(box.half_extents.y), d.y),
                          std::copysign(double(box.half_extents.z), d.z)) +
               d * double(box.rounding);
    }
    glm::dvec3 operator()(const Capsule& capsule) const {
        const double half = double(capsule.half_height);
        const glm::dvec3 low = glm::dvec3(0.0, -half, 0.0) + d * double(capsule.radius);
        const glm::dvec3 high = glm::dvec3(0.0, half, 0.0) + d * double(capsule.radius_top.value_or(capsule.radius));
        return glm::dot(low, d) > glm::dot(high, d) ? low : high;
    }
    glm::dvec3 operator()(const Cylinder& cylinder) const {
        const double flat = std::hypot(d.x, d.z), half = double(cylinder.half_height);
        const glm::dvec3 out = flat > 1e-12 ? glm::dvec3(d.x, 0.0, d.z) / flat : glm::dvec3(1.0, 0.0, 0.0);
        const glm::dvec3 low = out * double(cylinder.radius) - glm::dvec3(0.0, half, 0.0);
        const glm::dvec3 high =
            out * double(cylinder.radius_top.value_or(cylinder.radius)) + glm::dvec3(0.0, half, 0.0);
        return (glm::dot(low, d) > glm::dot(high, d) ? low : high) + d * double(cylinder.rounding);
    }
    glm::dvec3 operator()(const Hull& hull) const {
        glm::dvec3 best(hull.vertices().front());
        for (const Vec3& vertex : hull.vertices())
            if (glm::dot(glm::dvec3(vertex), d) > glm::dot(best, d)) best = glm::dvec3(vertex);
        return best + d * double(hull.rounding);
    }
    template <class Other> glm::dvec3 operator()(const Other&) const { return glm::dvec3(0.0); }
};

// The point nearest to the origin in the affine hull (point, line or plane) of some points, if it lies within their
// convex hull. Solves the normal equations of least squares for the weights of all points but the first.
std::optional<glm::dvec3> nearest_within(const std::vector<glm::dvec3>& points) {
    const std::size_t count = points.size();
    glm::dmat3 gram(1.0);
    glm::dvec3 right(0.0);
    for (std::size_t i = 1; i < count; ++i) {
        for (std::size_t k = 1; k < count; ++k)
            gram[int(k - 1)][int(i - 1)] = glm::dot(points[i] - points[0], points[k] - points[0]);
        right[int(i - 1)] = -glm::dot(points[i] - points[0], points[0]);
    }
    const double size = gram[0][0] * gram[1][1] * gram[2][2];
    // Degenerate: a smaller subset has the same nearest point.
    if (std::abs(glm::determinant(gram)) <= 1e-12 * size) return std::nullopt;
    const glm::dvec3 weights = glm::inverse(gram) * right;
    glm::dvec3 nearest = points[0];
    double first = 1.0;
    for (std::size_t i = 1; i < count; ++i) {
        if (weights[int(i - 1)] < 0.0) return std::nullopt;
        first -= weights[int(i - 1)];
        nearest += (points[i] - points[0]) * weights[int(i - 1)];
    }
    return first < 0.0 ? std::nullopt : std::optional(nearest);
}

// Reduces a simplex to the vertices that support the point of its convex hull nearest to the origin: the subset, among
// all subsets, whose own nearest point is nearest.
glm::dvec3 reduce(std::vector<glm::dvec3>& simplex) {
    std::vector<glm::dvec3> best;
    glm::dvec3 nearest(0.0);
    double least = std::numeric_limits<double>::infinity();
    for (unsigned mask = 1; mask < 1u << simplex.size(); ++mask) {
        std::vector<glm::dvec3> subset;
        for (std::size_t i = 0; i < simplex.size(); ++i)
            if (mask >> i & 1u) subset.push_back(simplex[i]);
        const std::optional<glm::dvec3> point = nearest_within(subset);
        if (!point || glm::dot(*point, *point) >= least) continue;
        least = glm::dot(*point, *point);
        nearest = *point;
        best = std::move(subset);
    }
    simplex = std::move(best);
    return nearest;
}

glm::dvec3 difference_support(const ConvexShape& a, const ConvexShape& b, const glm::dvec3& direction) {
    return support(a, direction) - support(b, -direction);
}

// Samples the surface by support points in many directions: those of a sphere grid that is rotated, so that no
// direction is along an axis, where the support point of a box is not unique. Several directions often give the same
// point.
void add_surface(PairDifference& result, const ConvexShape& a, const ConvexShape& b) {
    const glm::dquat aslant = glm::normalize(glm::dquat(0.9, 0.21, 0.17, 0.11));
    for (int i = 0; i <= rings; ++i)
        for (int k = 0; k < sides; ++k) {
            const double polar = std::numbers::pi * i / rings, around = 2.0 * std::numbers::pi * k / sides;
            const glm::dvec3 direction(std::sin(polar) * std::cos(around), std::cos(polar),
                                       std::sin(polar) * std::sin(around));
            result.points.push_back(Vec3(difference_support(a, b, aslant * direction)));
        }
    const auto triangle = [&](int x, int y, int z) {
        const Vec3 &p = result.points[std::size_t(x)], &q = result.points[std::size_t(y)],
                   &r = result.points[std::size_t(z)];
        if (glm::length(glm::cross(q - p, r - p)) > 1e-7f)
            result.triangles.push_back({std::size_t(x), std::size_t(y), std::size_t(z)});
    };
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < sides; ++k) {
            const int here = i * sides + k, beside = i * sides + (k + 1) % sides;
            triangle(here, beside, here + sides);
            triangle(beside, beside + sides, here + sides);
        }
}

} // namespace

std::optional<ConvexShape> convex_shape(const World& world, ShapeId id) {
    const Shape& shape = world.shape(id);
    if (std::holds_alternative<Plane>(shape) || std::holds_alternative<Mesh>(shape) ||
        std::holds_alternative<HeightField>(shape))
        return std::nullopt;
    return ConvexShape{shape, world.shape_transform(id)};
}

glm::dvec3 support(const ConvexShape& shape, const glm::dvec3& direction) {
    const glm::dquat rotation(shape.pose.rotation);
    const glm::dvec3 local = glm::normalize(glm::conjugate(rotation) * direction);
    return shape.pose.position + rotation * std::visit(Support{local}, shape.shape);
}

GjkResult gjk(const ConvexShape& a, const ConvexShape& b) {
    GjkResult result;
    const glm::dvec3 between = a.pose.position - b.pose.position;
    result.simplex = {
        difference_support(a, b, glm::dot(between, between) > 0.0 ? -between : glm::dvec3(1.0, 0.0, 0.0))};
    result.nearest = result.simplex.front();
    while (result.iterations < most_iterations) {
        ++result.iterations;
        const double squared = glm::dot(result.nearest, result.nearest);
        if (squared < 1e-18) break; // the origin is inside
        const glm::dvec3 next = difference_support(a, b, -result.nearest);
        // The present point is the nearest one to within tolerance.
        if (squared - glm::dot(result.nearest, next) <= tolerance * squared) break;
        result.simplex.push_back(next);
        result.nearest = reduce(result.simplex);
        if (result.simplex.size() == 4) break; // the simplex encloses the origin
    }
    result.distance = glm::length(result.nearest);
    if (result.distance < 1e-9) result.distance = 0.0;
    return result;
}

std::optional<PairDifference> nearest_difference(const World& world, BodyId body) {
    if (!body || !world.is_valid(body)) return std::nullopt;
    std::vector<BodyId> others;
    for (const BodyId other : world.bodies())
        if (other != body) others.push_back(other);
    const auto distance = [&](BodyId other) {
        return glm::length(world.body(other).position() - world.body(body).position());
    };
    std::sort(others.begin(), others.end(), [&](BodyId a, BodyId b) { return distance(a) < distance(b); });
    if (others.size() > most_others) others.resize(most_others);
    std::optional<PairDifference> nearest;
    ConvexShape first, second;
    for (const ShapeId own : world.body(body).shapes()) {
        const std::optional<ConvexShape> a = convex_shape(world, own);
        if (!a) continue;
        for (const BodyId other : others)
            for (const ShapeId shape : world.body(other).shapes()) {
                const std::optional<ConvexShape> b = convex_shape(world, shape);
                if (!b) continue;
                GjkResult found = gjk(*a, *b);
                if (nearest && found.distance >= nearest->gjk.distance) continue;
                nearest = PairDifference{other, b->pose.position, {}, {}, std::move(found)};
                first = *a;
                second = *b;
            }
    }
    if (nearest) add_surface(*nearest, first, second);
    return nearest;
}

} // namespace cairn::viewer
