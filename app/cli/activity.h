// The present activity of the program, for the message when memory runs out: at that point no text can be composed.
#pragma once

#include <cstdint>
#include <string_view>

namespace cairn::cli {

// Example: "reading", "tower.gltf". Stays until the next call. To be called from one thread only.
void set_activity(std::string_view doing, std::string_view what = {});

// Number of finished steps or cases, and their total; reset by `set_activity`.
void set_activity_count(std::uint64_t done, std::uint64_t total);

// Reserves memory that is freed on the first failed allocation, so that the present work can be undone by exceptions;
// if that fails too, the program still ends with the line of `report_out_of_memory`.
void prepare_for_out_of_memory();

// Prints one line to stderr: "cairn: out of memory while reading tower.gltf". Does not allocate.
void report_out_of_memory() noexcept;

} // namespace cairn::cli
