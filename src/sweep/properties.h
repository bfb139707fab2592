// What a sweep can set and measure, by name: `crate.friction`, `door.lower`, `world.gravity.y`.
#pragma once

#include <cairn/cairn.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cairn::sweep {

// A world that is being prepared or run, and the step that it is run by.
struct Trial {
    World world;
    double time_step = 1.0 / 60.0; // s
};

// What a property is of. Null handles stand for the world.
struct Subject {
    BodyId body{}, other{}; // `other`: which body `touches` asks about
    ShapeId shape{};        // null: all shapes of the body
    JointId joint{};
    std::size_t axis = 0; // of the joint, as in `JointState::positions`
};

// Changes of joints are collected, so that limits may pass each other on the way, and made when another joint follows.
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

// One or several numbers. Errors are those of the engine's calls.
struct Property {
    std::string_view name;
    std::string_view components; // names of them, a letter each; none: a single number
    void (*read)(const Trial&, const Subject&, double*) = nullptr;    // null: can be set only
    void (*write)(Changes&, const Subject&, const double*) = nullptr; // null: can be measured only
    std::size_t count() const { return components.empty() ? 1 : components.size(); }
};

std::span<const Property> world_properties();
std::span<const Property> body_properties();
std::span<const Property> shape_properties(); // also of bodies, for all their shapes
std::span<const Property> joint_properties(); // of an axis, too

// What acts along that axis of a joint; null: nothing can.
JointControl* control_of(Joint& joint, std::size_t axis);
// The axis of that name ("steering" of a wheel); empty: there is none.
std::optional<std::size_t> axis_of(const Joint& joint, std::string_view name);

} // namespace cairn::sweep
