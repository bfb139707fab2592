/// \file test_world.h
/// Small worlds for the tests of the public API, and conditions that must hold in any world after any step.
#pragma once

#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace cairn::test {

inline constexpr float frame = 1.0f / 60.0f; ///< s
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr double pi = 3.14159265358979323846;

/// World settings without gravity.
inline WorldDef weightless() {
    WorldDef def;
    def.gravity = {0.0f, 0.0f, 0.0f};
    return def;
}

inline BodyDef body_at(const Position& position, BodyType type = BodyType::dynamic) {
    BodyDef def;
    def.type = type;
    def.position = position;
    return def;
}

inline ShapeDef with_density(float density) {
    ShapeDef def;
    def.density = density;
    return def;
}

inline ShapeDef with_material(const Material& material) {
    ShapeDef def;
    def.material = material;
    return def;
}

inline ShapeDef shape_at(const Vec3& position) {
    ShapeDef def;
    def.position = position;
    return def;
}

inline BodyId add_body(World& world, const BodyDef& body, const Shape& shape, const ShapeDef& def = {}) {
    const BodyId id = world.create_body(body);
    world.add_shape(id, shape, def);
    return id;
}

/// An infinite plane, facing up, through the origin.
inline BodyId add_ground(World& world, const Material& material = {}) {
    return add_body(world, body_at({0.0, 0.0, 0.0}, BodyType::static_), Plane{}, with_material(material));
}

/// A cube of one meter.
inline BodyId add_crate(World& world, const Position& position, const Material& material = {}) {
    return add_body(world, body_at(position), Box{}, with_material(material));
}

inline void run(World& world, int steps, float dt = frame) {
    for (int i = 0; i < steps; ++i) world.step(dt);
}

inline bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline bool is_finite(const Position& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Kinetic plus potential energy, J.
inline double mechanical_energy(const World& world) { return world.kinetic_energy() + world.potential_energy(); }

/// Checks that all readable state of every body is finite, that rotations are unit quaternions, and that no speed
/// exceeds the world's limits.
inline testing::AssertionResult is_sane(const World& world) {
    const WorldDef& settings = world.settings();
    for (const BodyId id : world.bodies()) {
        const Body body = world.body(id);
        const auto failed = [&](const char* what) {
            return testing::AssertionFailure()
                   << "body " << id.index() << ": " << what << " after " << world.step_count() << " steps";
        };
        if (!is_finite(body.position())) return failed("position not finite");
        if (!is_finite(body.linear_velocity())) return failed("velocity not finite");
        if (!is_finite(body.angular_velocity())) return failed("angular velocity not finite");
        const Quat q = body.rotation();
        const double square = double(q.w) * q.w + double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z;
        if (!(std::fabs(square - 1) < 1e-5)) return failed("rotation not a unit quaternion");
        constexpr float rounding = 1 + 1e-5f;
        if (!(glm::length(body.linear_velocity()) <= settings.max_linear_speed * rounding)) return failed("too fast");
        if (!(glm::length(body.angular_velocity()) <= settings.max_angular_speed * rounding))
            return failed("turns too fast");
    }
    for (const Contact& contact : world.contacts()) {
        const auto failed = [&](const char* what) { return testing::AssertionFailure() << "contact: " << what; };
        if (!(std::fabs(glm::length(contact.normal) - 1) < 1e-4f)) return failed("normal not of unit length");
        if (!is_finite(contact.friction_impulse)) return failed("friction not finite");
        if (contact.point_count < 1 || contact.point_count > 4) return failed("number of points");
        for (int i = 0; i < contact.point_count; ++i) {
            const ContactPoint& point = contact.points[i];
            if (!is_finite(point.point) || !std::isfinite(point.separation)) return failed("point not finite");
            if (!(point.normal_impulse >= 0) || !std::isfinite(point.normal_impulse))
                return failed("impulse negative or not finite");
        }
    }
    return testing::AssertionSuccess();
}

/// Steps the world, and stops at the first step after which it is not sane.
inline testing::AssertionResult stays_sane(World& world, int steps, float dt = frame) {
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
        if (const auto result = is_sane(world); !result) return result;
    }
    return testing::AssertionSuccess();
}

/// The error that `call` threw, as `code | field | message`; empty if it threw nothing.
template <class Call> std::string refusal(Call&& call) {
    static const char* const codes[] = {"invalid_value", "invalid_handle", "wrong_state",
                                        "invalid_file",  "unsupported",    "io"};
    try {
        call();
    } catch (const Error& error) {
        return std::string(codes[int(error.code())]) + " | " + error.field() + " | " + error.what();
    }
    return {};
}

} // namespace cairn::test
