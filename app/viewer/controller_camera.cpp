// What the controller does with the camera, and with the handles of the selected body.
#include "viewer/controller.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace cairn::viewer {

namespace {

constexpr float orbit_per_key = 0.06f;     // radians
constexpr float least_ground_slope = 0.3f; // of its normal's height: a steeper plane is a wall

} // namespace

bool Controller::perform_on_camera(Action action) {
    switch (action) {
    case Action::orbit_left:
        camera.orbit(-orbit_per_key, 0.0f);
        return true;
    case Action::orbit_right:
        camera.orbit(orbit_per_key, 0.0f);
        return true;
    case Action::orbit_up:
        camera.orbit(0.0f, orbit_per_key);
        return true;
    case Action::orbit_down:
        camera.orbit(0.0f, -orbit_per_key);
        return true;
    case Action::zoom_in:
        camera.zoom(1.0f);
        return true;
    case Action::zoom_out:
        camera.zoom(-1.0f);
        return true;
    case Action::view_front:
        camera.look(0.0f, 0.0f);
        return true;
    case Action::view_side:
        camera.look(1.5707963f, 0.0f);
        return true;
    case Action::view_top:
        camera.look(0.0f, 1.5707963f);
        return true;
    case Action::toggle_parallel:
        camera.set_parallel(!camera.is_parallel());
        return true;
    case Action::follow_selection:
        follow = !follow;
        return true;
    case Action::reset_camera:
        take_scene_view(state_);
        return true;
    case Action::frame_selection: {
        if (!state_.layout || !state_.current) return true;
        WorldLayout shown = *state_.layout;
        if (state_.selected)
            std::erase_if(shown.shapes,
                          [&](const ShapeLayout& shape) { return shown.bodies[shape.body].id != state_.selected; });
        const BoundingBall ball = bounding_ball(shown, *state_.current);
        camera.frame(ball.center, ball.radius);
        return true;
    }
    default:
        return false;
    }
}

// Whether rays are parallel is what the user chose.
void Controller::take_scene_view(const StageState& state) {
    CameraPose pose = state.scene_camera;
    pose.is_parallel = camera.is_parallel();
    camera.set_pose(pose);
}

void Controller::follow_selected(const StageState& state) {
    if (!follow || !state.selected) return;
    const auto& bodies = state.layout->bodies;
    const auto body =
        std::find_if(bodies.begin(), bodies.end(), [&](const BodyLayout& known) { return known.id == state.selected; });
    if (body != bodies.end()) camera.follow(state.current->transforms[std::size_t(body - bodies.begin())].position);
}

// The infinite planes that one could stand on. Walls are none of them, and neither is what the scene itself looks at
// from below.
void Controller::find_grounds(const StageState& state) {
    std::vector<Ground> grounds;
    for (const ShapeLayout& shape : state.layout->shapes) {
        if (shape.type != ShapeType::plane || shape.is_trigger) continue;
        if (state.layout->bodies[shape.body].type != BodyType::static_) continue;
        const Transform& body = state.current->transforms[shape.body];
        const Ground ground{body.position + Position(body.rotation * shape.position),
                            body.rotation * shape.rotation * Vec3(0.0f, 1.0f, 0.0f)};
        const Position eye = state.scene_camera.position;
        if (ground.normal.y < least_ground_slope || glm::dot(eye - ground.point, Position(ground.normal)) <= 0.0)
            continue;
        grounds.push_back(ground);
    }
    camera.set_grounds(std::move(grounds));
}

bool Controller::take_handle() {
    if (!state_.inspected || state_.selected_joint) return false;
    const auto handle = gizmo.handle_at(*state_.inspected, camera, cursor_, aspect_);
    if (handle) gizmo.begin(*state_.inspected, camera, *handle, cursor_, aspect_);
    return handle.has_value();
}

// Every frame, so that the body stays there while it is held.
void Controller::drag_handle() {
    if (!state_.inspected) return;
    if (const auto edit = gizmo.drag(camera, cursor_, aspect_)) post_(command::EditBody{state_.inspected->id, *edit});
}

void Controller::add_gizmo(RenderFrame& frame, const StageState& state) const {
    if (state.inspected && !state.selected_joint && drag_ != Drag::body) gizmo.draw(frame, *state.inspected, camera);
}

} // namespace cairn::viewer
