/// \file command_list.h
/// All user commands by name: the entries of the command palette (Ctrl+P).
#pragma once

#include "viewer/controller.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::viewer {

struct NamedCommand {
    std::string name;
    std::string keys; ///< Keys that perform the same command; may be empty.
    std::function<void(Controller&)> run;
};

/// Commands for keys, scenes, colors, windows, and display options.
std::vector<NamedCommand> all_commands(const Controller& controller);

/// Indices of the commands whose names contain the letters of `query` in order, in any case and with any characters
/// between; best match first: contiguous matches, at the start of a word.
std::vector<std::size_t> matching(std::span<const NamedCommand> commands, std::string_view query);

} // namespace cairn::viewer
