#include "bench/quality.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace cairn::bench {

namespace {

using Vector = glm::dvec3;

Vector rotate(const Quat& q, const Vector& v) {
    const Vector u(q.x, q.y, q.z);
    const Vector t = 2.0 * glm::cross(u, v);
    return v + double(q.w) * t + glm::cross(u, t);
}

bool is_finite(const BodyState& s) {
    const double sum = s.position.x + s.position.y + s.position.z + s.rotation.x + s.rotation.y + s.rotation.z +
                       s.rotation.w + s.linear_velocity.x + s.linear_velocity.y + s.linear_velocity.z +
                       s.angular_velocity.x + s.angular_velocity.y + s.angular_velocity.z;
    return std::isfinite(sum);
}

double box_radius_along(const PlacedPart& box, const Vector& direction) {
    double radius = 0;
    for (int i = 0; i < 3; ++i) radius += std::abs(glm::dot(direction, box.axes[i])) * box.half_extents[i];
    return radius;
}

double sphere_box_penetration(const PlacedPart& sphere, const PlacedPart& box) {
    const Vector offset = sphere.center - box.center;
    Vector outside(0.0);
    double inside = -std::numeric_limits<double>::infinity(); // greatest signed distance from a face plane
    for (int i = 0; i < 3; ++i) {
        const double distance = std::abs(glm::dot(offset, box.axes[i])) - box.half_extents[i];
        outside[i] = std::max(distance, 0.0);
        inside = std::max(inside, distance);
    }
    return sphere.radius - (glm::length(outside) + std::min(inside, 0.0));
}

// The separating axis test over all 15 axes (Gottschalk, Lin, Manocha, "OBBTree", 1996).
double box_box_penetration(const PlacedPart& a, const PlacedPart& b) {
    constexpr double parallel = 1e-6; // sine of the angle below which two edges give no axis of their own
    const Vector offset = b.center - a.center;
    double least = std::numeric_limits<double>::infinity();
    const auto try_axis = [&](const Vector& axis) {
        const double apart = std::abs(glm::dot(axis, offset));
        least = std::min(least, box_radius_along(a, axis) + box_radius_along(b, axis) - apart);
    };
    for (int i = 0; i < 3; ++i) try_axis(a.axes[i]), try_axis(b.axes[i]);
    if (least <= 0) return least;
    for (const Vector& edge_a : a.axes)
        for (const Vector& edge_b : b.axes) {
            const Vector axis = glm::cross(edge_a, edge_b);
            const double length = glm::length(axis);
            if (length > parallel) try_axis(axis / length);
        }
    return least;
}

template <class F> void for_each_finite(const Scene& scene, std::span<const BodyState> states, F&& f) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].motion == Motion::dynamic && is_finite(states[i])) f(scene.bodies[i], states[i]);
}

// Principal moments of a dynamic body, whose one part is at its center and not turned, kg m^2.
Vector moments_of(const Scene& scene, const SceneBody& body) {
    const Part& part = scene.parts[body.first_part];
    const double mass = body.mass;
    if (part.shape == PartShape::sphere) return Vector(0.4 * mass * part.radius * part.radius);
    const Vector square = Vector(part.half_extents) * Vector(part.half_extents);
    return mass / 3 * Vector(square.y + square.z, square.x + square.z, square.x + square.y);
}

} // namespace

PlacedPart place(const Part& part, const BodyState& body) {
    PlacedPart placed;
    placed.shape = part.shape;
    placed.center = body.position + rotate(body.rotation, Vector(part.position));
    if (part.shape == PartShape::sphere) {
        placed.radius = placed.bounding_radius = part.radius;
        return placed;
    }
    placed.half_extents = Vector(part.half_extents);
    placed.bounding_radius = glm::length(placed.half_extents);
    for (int i = 0; i < 3; ++i) {
        Vector axis(0.0);
        axis[i] = 1.0;
        placed.axes[i] = rotate(body.rotation, rotate(part.rotation, axis));
    }
    return placed;
}

double penetration(const PlacedPart& a, const PlacedPart& b) {
    if (a.shape == PartShape::box)
        return b.shape == PartShape::box ? box_box_penetration(a, b) : sphere_box_penetration(b, a);
    if (b.shape == PartShape::box) return sphere_box_penetration(a, b);
    return a.radius + b.radius - glm::length(a.center - b.center);
}

