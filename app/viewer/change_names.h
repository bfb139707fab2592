/// \file change_names.h
/// Names of the changes of a world, for undo and redo.
#pragma once

#include "viewer/commands.h"
#include "viewer/timeline.h"

#include <optional>
#include <string>

namespace cairn::viewer {

struct NamedChange {
    std::string name;
    Timeline::Merge merge = Timeline::Merge::never;
};
/// Empty for commands that do not change the world, but only the displayed step or the display.
std::optional<NamedChange> change_of(const Command& command);

} // namespace cairn::viewer
