#include "bench/quality.h"

#include "bench/rotate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <utility>

namespace cairn::bench {

namespace {

using Vector = glm::dvec3;

bool is_finite(const BodyState& s) {
    const double sum = s.position.x + s.position.y + s.position.z + s.rotation.x + s.rotation.y + s.rotation.z +
                       s.rotation.w + s.linear_velocity.x + s.linear_velocity.y + s.linear_velocity.z +
                       s.angular_velocity.x + s.angular_velocity.y + s.angular_velocity.z;
    return std::isfinite(sum);
}

template <class F> void for_each_finite(const Scene& scene, std::span<const BodyState> states, F&& f) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].motion == Motion::dynamic && is_finite(states[i])) f(scene.bodies[i], states[i]);
}

} // namespace

Penetrations measure_penetrations(const Scene& scene, std::span<const BodyState> states) {
    struct BodyPart : PlacedPart {
        std::size_t body;
    };
    if (!scene.collides) return {};
    std::set<std::pair<std::size_t, std::size_t>> joined;
    for (const SceneJoint& joint : scene.joints) joined.insert(std::minmax(joint.body_a, joint.body_b));
    std::vector<BodyPart> dynamic, others;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!is_finite(states[i])) continue;
        const SceneBody& body = scene.bodies[i];
        for (std::size_t k = 0; k < body.part_count; ++k)
            (body.motion == Motion::dynamic ? dynamic : others)
                .push_back({place(scene, scene.parts[body.first_part + k], states[i]), i});
    }
    std::vector<double> depths;
    const auto test = [&](const BodyPart& a, const BodyPart& b) {
        if (a.body == b.body) return;
        const double reach = a.bounding_radius + b.bounding_radius;
        const Vector offset = a.center - b.center;
        if (glm::dot(offset, offset) > reach * reach) return;
        if (!joined.empty() && joined.count(std::minmax(a.body, b.body)) > 0) return;
        const double depth = penetration(a, b);
        if (depth > 0) depths.push_back(depth);
    };
    for (const BodyPart& a : dynamic)
        for (const BodyPart& b : others) test(a, b);
    // Pairs of dynamic bodies: sort and sweep along x.
    std::sort(dynamic.begin(), dynamic.end(), [](const BodyPart& a, const BodyPart& b) {
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

JointErrors measure_joint_errors(const Scene& scene, std::span<const BodyState> states) {
    const auto anchor = [&](std::size_t body, const Vec3& local) {
        return states[body].position + rotate(states[body].rotation, Vector(local));
    };
    JointErrors errors;
    double sum = 0;
    std::size_t count = 0;
    for (const SceneJoint& joint : scene.joints) {
        if (!is_finite(states[joint.body_a]) || !is_finite(states[joint.body_b])) continue;
        const double distance =
            glm::length(anchor(joint.body_a, joint.anchor_a) - anchor(joint.body_b, joint.anchor_b));
        errors.greatest = std::max(errors.greatest, distance);
        sum += distance;
        ++count;
    }
    if (count > 0) errors.mean = sum / static_cast<double>(count);
    return errors;
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
        const Vector w = rotate(conjugate(state.rotation), Vector(state.angular_velocity));
        energy += 0.5 * (double(body.mass) * glm::dot(v, v) + glm::dot(w, glm::dmat3(body.inertia) * w));
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
