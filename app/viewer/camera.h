/// \file camera.h
/// The orbit camera: it looks at a target from a distance. Positions are double, for accuracy far from the world
/// origin; graphics data is relative to an origin near the target.
#pragma once

#include <cairn/math.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// The position of a camera and the point that it looks at.
struct CameraPose {
    Position position{9.0, 6.0, 12.0}; ///< Meters.
    Position target{0.0, 1.0, 0.0};    ///< Meters.
    /// Vertical field of view in radians, between 0 and pi, of a picture of 16:9 or wider.
    float vertical_fov = 0.785398f;
    /// Orthographic projection: everything appears as large as at the distance of the target, and objects behind the
    /// camera are visible too.
    bool is_parallel = false;
};

/// The factor by which a camera with a 45-degree field of view would be nearer to show as much: 1 at 45 degrees or
/// more, less for a longer lens. Sizes that scale with the camera's distance scale with its product with this factor.
float lens_of(const CameraPose& camera);

/// A half-line through the world. `direction` has unit length.
struct Ray {
    Position origin{0.0, 0.0, 0.0};
    Vec3 direction{0.0f, 0.0f, -1.0f};
};

/// A plane that the camera stays above.
struct Ground {
    Position point{0.0, 0.0, 0.0}; ///< A point of the plane.
    Vec3 normal{0.0f, 1.0f, 0.0f}; ///< Unit normal, pointing up (y > 0).
};

class OrbitCamera {
  public:
    explicit OrbitCamera(const CameraPose& pose = {}) { set_pose(pose); }

    /// Adopts a pose. A position equal to the target is moved back to the minimum distance.
    void set_pose(const CameraPose& pose);
    CameraPose pose() const;

    /// Limits later movements by these planes: the eye slides along them, slightly above, and the target stays out of
    /// them. `set_pose` ignores them.
    void set_grounds(std::vector<Ground> grounds) { grounds_ = std::move(grounds); }

    /// Orbits about the target, radians: positive `yaw` moves the camera to its right, positive `pitch` upward. The
    /// camera stops short of the poles.
    void orbit(float yaw, float pitch);
    /// Moves closer (positive) or away; one notch changes the distance by a tenth.
    void zoom(float notches);
    /// Shifts the target sideways and up, in units of the view height; `aspect` is width over height.
    void pan(float right, float up, float aspect);
    /// Sets the view direction, by the same angles as `orbit`.
    void look(float yaw, float pitch);
    /// Moves the target, and the camera with it.
    void follow(const Position& target);
    /// See `CameraPose::is_parallel`. Objects at the distance of the target keep their size.
    void set_parallel(bool on);
    bool is_parallel() const noexcept { return is_parallel_; }
    /// Frames a sphere from the present direction, so that it fills about half of the view.
    void frame(const Position& center, float radius);

    Vec3 forward() const;
    Vec3 right() const;
    Vec3 up() const;
    Position position() const;
    const Position& target() const noexcept { return target_; }
    float distance() const noexcept { return distance_; }
    float vertical_fov() const noexcept { return vertical_fov_; }

    /// A point near the target on a coarse lattice of whole meters, used as origin for drawing.
    Position render_origin() const;
    /// From positions relative to `origin` to the camera's frame (right, up, backwards).
    glm::mat4 view(const Position& origin) const;
    /// Half the height of the view at a distance of 1. `aspect`, here and below, is width over height: views narrower
    /// than 16:9 show as much horizontally as one of 16:9 does, and more vertically.
    float half_height(float aspect) const;
    /// The distance that determines the apparent size of objects at a point: the point's depth, or with an orthographic
    /// projection the distance of the target. At least a centimeter.
    float scale_at(const Position& point) const;
    /// Perspective or orthographic.
    glm::mat4 projection(float aspect) const;

    /// The ray through a point of the view in normalized device coordinates (-1..1, up is positive), from the eye, or
    /// with an orthographic projection from the plane of the eye.
    Ray cursor_ray(const glm::vec2& device, float aspect) const;
    /// The cursor ray, started so far back that it meets everything visible there.
    Ray pick_ray(const glm::vec2& device, float aspect) const;
    /// How far behind the eye objects are still visible, meters.
    double reach_behind() const;
    /// Projects a point to normalized device coordinates; empty if it is behind the eye of a perspective camera.
    std::optional<glm::vec2> project(const Position& point, float aspect) const;

  private:
    void stay_above();
    void turn_above(const Ground& ground);
    double clearance() const;
    double height(const Ground& ground, const Position& point) const;

    std::vector<Ground> grounds_;
    Position target_{0.0, 0.0, 0.0};
    float yaw_ = 0.0f;   // about +Y; 0 looks along -Z
    float pitch_ = 0.0f; // above the horizon
    float distance_ = 10.0f;
    float vertical_fov_ = 0.785398f;
    bool is_parallel_ = false;
};

} // namespace cairn::viewer
