/// \file world_number.h
/// Snapshots without the number of their world. Worlds are numbered as they are made, and handles tell them apart by
/// that: without it the same run gives the same bytes in any world of a process.
#pragma once

#include <cairn/snapshot.h>

namespace cairn {

/// The same snapshot of a world with the number 1. Throws `Error` (invalid_file, unsupported) if it is none of this
/// build.
Snapshot without_world(const Snapshot& snapshot);

} // namespace cairn
