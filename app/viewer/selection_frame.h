/// \file selection_frame.h
/// A rectangle in the picture that selects the bodies in it.
#pragma once

#include "viewer/camera.h"
#include "viewer/world_state.h"

#include <glm/vec2.hpp>

#include <vector>

namespace cairn::viewer {

/// Normalized device coordinates: -1 to 1 in the picture, upwards.
struct SelectionFrame {
    glm::vec2 low{0.0f, 0.0f}, high{0.0f, 0.0f};

    /// Between two opposite corners, in whichever order.
    static SelectionFrame between(const glm::vec2& a, const glm::vec2& b);
    bool contains(const glm::vec2& point) const;
};

/// The bodies that appear in a frame with all of their shapes, also where others hide them, in the layout's order; a
/// body without shapes by its origin. What has no end, as planes, is in no frame.
std::vector<BodyId> bodies_within(const SelectionFrame& frame, const WorldLayout& layout, const WorldMotion& motion,
                                  const OrbitCamera& camera, float aspect);

} // namespace cairn::viewer
