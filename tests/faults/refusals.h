/// \file refusals.h
/// Calls with bad arguments, each with the expected error, and a world for these calls.
#pragma once

#include "../api/test_world.h"

#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace cairn::test {

/// A world in which something of every kind exists and is in motion.
struct Stage {
    World world;
    BodyId ground, crate, platform;
    ShapeId crate_shape;
    ForceFieldId wind;

    Stage() {
        ground = add_ground(world);
        crate = world.create_body(body_at({0.0, 0.5, 0.0}));
        crate_shape = world.add_shape(crate, Box{});
        platform = add_body(world, body_at({5.0, 1.0, 0.0}, BodyType::kinematic), Box{});
        add_body(world, body_at({0.1, 1.6, 0.0}), Sphere{});
        wind = world.add_force_field({});
        run(world, 10);
    }
    Body crate_body() { return world.body(crate); }
};

struct Refusal {
    int row; // of the list of faults
    const char* name;
    std::function<void(Stage&)> call;
    ErrorCode code;
    std::string field, value, expected;
};

inline std::ostream& operator<<(std::ostream& out, const Refusal& refusal) { return out << refusal.name; }

inline const double nan_double = not_a_number, infinite_double = infinity;
inline const std::string must_be_near = "must be finite and within 1e15 m of the origin";
inline const std::string must_be_finite = "must be finite";
inline const std::string must_not_be_zero = "must not be zero";
inline const std::string must_be_a_size = "must be a size in meters from 1e-6 to 1e9";
inline const std::string must_be_a_mass = "must be a mass in kg from 1e-32 to 1e32, or infinite";
inline const std::string must_be_at_least_0 = "must be finite and >= 0";
inline const std::string must_be_above_0 = "must be finite and > 0";
inline const std::string must_be_a_moment = "must be finite and >= 0 (0: does not turn about that axis)";
inline const std::string must_be_real =
    "must satisfy the triangle inequality: no moment may exceed the sum of the other two";

inline Refusal row(int number, const char* name, std::function<void(Stage&)> call, std::string field, std::string value,
                   std::string expected) {
    return {number,
            name,
            std::move(call),
            ErrorCode::invalid_value,
            std::move(field),
            std::move(value),
            std::move(expected)};
}

template <class Member, class Value> std::function<void(Stage&)> make_body(Member BodyDef::*member, Value value) {
    return [member, value](Stage& stage) {
        BodyDef def;
        def.*member = value;
        stage.world.create_body(def);
    };
}

template <class Member, class Value> std::function<void(Stage&)> make_world(Member WorldDef::*member, Value value) {
    return [member, value](Stage&) {
        WorldDef def;
        def.*member = value;
        World world(def);
    };
}

template <class Member, class Value>
std::function<void(Stage&)> change_settings(Member WorldDef::*member, Value value) {
    return [member, value](Stage& stage) {
        WorldDef def = stage.world.settings();
        def.*member = value;
        stage.world.set_settings(def);
    };
}

template <class Member, class Value> std::function<void(Stage&)> make_shape(Member ShapeDef::*member, Value value) {
    return [member, value](Stage& stage) {
        ShapeDef def;
        def.*member = value;
        stage.world.add_shape(stage.crate, Box{}, def);
    };
}

template <class Value> std::function<void(Stage&)> make_material(float Material::*member, Value value) {
    return [member, value](Stage& stage) {
        ShapeDef def;
        def.material.*member = value;
        stage.world.add_shape(stage.crate, Box{}, def);
    };
}

template <class Value> std::function<void(Stage&)> change_material(float Material::*member, Value value) {
    return [member, value](Stage& stage) {
        Material material;
        material.*member = value;
        stage.world.set_material(stage.crate_shape, material);
    };
}

template <class Member, class Value> std::function<void(Stage&)> change_field(Member ForceField::*member, Value value) {
    return [member, value](Stage& stage) {
        ForceField field;
        field.kind = ForceField::Kind::radial;
        field.*member = value;
        stage.world.set_force_field(stage.wind, field);
    };
}

inline std::function<void(Stage&)> add(const Shape& shape) {
    return [shape](Stage& stage) { stage.world.add_shape(stage.crate, shape); };
}
inline std::function<void(Stage&)> add_to_ground(const Shape& shape) {
    return [shape](Stage& stage) { stage.world.add_shape(stage.ground, shape); };
}
inline std::function<void(Stage&)> overlap_with(const Shape& shape) {
    return [shape](Stage& stage) { stage.world.overlap(shape, {}); };
}
inline std::function<void(Stage&)> step_by(float dt) {
    return [dt](Stage& stage) { stage.world.step(dt); };
}

inline std::function<void(Stage&)> give_mass(float mass) {
    return [mass](Stage& stage) { stage.crate_body().set_mass_from_shapes(mass); };
}
inline std::function<void(Stage&)> give_inertia(const Vec3& moments) {
    return [moments](Stage& stage) {
        MassProperties properties;
        properties.inertia_diagonal = moments;
        stage.crate_body().set_mass_properties(properties);
    };
}
template <class Member, class Value>
std::function<void(Stage&)> make_with_properties(Member MassProperties::*member, Value value) {
    return [member, value](Stage& stage) {
        BodyDef def;
        def.mass_properties.emplace();
        (*def.mass_properties).*member = value;
        stage.world.create_body(def);
    };
}

inline std::function<void(Stage&)> on_crate(std::function<void(Body)> call) {
    return [call](Stage& stage) { call(stage.crate_body()); };
}
inline std::function<void(Stage&)> in_world(std::function<void(World&)> call) {
    return [call](Stage& stage) { call(stage.world); };
}
inline std::function<void(Stage&)> move_platform(const Transform& target, float seconds) {
    return [=](Stage& stage) { stage.world.body(stage.platform).move_to(target, seconds); };
}

inline const Position nan_position(0.0, nan_double, 0.0);
inline const Position infinite_position(infinite_double, 0.0, 0.0), far_position(0.0, 0.0, -1.1e15);
inline const Vec3 nan_vector(not_a_number, 0.0f, 0.0f), infinite_vector(0.0f, infinity, 0.0f);
inline const Quat zero_rotation(0.0f, 0.0f, 0.0f, 0.0f), nan_rotation(1.0f, 0.0f, not_a_number, 0.0f);
inline const Quat infinite_rotation(infinity, 0.0f, 0.0f, 0.0f);
inline const std::string nan_text = "(0, nan, 0)", infinite_text = "(inf, 0, 0)", far_text = "(0, 0, -1.1e+15)";
inline const std::string nan_vector_text = "(nan, 0, 0)", infinite_vector_text = "(0, inf, 0)";
inline const std::string zero_rotation_text = "(w 0, x 0, y 0, z 0)", nan_rotation_text = "(w 1, x 0, y nan, z 0)";

// refusals_of_bodies.cpp
std::vector<Refusal> positions();
std::vector<Refusal> velocities_and_rotations();
std::vector<Refusal> masses();
std::vector<Refusal> wrong_states(); ///< Calls that a body of another type would allow.

// refusals_of_worlds.cpp
std::vector<Refusal> shapes();
std::vector<Refusal> materials();
std::vector<Refusal> settings_and_steps();

} // namespace cairn::test
