/// \file camera.h
/// The orbit camera: it looks at a target from a distance. Positions are double, so that it works far from the
/// world's origin; what goes to the graphics card is relative to an origin near the target.
#pragma once

#include <cairn/math.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace cairn::viewer {

/// Where a camera stands and what it looks at.
struct CameraPose {
    Position position{9.0, 6.0, 12.0}; ///< Meters.
    Position target{0.0, 1.0, 0.0};    ///< Meters.
    float vertical_fov = 0.785398f;    ///< Radians, between 0 and pi, of a picture of 16:9 or wider.
    /// Its rays are parallel (an orthographic projection): everything is as large as it would be at the distance of the
    /// target, and what is behind the camera is seen as well.
    bool is_parallel = false;
};

/// How much nearer a usual lens would be to show as much: 1, or less for a longer one. Sizes that go with the distance
/// of the camera go with its product with this.
float lens_of(const CameraPose& camera);

/// A half-line through the world. `direction` has unit length.
struct Ray {
    Position origin{0.0, 0.0, 0.0};
    Vec3 direction{0.0f, 0.0f, -1.0f};
};

/// A plane that the eye stays above.
struct Ground {
    Position point{0.0, 0.0, 0.0}; ///< Of the plane.
    Vec3 normal{0.0f, 1.0f, 0.0f}; ///< Unit length, upwards (y > 0).
};

class OrbitCamera {
  public:
    explicit OrbitCamera(const CameraPose& pose = {}) { set_pose(pose); }

    /// Takes over a pose. A position equal to the target is moved back to the least distance.
    void set_pose(const CameraPose& pose);
    CameraPose pose() const;

    /// From now on movements end above these planes: the eye slides along them, a little above, and the target stays
    /// out of them. `set_pose` is taken as it is.
    void set_grounds(std::vector<Ground> grounds) { grounds_ = std::move(grounds); }

    /// Turns about the target, radians: positive `yaw` moves the camera to its right, positive `pitch` upwards.
    /// The camera stops short of the poles.
    void orbit(float yaw, float pitch);
    /// Moves closer (positive) or away; one notch changes the distance by a tenth.
    void zoom(float notches);
    /// Shifts the target sideways and upwards, in units of the height of the picture; `aspect` is its width over
    /// height.
    void pan(float right, float up, float aspect);
    /// Looks along a direction, of which the angles are those of `orbit`.
    void look(float yaw, float pitch);
    /// Moves with what is looked at.
    void follow(const Position& target);
    /// See `CameraPose::is_parallel`. What is at the distance of the target keeps its size.
    void set_parallel(bool on);
    bool is_parallel() const noexcept { return is_parallel_; }
    /// Looks at a ball from the present direction, so that it fills about half of the picture.
    void frame(const Position& center, float radius);

    Vec3 forward() const;
    Vec3 right() const;
    Vec3 up() const;
    Position position() const;
    const Position& target() const noexcept { return target_; }
    float distance() const noexcept { return distance_; }
    float vertical_fov() const noexcept { return vertical_fov_; }

    /// A point near the target on a coarse lattice of whole meters, from which drawing measures.
    Position render_origin() const;
    /// From positions relative to `origin` to the camera's frame (right, up, backwards).
    glm::mat4 view(const Position& origin) const;
    /// Half the height of the picture at a distance of 1. `aspect`, here and below, is width over height: pictures
    /// narrower than 16:9 show as much to the sides as one of 16:9 does, and more above and below.
    float half_height(float aspect) const;
    /// The distance that the size of a point's surroundings in the picture goes with: its depth, or where rays are
    /// parallel that of the target. At least a centimeter.
    float scale_at(const Position& point) const;
    /// Perspective or orthographic.
    glm::mat4 projection(float aspect) const;

    /// The ray through a point of the picture, in normalized device coordinates (-1..1, up is positive), from the eye,
    /// or where rays are parallel from the plane of the eye.
    Ray cursor_ray(const glm::vec2& device, float aspect) const;
    /// The same, so far back that it meets all that is seen there.
    Ray pick_ray(const glm::vec2& device, float aspect) const;
    /// How far behind the eye something is still seen, meters.
    double reach_behind() const;
    /// Where a point appears, in normalized device coordinates; nothing if it is behind the eye of a perspective.
    std::optional<glm::vec2> project(const Position& point, float aspect) const;

  private:
    void stay_above();
    void turn_above(const Ground& ground);
    double clearance() const;
    double height(const Ground& ground, const Position& point) const;

    std::vector<Ground> grounds_;
    Position target_{0.0, 0.0, 0.0};
    float yaw_ = 0.0f;   // about +Y, 0 looks along -Z
    float pitch_ = 0.0f; // above the horizon
    float distance_ = 10.0f;
    float vertical_fov_ = 0.785398f;
    bool is_parallel_ = false;
};

} // namespace cairn::viewer
