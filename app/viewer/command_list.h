/// \file command_list.h
/// All that one can do, by name: what the list behind Ctrl+P searches.
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
    std::string keys; ///< That do the same; may be empty.
    std::function<void(Controller&)> run;
};

/// Commands of keys, scenes, colors, windows, and what can be shown.
std::vector<NamedCommand> all_commands(const Controller& controller);

/// Indices of the commands whose names have the letters of `query` in their order, whatever lies between and however
/// they are written; the best first: those that have it in one piece, at the start of a word.
std::vector<std::size_t> matching(std::span<const NamedCommand> commands, std::string_view query);

} // namespace cairn::viewer
