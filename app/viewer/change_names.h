/// \file change_names.h
/// What the changes of a world are called, for undoing them by name.
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
/// None for what does not change the world, but where it stands in time or what is shown of it.
std::optional<NamedChange> change_of(const Command& command);

} // namespace cairn::viewer
