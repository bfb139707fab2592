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
    {"_Handle", "Names one object of one world. Once that object is destroyed, the handle is stale for good."},
    {"_Handle.bits", "The handle as a 64-bit number; 0: the null handle."},
    {"_Handle.index", "Index of the slot in which the world stores the object."},
    {"BodyId", "Names a body."},
    {"ShapeId", "Names a shape on a body."},
    {"JointId", "Names a joint."},
    {"ForceFieldId", "Names a force field."},
    {"Hull", "A convex polyhedron. Its vertices never change, so that copies share their data."},
    {"Hull.__init__", "The convex hull of `points` (n x 3), meters, in the shape's frame. Raises InvalidValueError "
        "when a coordinate is not finite or exceeds 1e6, when there are fewer than 4 points, or when all of them "
            "coincide, lie on one line or lie in one plane (within 1e-5 of their extent)."},
    {"Hull.vertices", "Vertices (n x 3), meters; points inside the hull or on its faces are omitted."},
    {"Hull.faces", "Indices of the vertices of each face, counterclockwise as seen from outside."},
    {"Hull.volume", "Volume, m^3, without rounding."},
    {"Mesh", "A triangle mesh, for static and kinematic bodies. The solid side of a triangle is the one from which "
        "its vertices appear clockwise. A mesh never changes, so that copies share their data."},
    {"Mesh.__init__", "`vertices` (n x 3): meters, in the shape's frame. `indices` (m x 3): the vertices of each "
        "triangle, counterclockwise as seen from outside. Vertices at the same place are merged; triangles without "
            "area are omitted. `materials`: at most 65,535 materials in addition to that of the shape. "
                "`material_numbers` (m): the material of each triangle, 0 for the material of the shape, k for "
                    "materials[k - 1]; None: all have the material of the shape. Raises InvalidValueError when a "
                        "coordinate is not finite or exceeds 1e6, when an index is out of range, when no triangle is "
                            "left, when a material is invalid, or when a material number is out of range."},
    {"Mesh.material_numbers", "The material of each triangle of `indices`; empty: all have the material of the shape."},
    {"Mesh.dropped_triangles", "How many triangles were omitted because they have no area."},
    {"HeightField", "A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies. It "
        "never changes, so that copies share their data."},
    {"HeightField.__init__", "`heights` (rows x columns): meters along y. The height of row r and column c is at x = "
        "(c - (columns - 1) / 2) * spacing[0], z = (r - (rows - 1) / 2) * spacing[1]; `spacing` is in meters, > 0. "
            "Triangles that have a vertex with the height +infinity are holes. `materials`: at most 65,535 materials "
                "in addition to that of the shape. `material_numbers` (rows - 1 x columns - 1): the material of each "
                    "cell, 0 for the material of the shape, k for materials[k - 1]; None: all have the material of "
                        "the shape. Raises InvalidValueError for fewer than 2 columns or rows, more than 2^28 "
                            "heights, a spacing that is not finite and > 0, a height that is NaN or exceeds 1e6 and "
                                "is not +infinity, a field that consists of holes only, an invalid material, or a "
                                    "material number out of range."},
    {"HeightField.material_numbers", "The material of each cell (rows - 1 x columns - 1); empty: all have the "
        "material of the shape."},
    {"HeightField.indices", "The triangles that are not holes (n x 3): indices of `vertices`, counterclockwise as "
        "seen from above."},
    {"HeightField.vertices", "The points of the grid with their heights (n x 3), row by row, meters; y of a hole is "
        "+infinity."},
    {"HeightField.spacing", "Distance of neighboring points of the grid along x and z, meters."},
    {"Snapshot", "The complete state of a world at one time. A world restored from it continues bit for bit as the "
        "original would have."},
    {"Snapshot.nbytes", "Its size in bytes, without the definitions that it shares with other snapshots of the same "
        "world."},
    {"Body", "An accessor to one body of a world. It can be used as long as the body exists; after that, every use "
        "raises InvalidHandleError. Setting a property wakes the body. Vectors are in world axes and points in world "
            "space."},
    {"World", "A world of rigid bodies. It must not be used by two threads at the same time: calls while another "
        "thread runs `step` raise WrongStateError."},
    {"World.__init__", "Creates an empty world. `World(gravity=(0, -1.6, 0))` is "
        "`World(WorldDef(gravity=(0, -1.6, 0)))`."},
    {"World.warnings", "Features of the scene file that were approximated or left out."},
    {"World.body", "Returns an accessor to a body. Raises InvalidHandleError."},
    {"World.create_body", "Creates a body without shapes, from a definition or from members of one as keyword "
        "arguments. Makes arrays of bodies invalid."},
    {"World.destroy_body", "Destroys the body with its shapes and joints, and wakes bodies that rested on it. Makes "
        "arrays of bodies invalid."},
    {"World.is_valid", "Whether the handle names an object of this world that exists."},
    {"World.step", "Advances the simulation by `n` steps of `dt` seconds (> 0; None: `time_step`). Other Python "
        "threads can run meanwhile. The events are those of the last step. Raises InvalidValueError, WrongStateError."},
    {"World.positions", "The origins of the bodies' frames, meters (n x 3, float64), in the order of `bodies`. "
        "Read-only; the array follows the world until bodies are created or destroyed."},
    {"World.rotations", "The rotations of the bodies as unit quaternions x, y, z, w (n x 4, float32); otherwise like "
        "`positions`."},
    {"World.velocities", "The velocities of the centers of mass, m/s (n x 3, float32); otherwise like `positions`."},
    {"World.angular_velocities", "The angular velocities, rad/s, world axes (n x 3, float32); otherwise like "
        "`positions`."},
    {"World.save", "Saves the complete state of the world, to which it can be restored."},
    {"World.restore", "Restores the state that was saved. Handles of that time are valid again. Makes arrays of "
        "bodies invalid."},
    {"World.close", "Frees the memory of the world. Every use after that raises WrongStateError."},
    {"load", "Reads a scene file (.gltf, .glb) or a model (URDF, MJCF, SDF, USD). `fixed_base`: the base of a robot "
        "(URDF, MJCF, SDF) does not move. Raises InvalidFileError, FileError, and UnsupportedError for `fixed_base` "
            "with other files."},
    {"save", "Writes the present state of the world to a file: binary .glb if the name ends so, otherwise .gltf. "
        "Raises FileError."},
    {"find_scene", "Returns the file of a scene that comes with Cairn, given its name or number; or the path `name` "
        "itself if that file exists. Raises FileError if there is none, and InvalidValueError if the name is "
            "ambiguous."},
    {"instruction_set", "The instruction set that the kernels of this process use: "
        "\"avx512\", \"avx2\", \"sse2\", \"neon\", \"simd128\" or \"scalar\". Results do not depend on it."},
    {"hardware_threads", "The number of hardware threads of this machine, 1 to 256: a good value for `World.threads`."},
};

} // namespace

const char* doc_of(const char* name) {
    for (const Row& row : rows)
        if (std::strcmp(row.name, name) == 0) return row.text;
    throw std::logic_error(std::string("no documentation of ") + name);
}

} // namespace cairn::python
