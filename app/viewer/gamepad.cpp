#include "viewer/gamepad.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace cairn::viewer {

namespace {

// Share of the range of a stick or trigger; worn ones do not return exactly to the center.
constexpr float dead_zone = 0.15f;
constexpr float orbit_speed = 2.5f;   // rad/s
constexpr float pan_speed = 0.8f;     // view heights per second
constexpr float zoom_speed = 12.0f;   // notches per second
constexpr float longest_frame = 0.1f; // s; longer frames are shortened, so that the camera does not jump after a pause
constexpr float first_repeat = 0.4f, next_repeat = 0.05f; // s

constexpr PadBinding all_pad_bindings[] = {
    {PadButton::a, Action::toggle_pause, "A"},
    {PadButton::b, Action::shoot, "B"},
    {PadButton::x, Action::reset_scene, "X"},
    {PadButton::y, Action::next_colors, "Y"},
    {PadButton::left_bumper, Action::step_back, "LB"},
    {PadButton::right_bumper, Action::single_step, "RB"},
    {PadButton::back, Action::toggle_help, "Back"},
    {PadButton::start, Action::toggle_panel, "Start"},
    {PadButton::left_thumb, Action::follow_selection, "left stick pressed"},
    {PadButton::right_thumb, Action::frame_selection, "right stick pressed"},
    {PadButton::up, Action::faster, "up"},
    {PadButton::down, Action::slower, "down"},
    {PadButton::left, Action::previous_scene, "left"},
    {PadButton::right, Action::next_scene, "right"},
};

// Response curve: 0 at the edge of the dead zone to 1, with finer control near the center.
float shaped(float size) {
    const float rest = std::clamp((size - dead_zone) / (1.0f - dead_zone), 0.0f, 1.0f);
    return rest * rest;
}
glm::vec2 shaped(const glm::vec2& stick) {
    const float size = glm::length(stick);
    return size > dead_zone ? (shaped(size) / size) * stick : glm::vec2(0.0f);
}

} // namespace

std::span<const PadBinding> pad_bindings() { return all_pad_bindings; }

void Gamepad::update(const std::optional<GamepadState>& state, float seconds, float aspect, Controller& controller) {
    if (state) {
        const float time = std::clamp(seconds, 0.0f, longest_frame);
        const glm::vec2 turn = time * orbit_speed * shaped(state->right_stick);
        if (turn != glm::vec2(0.0f)) controller.camera.orbit(turn.x, -turn.y);
        const glm::vec2 way = time * pan_speed * shaped(state->left_stick);
        if (way != glm::vec2(0.0f)) controller.camera.pan(way.x, -way.y, aspect);
        const float notches = time * zoom_speed * (shaped(state->right_trigger) - shaped(state->left_trigger));
        if (notches != 0.0f) controller.camera.zoom(notches);
        if (last_) press_buttons(*state, time, controller);
    }
    last_ = state;
}

void Gamepad::press_buttons(const GamepadState& now, float seconds, Controller& controller) {
    for (const PadBinding& binding : all_pad_bindings) {
        const auto k = std::size_t(binding.button);
        if (!now.down[k]) continue;
        if (!last_->down[k]) {
            until_repeat_[k] = first_repeat;
        } else {
            until_repeat_[k] -= seconds;
            if (!repeats(binding.action) || until_repeat_[k] > 0.0f) continue;
            until_repeat_[k] = next_repeat;
        }
        controller.perform({binding.name, binding.action});
    }
}

} // namespace cairn::viewer
