// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/docs.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace cairn::python {

namespace {

struct Row {
    const char *name, *text;
};
constexpr Row rows[] = {
    {"_Handle", "Names one object of one world. Once that is gone the handle is stale for ever."},
    {"_Handle.bits", "All of it; 0: none."},
    {"_Handle.index", "The slot that the object is in."},
    {"BodyId", "Names a body."},
    {"ShapeId", "Names a shape on a body."},
    {"JointId", "Names a joint."},
    {"ForceFieldId", "Names a force field."},
    {"Hull", "A convex polyhedron. Its corners never change, so that copies share their data."},
    {"Hull.__init__", "The convex hull of any points (n x 3), meters, in the shape's frame. Raises InvalidValueError "
        "when a coordinate is not finite or exceeds 1e6, when there are fewer than 4 points, or when they all lie in "
            "one point, on one line or in one plane."},
    {"Hull.vertices", "Corners (n x 3), meters; points inside and on faces are left out."},
    {"Hull.faces", "Indices of the corners of each face, counterclockwise as seen from outside."},
    {"Hull.volume", "m^3."},
    {"Mesh", "A surface of triangles, for static and kinematic bodies. Solid is the side that sees the corners "
        "clockwise."},
    {"Mesh.__init__", "Vertices (n x 3), meters; triangles (m x 3), counterclockwise as seen from outside. Triangles "
        "without area are left out. `materials`: those that parts of it have beside that of the "
            "shape; `material_numbers` (m): which one each triangle has, 0 for that of the shape, k for materials[k - "
                "1]; None: all have that of the shape. Raises InvalidValueError when a coordinate is not finite or "
                    "exceeds 1e6, when an index is out of range, when no triangle is left, or when a material or a "
                        "number is none."},
    {"Mesh.material_numbers", "One for each row of `indices`; empty: all have that of the shape."},
    {"Mesh.dropped_triangles", "How many had no area."},
    {"HeightField", "A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies."},
    {"HeightField.__init__", "Heights (rows x columns), meters along y: that of row r and column c stands at x = (c - "
        "(columns - 1) / 2) * spacing[0], z = (r - (rows - 1) / 2) * spacing[1]. Triangles of which a corner has the "
            "height +infinity are holes. `materials`: those that parts of it have beside that of the "
                "shape; `material_numbers` (rows - 1 x columns - 1): which one each cell has, 0 for that of the "
                    "shape, k for materials[k - 1]; None: all have that of the shape. Raises InvalidValueError for "
                        "fewer than 2 columns or rows, a spacing that is no size, a height that is no number or "
                            "exceeds 1e6 and is not +infinity, holes alone, or a material or a number that is none."},
    {"HeightField.material_numbers", "Of each cell (rows - 1 x columns - 1); empty: all have that of the shape."},
    {"HeightField.indices", "Its triangles that are no holes (n x 3): indices of its vertices, counterclockwise as "
        "seen from above."},
    {"HeightField.vertices", "Where the heights stand, row after row (n x 3), meters; y of a hole is +infinity."},
    {"HeightField.spacing", "Meters along x and z."},
    {"Snapshot", "The whole state of a world at one moment. A world restored from it goes on bit for bit."},
    {"Snapshot.nbytes", "Its size, without what it shares with other snapshots of the same world."},
    {"Body", "An accessor to one body of a world. It stays usable as long as the body lives; after that every use "
        "raises InvalidHandleError. Setting a property wakes the body. Vectors are in world axes, points in world "
            "space."},
    {"World", "A world of rigid bodies. It must not be used by two threads at a time: what comes while another thread "
        "is in `step` raises WrongStateError."},
    {"World.__init__", "`World(gravity=(0, -1.6, 0))` is `World(WorldDef(gravity=(0, -1.6, 0)))`."},
    {"World.warnings", "What the file asks for that was done another way, or left out."},
    {"World.body", "The accessor to a body. Raises InvalidHandleError."},
    {"World.create_body", "Makes a body without shapes: of a definition, or of its members by name."},
    {"World.destroy_body", "With its shapes and joints; wakes what rested on it. Arrays of bodies are retired."},
    {"World.is_valid", "Whether it names something of this world that exists."},
    {"World.step", "Advances by `n` steps of `dt` seconds (> 0; None: `time_step`). Other threads of Python run "
        "meanwhile. Events are those of the last step. Raises InvalidValueError, WrongStateError."},
    {"World.positions", "The origins of the bodies' frames, meters (n x 3, float64), in the order of `bodies`. "
        "Read-only; it follows the world until bodies come or go."},
    {"World.rotations", "The rotations of the bodies as unit quaternions x, y, z, w (n x 4, float32); otherwise as "
        "`positions`."},
    {"World.velocities", "The velocities of the centers of mass, m/s (n x 3, float32); otherwise as `positions`."},
    {"World.angular_velocities", "rad/s, world axes (n x 3, float32); otherwise as `positions`."},
    {"World.save", "The whole state, to go back to."},
    {"World.restore", "Makes this world the one that was saved. Handles from then are valid again; arrays of bodies "
        "are retired."},
    {"World.close", "Gives its memory back. Every use after that raises WrongStateError."},
    {"load", "Reads a scene file (.gltf, .glb) or a model (URDF, MJCF, SDF, USD). `fixed_base`: the base of a robot "
        "does not move. Raises InvalidFileError, FileError, UnsupportedError."},
    {"save", "Writes the world as it stands now: a binary .glb if the name ends so, else .gltf. Raises FileError."},
    {"find_scene", "The file of a scene that comes with Cairn, by its name or number; or the path itself if it is "
        "one."},
    {"instruction_set", "\"avx512\", \"avx2\", \"sse2\", \"neon\", \"simd128\" or \"scalar\". Results do not depend "
        "on it."},
    {"hardware_threads", "The number of threads that this machine runs at a time."},
};

} // namespace

const char* doc_of(const char* name) {
    for (const Row& row : rows)
        if (std::strcmp(row.name, name) == 0) return row.text;
    throw std::logic_error(std::string("no documentation of ") + name);
}

} // namespace cairn::python
