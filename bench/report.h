// Results as text.
#pragma once

#include "bench/measure.h"

#include <string>
#include <vector>

namespace cairn::bench {

// Tables of times and quality, and of the stages for engines that report them.
std::string to_tables(const std::vector<Result>& results);

// One JSON object: {"cairn": version, "instruction_set": name, "results": [...]}. Units are seconds, meters, kilograms
// and joules, except where a name states another one; values that do not exist for an engine or a scene are null.
std::string to_json(const std::vector<Result>& results);

} // namespace cairn::bench
