// What the program is doing, for the case that memory runs out: then nothing can be put together any more.
#pragma once

#include <cstdint>
#include <string_view>

namespace cairn::cli {

// "reading", "tower.gltf". Stays until the next call. One thread's business.
void set_activity(std::string_view doing, std::string_view what = {});

// Which of how many steps or cases; forgotten by `set_activity`.
void set_activity_count(std::uint64_t done, std::uint64_t total);

// Keeps some memory back, which is given free when there is no other, so that what was begun can be undone; and where
// undoing it fails as well, ends the program with the line of `report_out_of_memory` all the same.
void prepare_for_out_of_memory();

// One line on stderr: "cairn: out of memory while reading tower.gltf". Allocates nothing.
void report_out_of_memory() noexcept;

} // namespace cairn::cli
