// The cores of shapes, for the oracle.
#include "oracle.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

using namespace cairn;

struct HalfSpace { // dot(normal, p) <= offset
    glm::dvec3 normal;
    double offset;
};

// The vertices of the polyhedron bounded by these planes: the intersections of three planes that lie behind all others.
std::vector<CorePiece::Ball> corners_of(const std::vector<HalfSpace>& planes) {
    std::vector<CorePiece::Ball> corners;
    for (std::size_t i = 0; i < planes.size(); ++i)
        for (std::size_t j = i + 1; j < planes.size(); ++j)
            for (std::size_t k = j + 1; k < planes.size(); ++k) {
                const HalfSpace &p = planes[i], &q = planes[j], &r = planes[k];
                const glm::dvec3 qr = glm::cross(q.normal, r.normal);
                const double volume = glm::dot(p.normal, qr);
                if (std::fabs(volume) < 1e-9) continue;
                const glm::dvec3 point = (p.offset * qr + q.offset * glm::cross(r.normal, p.normal) +
                                          r.offset * glm::cross(p.normal, q.normal)) /
                                         volume;
                double scale = 0, outside = -1;
                for (const HalfSpace& plane : planes) {
                    scale = std::max(scale, std::fabs(plane.offset));
                    outside = std::max(outside, glm::dot(plane.normal, point) - plane.offset);
                }
                if (outside < 1e-7 * scale) corners.push_back({point, 0});
            }
    return corners;
}

std::vector<HalfSpace> planes_of(const Hull& hull) {
    std::vector<HalfSpace> planes;
    for (std::size_t i = 0; i < hull.face_count(); ++i) {
        const auto face = hull.face(i);
        // Newell's normal, which takes all vertices of the face into account.
        glm::dvec3 normal(0), middle(0);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const glm::dvec3 a(hull.vertices()[face[k]]), b(hull.vertices()[face[(k + 1) % face.size()]]);
            normal += glm::cross(a, b);
            middle += a / double(face.size());
        }
        normal = glm::normalize(normal);
        planes.push_back({normal, glm::dot(normal, middle)});
    }
    return planes;
}

CorePiece triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return {{{a, 0}, {b, 0}, {c, 0}}, {}, 0};
}

// The remaining rounding of a shape, and the inset of its sharp part.
struct Shrink {
    double rounding, sharp;
};
Shrink share(float rounding, double shrink) {
    return {std::max(0.0, double(rounding) - shrink), std::max(0.0, shrink - double(rounding))};
}

void add(Core& core, const Sphere& sphere, double shrink) {
    const double radius = double(sphere.radius) - shrink;
    if (radius > 0) core.pieces.push_back({{{{0, 0, 0}, radius}}, {}, 0});
}

void add(Core& core, const Box& box, double shrink) {
    const Shrink part = share(box.rounding, shrink);
    const glm::dvec3 half = glm::dvec3(box.half_extents) - part.sharp;
    if (!(std::min({half.x, half.y, half.z}) > 0)) return;
    CorePiece piece{{}, {}, part.rounding};
    for (unsigned corner = 0; corner < 8; ++corner)
        piece.balls.push_back(
            {{corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y, corner & 4 ? half.z : -half.z}, 0});
    core.pieces.push_back(piece);
}

void add(Core& core, const Capsule& capsule, double shrink) {
    const double low = double(capsule.radius) - shrink, half = double(capsule.half_height);
    const double high = double(capsule.radius_top.value_or(capsule.radius)) - shrink;
    CorePiece piece;
    if (low > 0) piece.balls.push_back({{0, -half, 0}, low});
    if (high > 0) piece.balls.push_back({{0, half, 0}, high});
    if (!piece.balls.empty()) core.pieces.push_back(piece);
}

void add(Core& core, const Cylinder& cylinder, double shrink) {
    const Shrink part = share(cylinder.rounding, shrink);
    const double half = double(cylinder.half_height), low = double(cylinder.radius);
    const double slope = (double(cylinder.radius_top.value_or(cylinder.radius)) - low) / (2 * half);
    // The sides move inward along their normals.
    const double middle = low + slope * half - part.sharp * std::sqrt(1 + slope * slope);
    CorePiece::Round round{part.sharp - half, half - part.sharp, 0, 0};
    if (slope < 0) round.high = std::min(round.high, -middle / slope); // new tip of a cone
    if (slope > 0) round.low = std::max(round.low, -middle / slope);
    round.radius_low = std::max(0.0, middle + slope * round.low);
    round.radius_high = std::max(0.0, middle + slope * round.high);
    if (round.high > round.low && std::max(round.radius_low, round.radius_high) > 0)
        core.pieces.push_back({{}, round, part.rounding});
}

void add(Core& core, const Hull& hull, double shrink) {
    const Shrink part = share(hull.rounding, shrink);
    CorePiece piece{{}, {}, part.rounding};
    if (part.sharp > 0) {
        std::vector<HalfSpace> planes = planes_of(hull);
        for (HalfSpace& plane : planes) plane.offset -= part.sharp;
        piece.balls = corners_of(planes);
    } else {
        for (const Vec3& corner : hull.vertices()) piece.balls.push_back({glm::dvec3(corner), 0});
    }
    if (!piece.balls.empty()) core.pieces.push_back(piece);
}

