/// \file gamepad.h
/// What a gamepad does: sticks and triggers move the camera, buttons are those of the keys for the same things.
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

/// Of one gamepad, at a moment. Sticks: -1 to 1, right and down are positive; triggers: 0 to 1.
struct GamepadState {
    glm::vec2 left_stick{0.0f, 0.0f}, right_stick{0.0f, 0.0f};
    float left_trigger = 0.0f, right_trigger = 0.0f;
    std::array<bool, std::size_t(PadButton::count)> down{};
};

/// What a button does, and how it is called.
struct PadBinding {
    PadButton button;
    Action action;
    std::string_view name;
};
std::span<const PadBinding> pad_bindings();

class Gamepad {
  public:
    /// To be called every frame, with the time since the last one, s. Nothing: there is no gamepad, or its input is
    /// another window's; buttons that are held down when it comes back count only once they are pressed anew.
    void update(const std::optional<GamepadState>& state, float seconds, float aspect, Controller& controller);

  private:
    void press_buttons(const GamepadState& now, float seconds, Controller& controller);

    std::optional<GamepadState> last_;
    std::array<float, std::size_t(PadButton::count)> until_repeat_{}; // s, of a button that is held down
};

} // namespace cairn::viewer
