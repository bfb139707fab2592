#include "viewer/glfw_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <iterator>

namespace cairn::viewer {

namespace {

struct NamedKey {
    int key;
    const char* name;
};

constexpr NamedKey named_keys[] = {
    {GLFW_KEY_SPACE, "Space"},     {GLFW_KEY_PERIOD, "."},
    {GLFW_KEY_COMMA, ","},         {GLFW_KEY_LEFT_BRACKET, "["},
    {GLFW_KEY_RIGHT_BRACKET, "]"}, {GLFW_KEY_EQUAL, "="},
    {GLFW_KEY_MINUS, "-"},         {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_DELETE, "Delete"},   {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_ESCAPE, "Escape"},   {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_PAGE_UP, "PageUp"},  {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_LEFT, "Left"},       {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_UP, "Up"},           {GLFW_KEY_DOWN, "Down"},
    {GLFW_KEY_KP_ADD, "KPAdd"},    {GLFW_KEY_KP_SUBTRACT, "KPSubtract"},
};

} // namespace

std::string glfw_key_name(int key) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return std::string(1, char('A' + key - GLFW_KEY_A));
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return std::string(1, char('0' + key - GLFW_KEY_0));
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
        return std::string("KP").append(std::to_string(key - GLFW_KEY_KP_0));
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return std::string("F").append(std::to_string(1 + key - GLFW_KEY_F1));
    const auto found = std::find_if(std::begin(named_keys), std::end(named_keys),
                                    [key](const NamedKey& named) { return named.key == key; });
    return found == std::end(named_keys) ? std::string() : found->name;
}

std::string glfw_modifier_names(int modifiers) {
    std::string names;
    if (modifiers & GLFW_MOD_CONTROL) names += "Ctrl+";
    if (modifiers & GLFW_MOD_ALT) names += "Alt+";
    if (modifiers & GLFW_MOD_SHIFT) names += "Shift+";
    return names;
}

std::optional<GamepadState> glfw_gamepad() {
    static_assert(int(PadButton::count) == GLFW_GAMEPAD_BUTTON_LAST + 1 &&
                  int(PadButton::up) == GLFW_GAMEPAD_BUTTON_DPAD_UP);
    for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
        GLFWgamepadstate state;
        if (!glfwJoystickIsGamepad(joystick) || !glfwGetGamepadState(joystick, &state)) continue;
        GamepadState pad;
        pad.left_stick = {state.axes[GLFW_GAMEPAD_AXIS_LEFT_X], state.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]};
        pad.right_stick = {state.axes[GLFW_GAMEPAD_AXIS_RIGHT_X], state.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]};
        pad.left_trigger = 0.5f * (state.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] + 1.0f); // GLFW: -1 when released
        pad.right_trigger = 0.5f * (state.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] + 1.0f);
        for (std::size_t k = 0; k < pad.down.size(); ++k) pad.down[k] = state.buttons[k] == GLFW_PRESS;
        return pad;
    }
    return std::nullopt;
}

} // namespace cairn::viewer
