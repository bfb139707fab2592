
#include "bodies/bodies.h"

#include <algorithm>

#include <limits>

namespace cairn {

using math::DVec3;

namespace {

// A principal moment below this share of the largest is a rounding error (or a needle no engine can spin).
constexpr double min_moment_ratio = 1e-9;

math::DQuat mass_axes(const BodyMotion& motion, const BodyMass& mass) {
    return math::normalized(motion.q * math::to_double(mass.principal));
}

bool is_isotropic(math::Vec3 moments) {
    const float largest = std::max({moments.x, moments.y, moments.z});
    const float smallest = std::min({moments.x, moments.y, moments.z});
    return largest - smallest <= 1e-6f * largest;
}

// Moves the center of mass within the body; the origin and the material's velocity there stay.
void move_center(Bodies& bodies, std::int32_t body, math::Vec3 center) {
    BodyMotion& motion = bodies.motion[body];
    BodyMass& mass = bodies.mass[body];
    const DVec3 shift = math::rotate(motion.q, math::to_double(center - mass.center));
    motion.x += shift;
    motion.v += math::cross(motion.w, math::to_float(shift));
    mass.center = center;
}

// Returns 0 for masses and moments that forces cannot move. Capped, so that the products in the solver stay finite for
// bodies of tiny mass.
float reciprocal(float x) { return x > 0 && std::isfinite(x) ? std::min(1.0f / x, 1e35f) : 0.0f; }

} // namespace

void set_mass(Bodies& bodies, Joints& joints, std::int32_t body, const MassProperties& properties) {
    BodyMass& mass = bodies.mass[body];
    move_center(bodies, body, {properties.center_of_mass.x, properties.center_of_mass.y, properties.center_of_mass.z});
    const auto& p = properties.inertia_diagonal;
    const auto& q = properties.inertia_orientation;
    mass.mass = properties.mass;
    mass.inertia = {p.x, p.y, p.z};
    mass.principal = math::normalized(math::Quat{q.x, q.y, q.z, q.w});
    const bool dynamic = bodies.settings[body].own_type == BodyType::dynamic;
    mass.inverse_mass = dynamic ? reciprocal(mass.mass) : 0;
    mass.inverse_inertia = dynamic ? math::Vec3{reciprocal(p.x), reciprocal(p.y), reciprocal(p.z)} : math::Vec3{};
    if (bodies.links[body].first_joint != none) ++joints.changes;
    mass.isotropic = is_isotropic(mass.inertia) || mass.inverse_inertia == math::Vec3{};
}

void refresh_mass(Bodies& bodies, const Shapes& shapes, Joints& joints, std::int32_t body) {
    BodyMass& mass = bodies.mass[body];
    if (!mass.follows_shapes) {
        set_mass(bodies, joints, body,
                 {mass.mass,
                  {mass.center.x, mass.center.y, mass.center.z},
                  {mass.inertia.x, mass.inertia.y, mass.inertia.z},
                  {mass.principal.w, mass.principal.x, mass.principal.y, mass.principal.z}});
        return;
    }
    MassSum sum;
    for (std::int32_t s = bodies.links[body].first_shape; s != none; s = shapes.links[s].next)
        sum = combine(sum, geometry_mass(shapes.geometry[s], shapes.data[s], shapes.links[s].density));
    const float given_mass = bodies.settings[body].given_mass;
    // Without any shape that has mass, a body is a point of its given mass, or of one kilogram, that does not turn.
    MassProperties properties;
    properties.inertia_diagonal = {0, 0, 0};
    properties.mass = mass.has_given_mass ? given_mass : 1.0f;
    if (sum.mass > 0) {
        const double scale = mass.has_given_mass ? double(given_mass) / sum.mass : 1.0;
        const PrincipalInertia principal = diagonalize(sum.inertia);
        DVec3 moments = scale * principal.moments;
        const double largest = std::max({moments.x, moments.y, moments.z});
        for (int i = 0; i < 3; ++i) moments[i] = std::max(moments[i], min_moment_ratio * largest);
        const math::Quat axes = math::to_float(principal.axes);
        properties.mass = float(scale * sum.mass);
        // A kinematic body rotates about its origin, as its mass does not take part in its motion.
        if (bodies.settings[body].own_type != BodyType::kinematic)
            properties.center_of_mass = {float(sum.center.x), float(sum.center.y), float(sum.center.z)};
        properties.inertia_diagonal = {float(moments.x), float(moments.y), float(moments.z)};
        properties.inertia_orientation = {axes.w, axes.x, axes.y, axes.z};
    }
    set_mass(bodies, joints, body, properties);
}

void place_shapes(Bodies& bodies, Shapes& shapes, std::int32_t body) {
    float radius = 0, inner_radius = std::numeric_limits<float>::infinity();
    const math::Quat q = math::to_float(bodies.motion[body].q);
    place_each_shape(bodies, shapes, body, [&](std::uint32_t s) {
        const Geometry& geometry = shapes.geometry[s];
        const math::Vec3 in_body = math::rotate(geometry.rotation, geometry.middle);
        const math::Vec3 middle = shapes.links[s].arm + math::rotate(q, in_body);
        size_shape(shapes.poses[s], geometry, std::size_t(s));
        inner_radius = std::min(inner_radius, 0.5f * smallest_extent(geometry, shapes.data[s]));
        radius = std::max(radius, math::length(middle) + geometry.bounding_radius);
    });
    bodies.links[body].radius = radius;
    bodies.links[body].inner_radius = inner_radius;
}

DVec3 body_origin(const Bodies& bodies, std::int32_t body) {
    const BodyMotion& motion = bodies.motion[body];
    return motion.x - math::rotate(motion.q, math::to_double(bodies.mass[body].center));
}

void set_pose(Bodies& bodies, std::int32_t body, DVec3 origin, math::DQuat rotation) {
    BodyMotion& motion = bodies.motion[body];
    motion.q = math::normalized(rotation);
    motion.x = origin + math::rotate(motion.q, math::to_double(bodies.mass[body].center));
}

math::Sym3 world_inverse_inertia(const BodyMotion& motion, const BodyMass& mass) {
    const math::Vec3 d = mass.inverse_inertia;
    if (mass.isotropic) return {d.x, 0, 0, d.x, 0, d.x};
    return math::rotated_diagonal(math::to_matrix(math::to_float(motion.q) * mass.principal), d);
}

math::DSym3 world_inertia(const BodyMotion& motion, const BodyMass& mass) {
    return math::rotated_diagonal(math::to_matrix(mass_axes(motion, mass)), math::to_double(mass.inertia));
}

double kinetic_energy(const Bodies& bodies, std::int32_t body) {
    if (!bodies.is_dynamic(body)) return 0;
    const BodyMotion& motion = bodies.motion[body];
    const BodyMass& mass = bodies.mass[body];
    const DVec3 v = math::to_double(motion.v), w = math::to_double(motion.w);
    const double linear = mass.inverse_mass > 0 ? double(mass.mass) * math::dot(v, v) : 0.0;
    const double angular = mass.inverse_inertia == math::Vec3{} ? 0.0 : math::dot(w, world_inertia(motion, mass) * w);
    return 0.5 * (linear + angular);
}

bool cut_velocity(const WorldDef& settings, math::Vec3& v, math::Vec3& w) {
    auto clamp = [](math::Vec3& u, float most) {
        const DVec3 d = math::to_double(u);
        const double square = math::dot(d, d);
        if (square <= double(most) * double(most)) return false;
        u = std::isfinite(square) ? math::to_float((double(most) / std::sqrt(square)) * d) : math::Vec3{};
        return true;
    };
    const bool linear = clamp(v, settings.max_linear_speed);
    const bool angular = clamp(w, settings.max_angular_speed);
    return linear || angular;
}

} // namespace cairn
