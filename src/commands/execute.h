// Executes recorded commands.
#pragma once

#include "commands/command_reader.h"

#include <cairn/world.h>

#include <string_view>

namespace cairn::commands {

// Throws what the call throws, or Error(invalid_file) or Error(unsupported) if the bytes are not a known call.
void execute(World& world, CommandReader& from);

// The name of a call by its number; empty if there is none.
std::string_view name_of(std::uint64_t code);

} // namespace cairn::commands