Penetrations measure_penetrations(const Scene& scene, std::span<const BodyState> states) {
    std::vector<PlacedPart> dynamic, others;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!is_finite(states[i])) continue;
        const SceneBody& body = scene.bodies[i];
        for (std::size_t k = 0; k < body.part_count; ++k)
            (body.motion == Motion::dynamic ? dynamic : others)
                .push_back(place(scene.parts[body.first_part + k], states[i]));
    }
    std::vector<double> depths;
    const auto test = [&](const PlacedPart& a, const PlacedPart& b) {
        const double reach = a.bounding_radius + b.bounding_radius;
        const Vector offset = a.center - b.center;
        if (glm::dot(offset, offset) > reach * reach) return;
        const double depth = penetration(a, b);
        if (depth > 0) depths.push_back(depth);
    };
    for (const PlacedPart& a : dynamic)
        for (const PlacedPart& b : others) test(a, b);
    // Among each other: a sweep along x.
    std::sort(dynamic.begin(), dynamic.end(), [](const PlacedPart& a, const PlacedPart& b) {
        return a.center.x - a.bounding_radius < b.center.x - b.bounding_radius;
    });
    for (std::size_t i = 0; i < dynamic.size(); ++i) {
        const double end = dynamic[i].center.x + dynamic[i].bounding_radius;
        for (std::size_t k = i + 1; k < dynamic.size(); ++k) {
            if (dynamic[k].center.x - dynamic[k].bounding_radius > end) break;
            test(dynamic[i], dynamic[k]);
        }
    }
    Penetrations result;
    if (depths.empty()) return result;
    std::sort(depths.begin(), depths.end());
    result.overlaps = depths.size();
    result.greatest = depths.back();
    result.p99 = depths[static_cast<std::size_t>(0.99 * static_cast<double>(depths.size() - 1))];
    for (const double depth : depths) result.mean += depth / static_cast<double>(depths.size());
    return result;
}

Displacement measure_displacement(const Scene& scene, std::span<const BodyState> states) {
    Displacement result;
    for_each_finite(scene, states, [&](const SceneBody& body, const BodyState& state) {
        const Vector moved = state.position - Position(body.position);
        result.drift = std::max(result.drift, std::hypot(moved.x, moved.z));
        result.sag = std::max(result.sag, -moved.y);
    });
    return result;
}

std::size_t count_lost(const Scene& scene, std::span<const BodyState> states) {
    std::size_t kept = 0;
    for_each_finite(scene, states, [&](const SceneBody&, const BodyState& state) {
        bool in_bounds = true;
        for (int i = 0; i < 3; ++i)
            in_bounds = in_bounds && state.position[i] >= double(scene.lower_bound[i]) &&
                        state.position[i] <= double(scene.upper_bound[i]);
        const Vector arm = state.position - Position(scene.axis_point);
        kept += in_bounds && std::hypot(arm.x, arm.y) <= double(scene.axis_distance);
    });
    return scene.dynamic_count - kept;
}

double measure_kinetic_energy(const Scene& scene, std::span<const BodyState> states) {
    double energy = 0;
    for_each_finite(scene, states, [&](const SceneBody& body, const BodyState& state) {
        const Vector v(state.linear_velocity);
        const Quat& q = state.rotation;
        const Vector w = rotate(Quat(q.w, -q.x, -q.y, -q.z), Vector(state.angular_velocity));
        energy += 0.5 * (double(body.mass) * glm::dot(v, v) + glm::dot(moments_of(scene, body), w * w));
    });
    return energy;
}

std::uint64_t hash_of(std::span<const BodyState> states) {
    // FNV-1a, 64 bits, over the bits of every number.
    std::uint64_t hash = 0xcbf29ce484222325ull;
    const auto add = [&](double number) {
        std::uint64_t bits;
        std::memcpy(&bits, &number, sizeof bits);
        for (int shift = 0; shift < 64; shift += 8) hash = (hash ^ ((bits >> shift) & 255)) * 0x100000001b3ull;
    };
    for (const BodyState& s : states)
        for (const double number :
             {s.position.x, s.position.y, s.position.z, double(s.rotation.x), double(s.rotation.y),
              double(s.rotation.z), double(s.rotation.w), double(s.linear_velocity.x), double(s.linear_velocity.y),
              double(s.linear_velocity.z), double(s.angular_velocity.x), double(s.angular_velocity.y),
              double(s.angular_velocity.z)})
            add(number);
    return hash;
}

} // namespace cairn::bench
