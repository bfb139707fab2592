// The paths of properties: `crate.position.x`, `'Body 1'.friction`, `bodies[3].shapes[0].restitution`, `door.lower`,
// `car.steering.motor_position`, `world.gravity.y`, `crate.touches.floor`.
#pragma once

#include "sweep/properties.h"

#include <string>

namespace cairn::sweep {

// One component of a property.
struct Address {
    const Property* property = nullptr;
    Subject subject;
    std::size_t component = 0;

    double read(const Trial& trial) const {
        double numbers[4];
        property->read(trial, subject, numbers);
        return numbers[component];
    }
};

// Looks a path up in a world. Throws Error (invalid_value) whose field is the path, for an unknown name (listing the
// known ones), a name that several bodies or joints have, or a vector without a component.
Address find_address(const World& world, const std::string& path);

} // namespace cairn::sweep
