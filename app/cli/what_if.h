// Changes of a world given on the command line.
#pragma once

#include <cairn/world.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cairn::cli {

struct WhatIf {
    std::function<void(World&)> apply;
};

// Parses "gravity=0,-3.7,0" and the like. Throws Error(invalid_value) for malformed texts.
std::vector<WhatIf> parse_what_if(std::span<const std::string> texts);

} // namespace cairn::cli
