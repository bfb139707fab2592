/// \file inspect.h
/// The data of one body, copied from its world, and the edits that can be made to it.
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
    Position position{0.0, 0.0, 0.0}, center{0.0, 0.0, 0.0}; ///< Origin of the body's frame; center of mass.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    bool is_enabled = true;
    bool is_trigger = false;       ///< All shapes of the body are triggers.
    bool can_be_stretched = false; ///< The body can be scaled along one axis alone.
    Vec3 velocity{0.0f, 0.0f, 0.0f},
        angular_velocity{0.0f, 0.0f, 0.0f}; ///< Linear and angular velocity, m/s and rad/s.
    /// J; potential energy relative to the origin.
    double linear_energy = 0.0, angular_energy = 0.0, potential_energy = 0.0;
    bool is_awake = false;
    std::vector<ShapeFacts> shapes;
    struct Touch {
        BodyId other;
        std::string name;
        int points = 0;
        float normal_force = 0.0f, friction_force = 0.0f; ///< N, means over the last step.
    };
    std::vector<Touch> touches; ///< One entry for each touching body.
};

/// Empty if there is no such body.
std::optional<BodyFacts> read_facts(const World& world, BodyId body, double step_length);

/// Whether forces can accelerate the body: it is dynamic, of finite mass, and enabled.
bool can_be_pushed(const Body& body);

/// Measured friction coefficients between two bodies of the same named material.
struct MaterialPreset {
    const char* name;
    float static_friction, dynamic_friction;
};
std::span<const MaterialPreset> material_presets();
/// The source of the presets' numbers.
const char* material_source();
/// The material with the friction of a preset; other properties stay.
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
    Position position{0.0, 0.0, 0.0}; ///< The body's velocities become zero.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
};
struct Scale {
    Vec3 factors{1.0f, 1.0f, 1.0f}; ///< Along the axes of the body (scaling.h).
};
struct Velocity {
    Vec3 velocity{0.0f, 0.0f, 0.0f};
};
struct Turning {
    Vec3 angular_velocity{0.0f, 0.0f, 0.0f};
};
struct Surface {
    Material material;                 ///< For all shapes of the body ...
    bool also_what_it_touches = false; ///< ... and those of touching bodies.
};

struct Trigger {
    bool on = true; ///< All shapes of the body become triggers: they collide with nothing and report overlaps.
};
struct Enabled {
    bool on = true;
};

} // namespace edit

using BodyEdit = std::variant<edit::Name, edit::Type, edit::Mass, edit::Place, edit::Pose, edit::Scale, edit::Velocity,
                              edit::Turning, edit::Surface, edit::Trigger, edit::Enabled>;
const char* name_of(const BodyEdit& edit); ///< Its name in the undo history.
/// Throws as the calls of `Body` do.
void carry_out(World& world, BodyId body, const BodyEdit& edit);

/// Copies a body with its shapes, displaced by `shift`; `copies` receives the new shape ids in the order of the
/// originals.
BodyId duplicate(World& world, BodyId body, const Position& shift, std::vector<ShapeId>& copies);

} // namespace cairn::viewer
