/// \file selection_frame.h
/// A rectangle in the view for selecting the bodies in it.
#pragma once

#include "viewer/camera.h"
#include "viewer/world_state.h"

#include <glm/vec2.hpp>

#include <vector>

namespace cairn::viewer {

/// Normalized device coordinates: -1 to 1 in the view, y up.
struct SelectionFrame {
    glm::vec2 low{0.0f, 0.0f}, high{0.0f, 0.0f};

    /// The rectangle between two opposite corners, in any order.
    static SelectionFrame between(const glm::vec2& a, const glm::vec2& b);
    bool contains(const glm::vec2& point) const;
};

/// The bodies of which all shapes project into the rectangle, also where hidden by others, in the layout's order; a
/// body without shapes is represented by its origin. Infinite shapes, such as planes, are in no rectangle.
std::vector<BodyId> bodies_within(const SelectionFrame& frame, const WorldLayout& layout, const WorldMotion& motion,
                                  const OrbitCamera& camera, float aspect);

} // namespace cairn::viewer
