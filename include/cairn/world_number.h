/// \file world_number.h
/// Snapshots without the number of their world. Worlds are numbered in the order of their creation, and handles contain
/// that number. Without it, the same run gives snapshots of the same bytes in any world of a process.
#pragma once

#include <cairn/snapshot.h>

namespace cairn {

/// The same snapshot, as if its world had the number 1. Throws `Error` (invalid_file, unsupported) if this build did
/// not make it.
Snapshot without_world(const Snapshot& snapshot);

} // namespace cairn
