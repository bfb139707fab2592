/// \file snapshot.h
/// The state of a world at one moment, to go back to.
#pragma once

#include <cairn/shape.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace cairn {

/// What steps do not change: settings, shapes, masses, materials, names, definitions of joints, force fields.
struct SnapshotDefinitions {
    std::vector<std::byte> bytes;
    std::vector<Shape> shapes; ///< By slot; hulls, meshes and height fields share their data with the world's.
};

/// What the bytes of a snapshot are for.
struct SnapshotSizes {
    /// The dynamic state of the bodies and their shapes: place, rotation, velocities, where they came to rest, island,
    /// time to sleep, forces.
    std::size_t bodies = 0;
    std::size_t contacts = 0;    ///< Pairs of shapes: points, and the impulses that the next step starts from.
    std::size_t joints = 0;      ///< Impulses that the next step starts from, and positions.
    std::size_t broad_phase = 0; ///< Boxes, their tree, and the list of pairs.
    std::size_t other = 0;       ///< Header, counters, events that the next step will report.
    std::size_t definitions = 0; ///< Once for all snapshots that share them.
};

/// The whole state of a world: bodies, shapes, contacts with their impulses, joints, sleep, force fields, and the order
/// in which all of it is stored. A world restored from it continues bit for bit as the original would have. It can be
/// read by the same build of the library only, and is no file format: scene files are (docs/scene_format.md).
struct Snapshot {
    std::vector<std::byte> bytes; ///< What steps change.
    /// The rest. Snapshots of a world share it as long as nothing of it is changed between them.
    std::shared_ptr<const SnapshotDefinitions> definitions;

    SnapshotSizes sizes() const; ///< Throws `Error` (invalid_file) if it is no snapshot.
};

} // namespace cairn
