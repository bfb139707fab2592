/// \file glfw_keys.h
/// The key map's names for GLFW's key codes, and the state of GLFW's gamepads.
#pragma once

#include "viewer/gamepad.h"

#include <optional>
#include <string>

namespace cairn::viewer {

/// `A`, `7`, `KP7`, `F1`, `Left`, `[` ...; empty for keys that the viewer does not use.
std::string glfw_key_name(int key);
/// The modifier prefix of a key in a chord: `Ctrl+Alt+Shift+`, or fewer.
std::string glfw_modifier_names(int modifiers);
/// The state of the first connected gamepad with a known layout (from SDL's database, and Xbox controllers); empty if
/// there is none.
std::optional<GamepadState> glfw_gamepad();

} // namespace cairn::viewer
