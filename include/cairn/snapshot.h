/// \file snapshot.h
/// Snapshots: the complete state of a world at one time, to which it can be restored.
#pragma once

#include <cairn/shape.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace cairn {

/// The part of a snapshot that steps do not change: settings, shapes, masses, materials, names, definitions of joints,
/// force fields.
struct SnapshotDefinitions {
    std::vector<std::byte> bytes;
    /// By slot index; hulls, meshes and height fields share their data with those of the world.
    std::vector<Shape> shapes;
};

/// How the size of a snapshot, in bytes, is made up.
struct SnapshotSizes {
    /// Dynamic state of the bodies and their shapes: position, rotation, velocities, the pose at which they came to
    /// rest, island, time at rest, forces.
    std::size_t bodies = 0;
    std::size_t contacts = 0;    ///< Pairs of shapes: contact points, and the impulses for warm starting the next step.
    std::size_t joints = 0;      ///< Impulses for warm starting the next step, and positions.
    std::size_t broad_phase = 0; ///< Bounding boxes, their trees, and the list of pairs.
    std::size_t other = 0;       ///< Header, counters, and events that the next step will report.
    std::size_t definitions = 0; ///< The definitions, which many snapshots may share.
};

/// The complete state of a world: bodies, shapes, contacts with their impulses, joints, sleep, force fields, and the
/// order in which they are stored. A world restored from it continues bit for bit as the original would have. Only the
/// same build of the library can read it: it is not a file format. Scene files are one (docs/scene_format.md).
struct Snapshot {
    std::vector<std::byte> bytes; ///< The part that steps change.
    /// The part that steps do not change. Snapshots of a world share it as long as it does not change between them.
    std::shared_ptr<const SnapshotDefinitions> definitions;

    SnapshotSizes sizes() const; ///< Throws `Error` (invalid_file) if `bytes` is not a valid snapshot.
};

} // namespace cairn
