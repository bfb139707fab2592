/// \file glfw_keys.h
/// The names that the key map uses for GLFW's key codes, and the state of its gamepads.
#pragma once

#include "viewer/gamepad.h"

#include <optional>
#include <string>

namespace cairn::viewer {

/// `A`, `7`, `KP7`, `F1`, `Left`, `[` ...; empty for keys that the viewer has no use for.
std::string glfw_key_name(int key);
/// The modifiers before a key's name in a chord: `Ctrl+Alt+Shift+`, or fewer.
std::string glfw_modifier_names(int modifiers);
/// Of the first one that is connected and whose layout is known (those of SDL's database and Xbox controllers); nothing
/// if there is none.
std::optional<GamepadState> glfw_gamepad();

} // namespace cairn::viewer
