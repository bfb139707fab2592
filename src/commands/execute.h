// Making a change again that a command tells of.
#pragma once

#include "commands/command_reader.h"

#include <cairn/world.h>

#include <string_view>

namespace cairn::commands {

// Throws what the call throws; Error(invalid_file) or Error(unsupported) if it is none.
void execute(World& world, CommandReader& from);

// Of a call by its number; empty if there is none of that number.
std::string_view name_of(std::uint64_t code);

} // namespace cairn::commands