void add(Core& core, const Plane& plane, double) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(plane.normal));
    if (!plane.half_extents) {
        core.half_space = normal;
        return;
    }
    const glm::dvec3 given(plane.tangent);
    const glm::dvec3 tangent = glm::normalize(given - glm::dot(given, normal) * normal);
    const glm::dvec3 x = double(plane.half_extents->x) * tangent;
    const glm::dvec3 y = double(plane.half_extents->y) * glm::cross(normal, tangent);
    core.pieces.push_back({{{x + y, 0}, {x - y, 0}, {-x - y, 0}, {y - x, 0}}, {}, 0});
}

void add(Core& core, const Mesh& mesh, double) {
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh.vertices()[mesh.indices()[i]]); };
    for (std::size_t i = 0; i + 2 < mesh.indices().size(); i += 3)
        core.pieces.push_back(triangle(at(i), at(i + 1), at(i + 2)));
}

void add(Core& core, const HeightField& field, double) {
    const auto at = [&](int column, int row) {
        return glm::dvec3((column - 0.5 * (field.columns() - 1)) * double(field.spacing().x),
                          double(field.heights()[std::size_t(row * field.columns() + column)]),
                          (row - 0.5 * (field.rows() - 1)) * double(field.spacing().y));
    };
    for (int row = 0; row + 1 < field.rows(); ++row)
        for (int column = 0; column + 1 < field.columns(); ++column) {
            const glm::dvec3 a = at(column, row), d = at(column + 1, row + 1);
            core.pieces.push_back(triangle(a, at(column + 1, row), d));
            core.pieces.push_back(triangle(a, at(column, row + 1), d));
        }
}

double inner_radius_of(const Sphere& sphere) { return double(sphere.radius); }
double inner_radius_of(const Box& box) {
    const Vec3& half = box.half_extents;
    return double(std::min({half.x, half.y, half.z}) + box.rounding);
}
double inner_radius_of(const Capsule& capsule) {
    return double(std::max(capsule.radius, capsule.radius_top.value_or(capsule.radius)));
}
double inner_radius_of(const Cylinder& cylinder) {
    const double half = double(cylinder.half_height), low = double(cylinder.radius);
    const double high = double(cylinder.radius_top.value_or(cylinder.radius));
    // The ball touches the side and the larger base.
    const double slope = std::fabs(high - low) / (2 * half);
    const double beside = std::max(low, high) / (slope + std::sqrt(1 + slope * slope));
    return std::min(half, beside) + double(cylinder.rounding);
}
double inner_radius_of(const Hull& hull) {
    glm::dvec3 middle(0);
    for (const Vec3& corner : hull.vertices()) middle += glm::dvec3(corner) / double(hull.vertices().size());
    double radius = std::numeric_limits<double>::infinity();
    for (const HalfSpace& plane : planes_of(hull))
        radius = std::min(radius, plane.offset - glm::dot(plane.normal, middle));
    return radius + double(hull.rounding);
}
template <class Surface> double inner_radius_of(const Surface&) { return 0; }

} // namespace

Core make_core(const Shape& shape, double shrink) {
    Core core;
    std::visit([&](const auto& one) { add(core, one, shrink); }, shape);
    return core;
}

double inner_radius(const Shape& shape) {
    return std::visit([](const auto& one) { return inner_radius_of(one); }, shape);
}

glm::dvec3 CorePiece::support(const glm::dvec3& direction) const {
    glm::dvec3 farthest(0);
    if (round) {
        const double side = std::hypot(direction.x, direction.z);
        const glm::dvec3 out = side > 0 ? glm::dvec3(direction.x, 0, direction.z) / side : glm::dvec3(0);
        const glm::dvec3 low = glm::dvec3(0, round->low, 0) + round->radius_low * out;
        const glm::dvec3 high = glm::dvec3(0, round->high, 0) + round->radius_high * out;
        farthest = glm::dot(low, direction) > glm::dot(high, direction) ? low : high;
    } else {
        double most = -std::numeric_limits<double>::infinity();
        for (const Ball& ball : balls) {
            const double along = glm::dot(ball.center, direction) + ball.radius;
            if (!(along > most)) continue;
            most = along;
            farthest = ball.center + ball.radius * direction;
        }
    }
    return farthest + rounding * direction;
}

double Core::reach_from(const glm::dvec3& center) const {
    double reach = half_space ? std::numeric_limits<double>::infinity() : 0;
    for (const CorePiece& piece : pieces) {
        double farthest = 0;
        for (const CorePiece::Ball& ball : piece.balls)
            farthest = std::max(farthest, glm::length(ball.center - center) + ball.radius);
        if (piece.round) {
            const double aside = std::hypot(center.x, center.z);
            farthest = std::max(std::hypot(piece.round->low - center.y, piece.round->radius_low + aside),
                                std::hypot(piece.round->high - center.y, piece.round->radius_high + aside));
        }
        reach = std::max(reach, farthest + piece.rounding);
    }
    return reach;
}

} // namespace cairn_test
