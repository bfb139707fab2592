/// \file gizmo.h
/// Handles around the selected body for moving, rotating and scaling it with the mouse.
#pragma once

#include "viewer/camera.h"
#include "viewer/inspect.h"
#include "viewer/render_frame.h"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace cairn::viewer {

enum class GizmoMode { none, move, turn, scale };
inline constexpr int gizmo_mode_count = 4;
const char* name_of(GizmoMode mode);

/// A handle: for one of the three axes, or for all.
enum class GizmoHandle { x, y, z, all };

class Gizmo {
  public:
    GizmoMode mode = GizmoMode::none;

    /// The handles that exist for a body.
    std::vector<GizmoHandle> handles(const BodyFacts& facts) const;
    /// A point of a handle at which it can be grabbed.
    Position grip(const BodyFacts& facts, const OrbitCamera& camera, GizmoHandle handle) const;
    /// The handle under the cursor, which is in normalized device coordinates.
    std::optional<GizmoHandle> handle_at(const BodyFacts& facts, const OrbitCamera& camera, const glm::vec2& cursor,
                                         float aspect) const;
    void draw(RenderFrame& frame, const BodyFacts& facts, const OrbitCamera& camera) const;

    void begin(const BodyFacts& facts, const OrbitCamera& camera, GizmoHandle handle, const glm::vec2& cursor,
               float aspect);
    bool is_dragged() const { return start_.has_value(); }
    /// The edit of the body for that cursor position; empty if it stays unchanged.
    std::optional<BodyEdit> drag(const OrbitCamera& camera, const glm::vec2& cursor, float aspect);
    void end() { start_.reset(); }

  private:
    struct Start {
        GizmoHandle handle = GizmoHandle::x;
        Position center{0.0, 0.0, 0.0};
        Transform pose;
        Vec3 axis{1.0f, 0.0f, 0.0f}; // unit, in the world
        double along = 0.0;          // position on the axis at which the handle was grabbed, m
        Vec3 arm{1.0f, 0.0f, 0.0f};  // from the center to the point at which the ring was grabbed
        glm::vec2 cursor{0.0f, 0.0f};
        Vec3 scaled{1.0f, 1.0f, 1.0f}; // scale factors applied so far
    };
    Vec3 axis(const BodyFacts& facts, GizmoHandle handle) const;

    std::optional<Start> start_;
};

} // namespace cairn::viewer
