/// \file glfw_keys.h
/// The names that the key map uses for GLFW's key codes.
#pragma once

#include <string>

namespace cairn::viewer {

/// `A`, `7`, `KP7`, `F1`, `Left`, `[` ...; empty for keys that the viewer has no use for.
std::string glfw_key_name(int key);
/// The modifiers before a key's name in a chord: `Ctrl+Alt+Shift+`, or fewer.
std::string glfw_modifier_names(int modifiers);

} // namespace cairn::viewer
