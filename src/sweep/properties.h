// The properties that a sweep can set and measure, by name: `crate.friction`, `door.lower`, `world.gravity.y`.
#pragma once

#include <cairn/cairn.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cairn::sweep {

// A world that is being prepared or simulated, and its time step.
struct Trial {
    World world;
    double time_step = 1.0 / 60.0; // s
};

// The subject of a property. If all handles are null it is the world.
struct Subject {
    BodyId body{}, other{}; // `other`: the second body of `touches`
    ShapeId shape{};        // null: all shapes of the body
    JointId joint{};
    std::size_t axis = 0; // of the joint, in the order of `JointState::positions`
};

// Collects the changes of a joint, and applies them when the subject changes to another joint, so that its limits may
// temporarily be in the wrong order.
class Changes {
  public:
    explicit Changes(Trial& trial) : trial(trial) {}
    Joint& joint_of(JointId id);
    void finish();

    Trial& trial;

  private:
    JointId id_{};
    Joint joint_{};
};

// A property of one or several numbers. Its functions throw the errors of the engine's calls.
struct Property {
    std::string_view name;
    std::string_view components; // names of the components, a letter each; empty: a single number
    void (*read)(const Trial&, const Subject&, double*) = nullptr;    // null: can be set only
    void (*write)(Changes&, const Subject&, const double*) = nullptr; // null: can be measured only
    std::size_t count() const { return components.empty() ? 1 : components.size(); }
};

std::span<const Property> world_properties();
std::span<const Property> body_properties();
std::span<const Property> shape_properties(); // also available for bodies, where they apply to all shapes
std::span<const Property> joint_properties(); // also available for axes

// Returns the limits and motor of that axis of a joint; null if it cannot have any.
JointControl* control_of(Joint& joint, std::size_t axis);
// Returns the axis of that name ("steering" of a wheel); nothing if there is none.
std::optional<std::size_t> axis_of(const Joint& joint, std::string_view name);

} // namespace cairn::sweep
