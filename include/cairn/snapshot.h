/// \file snapshot.h
#pragma once

#include <cairn/shape.h>

#include <cstddef>
#include <vector>

namespace cairn {

/// The whole state of a world: bodies, shapes, contacts with their impulses, sleep, force fields and random
/// order of storage. A world restored from it continues bit for bit as the original would have.
struct Snapshot {
    std::vector<std::byte> bytes;
    std::vector<Shape> shapes; ///< By slot; hulls, meshes and height fields share their data with the world's.
};

} // namespace cairn
