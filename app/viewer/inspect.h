/// \file inspect.h
/// All about one body, copied out of its world, and what can be changed of it.
#pragma once

#include <cairn/world.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cairn::viewer {

struct ShapeFacts {
    ShapeId id;
    const char* kind = "";
    Material material;
    float density = 0.0f; ///< kg/m^3
};

struct BodyFacts {
    BodyId id;
    std::string name;
    BodyType type = BodyType::dynamic;
    MassProperties mass;
    Position position{0.0, 0.0, 0.0}, center{0.0, 0.0, 0.0}; ///< Of its frame, of its mass.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    bool is_enabled = true;
    bool is_trigger = false;                                                  ///< All its shapes are.
    bool can_be_stretched = false;                                            ///< Scaled along one axis alone.
    Vec3 velocity{0.0f, 0.0f, 0.0f}, turning{0.0f, 0.0f, 0.0f};               ///< m/s, rad/s
    double linear_energy = 0.0, angular_energy = 0.0, potential_energy = 0.0; ///< J; the last above the origin.
    bool is_awake = false;
    std::vector<ShapeFacts> shapes;
    struct Touch {
        BodyId other;
        std::string name;
        int points = 0;
        float normal_force = 0.0f, friction_force = 0.0f; ///< N, means over the last step.
    };
    std::vector<Touch> touches; ///< One for each body that it touches.
};

/// Nothing if there is no such body.
std::optional<BodyFacts> read_facts(const World& world, BodyId body, double step_length);

/// Whether forces move it: dynamic, of finite mass, and enabled.
bool can_be_pushed(const Body& body);

/// Surfaces of which somebody has measured the friction: that between two bodies that both have it.
struct MaterialPreset {
    const char* name;
    float static_friction, dynamic_friction;
};
std::span<const MaterialPreset> material_presets();
/// Where their numbers are from.
const char* material_source();
/// The material with the friction of a preset; the rest of it stays.
Material with_preset(Material material, const MaterialPreset& preset);

namespace edit {

struct Name {
    std::string name;
};
struct Type {
    BodyType type = BodyType::dynamic;
};
struct Mass {
    float mass = 1.0f; ///< kg, > 0; the moments of inertia follow.
};
struct Place {
    Position position{0.0, 0.0, 0.0};
};
struct Pose {
    Position position{0.0, 0.0, 0.0}; ///< It comes to rest there.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
};
struct Scale {
    Vec3 factors{1.0f, 1.0f, 1.0f}; ///< Along the axes of the body (scaling.h).
};
struct Velocity {
    Vec3 velocity{0.0f, 0.0f, 0.0f};
};
struct Turning {
    Vec3 turning{0.0f, 0.0f, 0.0f};
};
struct Surface {
    Material material;                 ///< For all its shapes ...
    bool also_what_it_touches = false; ///< ... and those of the bodies that it touches.
};

struct Trigger {
    bool on = true; ///< All its shapes touch nothing, and report what comes in.
};
struct Enabled {
    bool on = true;
};

} // namespace edit

using BodyEdit = std::variant<edit::Name, edit::Type, edit::Mass, edit::Place, edit::Pose, edit::Scale, edit::Velocity,
                              edit::Turning, edit::Surface, edit::Trigger, edit::Enabled>;
const char* name_of(const BodyEdit& edit); ///< For undoing it.
/// Throws as the calls of `Body` do.
void carry_out(World& world, BodyId body, const BodyEdit& edit);

/// A copy of a body, `shift` away, with its shapes; their ids are in `copies`, in the order of the original's.
BodyId duplicate(World& world, BodyId body, const Position& shift, std::vector<ShapeId>& copies);

} // namespace cairn::viewer
