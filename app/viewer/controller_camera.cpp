// Camera actions of the controller, and its handling of the gizmo.
#include "viewer/controller.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace cairn::viewer {

namespace {

constexpr float orbit_per_key = 0.06f;     // radians
constexpr float least_ground_slope = 0.3f; // vertical component of the unit normal; a steeper plane is a wall

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
        wants_parallel_ = camera.is_parallel();
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
            std::erase_if(shown.shapes, [&](const ShapeLayout& shape) {
                const std::vector<BodyId>& all = state_.selection;
                return std::find(all.begin(), all.end(), shown.bodies[shape.body].id) == all.end();
            });
        const BoundingBall ball = bounding_ball(shown, *state_.current);
        camera.frame(ball.center, ball.radius);
        return true;
    }
    default:
        return false;
    }
}

// An orthographic projection that the user chose persists across scenes; one from a scene ends with it.
void Controller::take_scene_view(const StageState& state) {
    CameraPose pose = state.scene_camera;
    pose.is_parallel = pose.is_parallel || wants_parallel_;
    camera.set_pose(pose);
}

void Controller::follow_selected(const StageState& state) {
    if (!follow || !state.selected) return;
    const auto& bodies = state.layout->bodies;
    const auto body =
        std::find_if(bodies.begin(), bodies.end(), [&](const BodyLayout& known) { return known.id == state.selected; });
    if (body != bodies.end()) camera.follow(state.current->transforms[std::size_t(body - bodies.begin())].position);
}

// Collects the infinite static planes that limit the camera. Walls are left out, and so are planes that the scene's own
// camera views from below.
void Controller::find_grounds(const StageState& state) {
    std::vector<Ground> grounds;
    for (const ShapeLayout& shape : state.layout->shapes) {
        if (shape.type != ShapeType::plane || shape.is_trigger) continue;
        if (state.layout->bodies[shape.body].type != BodyType::static_) continue;
        const Transform& body = state.current->transforms[shape.body];
        const Ground ground{body.position + Position(body.rotation * shape.position),
                            body.rotation * shape.rotation * Vec3(0.0f, 1.0f, 0.0f)};
        const CameraPose& view = state.scene_camera;
        // The position of an orthographic camera along its axis is arbitrary, so its viewing direction decides.
        const double above = view.is_parallel ? glm::dot(view.position - view.target, Position(ground.normal))
                                              : glm::dot(view.position - ground.point, Position(ground.normal));
        if (ground.normal.y < least_ground_slope || above <= 0.0) continue;
        grounds.push_back(ground);
    }
    camera.set_grounds(std::move(grounds));
}

bool Controller::take_handle() {
    if (!state_.handled || state_.selected_joint) return false;
    const auto handle = gizmo.handle_at(*state_.handled, camera, cursor_, aspect_);
    if (!handle) return false;
    gizmo.begin(*state_.handled, camera, *handle, cursor_, aspect_);
    held_bodies_.clear();
    handle_center_ = state_.handled->center;
    scaled_ = 1.0f;
    const auto& bodies = state_.layout->bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (std::find(state_.selection.begin(), state_.selection.end(), bodies[i].id) != state_.selection.end())
            held_bodies_.push_back({bodies[i].id, state_.current->transforms[i]});
    return true;
}

// Called every frame, so that the body stays at the handle's position while it is held.
void Controller::drag_handle() {
    const auto edit = gizmo.drag(camera, cursor_, aspect_);
    if (!edit || held_bodies_.empty()) return;
    if (held_bodies_.size() == 1) return post_(command::EditBody{held_bodies_.front().id, *edit});
    if (const auto* scale = std::get_if<edit::Scale>(&*edit)) scaled_ *= scale->factors.x;
    post_(command::EditBodies{spread(*edit, handle_center_, scaled_, held_bodies_)});
}

void Controller::add_gizmo(RenderFrame& frame, const StageState& state) const {
    if (state.handled && !state.selected_joint && drag_ != Drag::body) gizmo.draw(frame, *state.handled, camera);
}

} // namespace cairn::viewer
