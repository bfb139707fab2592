/// \file gamepad.h
/// Gamepad input: sticks and triggers move the camera; each button performs the action of a key.
#pragma once

#include "viewer/controller.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace cairn::viewer {

/// In the order of GLFW and SDL, named as on an Xbox controller.
enum class PadButton {
    a,
    b,
    x,
    y,
    left_bumper,
    right_bumper,
    back,
    start,
    guide,
    left_thumb,
    right_thumb,
    up,
    right,
    down,
    left,
    count
};

/// The input of one gamepad. Sticks: -1 to 1, right and down are positive; triggers: 0 to 1.
struct GamepadState {
    glm::vec2 left_stick{0.0f, 0.0f}, right_stick{0.0f, 0.0f};
    float left_trigger = 0.0f, right_trigger = 0.0f;
    std::array<bool, std::size_t(PadButton::count)> down{};
};

/// The action and the display name of a button.
struct PadBinding {
    PadButton button;
    Action action;
    std::string_view name;
};
std::span<const PadBinding> pad_bindings();

class Gamepad {
  public:
    /// To be called every frame, with the time since the last one, s. Empty state: there is no gamepad, or another
    /// window has its input; buttons that are down when it returns count only when pressed again.
    void update(const std::optional<GamepadState>& state, float seconds, float aspect, Controller& controller);

  private:
    void press_buttons(const GamepadState& now, float seconds, Controller& controller);

    std::optional<GamepadState> last_;
    std::array<float, std::size_t(PadButton::count)> until_repeat_{}; // s, for buttons that are down
};

} // namespace cairn::viewer
