// Results as text.
#pragma once

#include "bench/measure.h"

#include <string>
#include <vector>

namespace cairn::bench {

// Tables for people: times, quality, and the stages of the engines that tell them.
std::string to_tables(const std::vector<Result>& results);

// One object: {"cairn": version, "instruction_set": name, "results": [...]}. Seconds, meters, kilograms, joules
// except where a name says otherwise; what an engine or a scene does not have is null.
std::string to_json(const std::vector<Result>& results);

} // namespace cairn::bench
