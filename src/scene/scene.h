/// \file scene.h
/// Scene files: glTF 2.0 with the Khronos drafts KHR_physics_rigid_bodies and KHR_implicit_shapes, and the
/// world's own settings in CAIRN_world. docs/scene_format.md describes the format. Robots in URDF are read too.
///
///     cairn::scene::Scene scene = cairn::scene::load("scenes/welcome.gltf");
///     for (int i = 0; i < 600; ++i) scene.world.step(scene.info.time_step);
///
/// Everything here throws `cairn::Error`: `invalid_file` for a malformed file, `unsupported` for a well-formed
/// one that asks for something this build does not do, `io` for a file that cannot be read or written. The
/// message names the file, the place in it as a JSON path, what was expected and what was found:
/// `crate.gltf: nodes[3].extensions.KHR_physics_rigid_bodies.motion.mass: must be >= 0, got -2`.
#pragma once

#include <cairn/cairn.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::scene {

/// The recommended view of a scene.
struct Camera {
    Position position{6.0, 4.0, 10.0}; ///< Meters.
    /// The point in the middle of the picture, meters; it must differ from the position.
    Position target{0.0, 1.0, 0.0};
    float vertical_fov_degrees = 45.0f; ///< Full angle from the bottom to the top of the picture, 1 to 170.
    /// Parallel projection: at any distance the picture covers the height that the angle covers at the distance of the
    /// target.
    bool is_orthographic = false;
};

/// A light as in KHR_lights_punctual.
struct Light {
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    Vec3 color{1.0f, 1.0f, 1.0f};     ///< Linear.
    float intensity = 1.0f;           ///< Lux of a directional light, candela of others.
    Position position{0.0, 0.0, 0.0}; ///< Meters; meaningless for a directional light.
    /// Unit vector opposite to the direction in which it shines; meaningless for a point light.
    Vec3 towards{0.0f, 1.0f, 0.0f};
    float range = 0.0f;                ///< Meters, beyond which it does not shine; 0: unlimited.
    float inner_cone = 0.0f;           ///< Of a spot: angle from its axis, rad, up to which it has full intensity,
    float outer_cone = 0.78539816339f; ///< and the angle at which its light ends.
};

/// Information about a scene beside its bodies.
struct SceneInfo {
    std::string title;                    ///< A few words.
    std::string hint;                     ///< One line on what to watch or try.
    float time_step = 1.0f / 60.0f;       ///< s, 0.0001 to 1: the step that the scene is meant for.
    std::optional<Camera> camera;         ///< Absent: the viewer chooses a view.
    std::vector<Light> lights;            ///< At their initial positions, where they stay.
    std::vector<ForceField> force_fields; ///< The definitions; `Scene::force_fields` has the handles in the world.
};

/// The color that a file gives to a shape.
struct Appearance {
    BodyId body;
    ShapeId shape;
    Vec3 color{1.0f, 1.0f, 1.0f}; ///< Linear red, green and blue, each 0 to 1.
};

/// A joint that is shown as a string between its two anchors.
struct JointAppearance {
    JointId joint;
    Vec3 color{1.0f, 1.0f, 1.0f}; ///< Linear red, green and blue, each 0 to 1.
};

/// A picture that covers a surface, as stored in a file.
struct Texture {
    enum class Wrap { repeat, mirror, clamp };
    std::shared_ptr<const std::string> file;           ///< A whole PNG or JPEG file, not decoded. Its colors are sRGB.
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat; ///< How the picture continues beyond its edges.
    bool is_smooth = true;     ///< True: texels are interpolated when magnified; false: each texel is flat.
    float alpha_cutoff = 0.0f; ///< Texels with less alpha, 0 to 1, are not drawn.
    bool is_data = false;      ///< Texels are numbers, not colors in sRGB.
};

/// Reflectance of a surface beside its color. All textures share the texture coordinates of the color texture.
struct Finish {
    float roughness = 1.0f; ///< 0, a mirror, to 1.
    float metalness = 0.0f; ///< 0, or 1: a metal, whose reflections have its own color and which has no diffuse color.
    std::shared_ptr<const Texture> rough{}; ///< Null: none. Green multiplies `roughness`, blue `metalness`.
    /// Null: none. Normal map with components -1 to 1 as 0 to 1: red to the right in the texture, green up, blue
    /// outward.
    std::shared_ptr<const Texture> normals{};
    float normal_scale = 1.0f;              ///< Multiplies red and green of `normals`.
    Vec3 glow{0.0f, 0.0f, 0.0f};            ///< Emitted light, linear, 0 to 1 each,
    float glow_strength = 1.0f;             ///< times this, >= 0.
    std::shared_ptr<const Texture> glows{}; ///< Null: none. Its colors are multiplied with `glow`.
};

/// The weights of up to four bones in the position of a vertex. The shares sum to 1.
struct BoneWeights {
    std::array<std::uint16_t, 4> bones{}; ///< Indices into `VisualMesh::bones`.
    std::array<float, 4> shares{1.0f, 0.0f, 0.0f, 0.0f};
};

/// A bone of a skinned mesh.
struct Bone {
    BodyId body; ///< Null: a bone that does not move.
    /// Map from the coordinates of the mesh to the frame of the body, or to the world.
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0, 0.0, 0.0}; ///< Meters.
};

/// Triangles for display. A surface never changes once it is in a scene, so that many meshes may share it.
struct Surface {
    std::vector<Vec3> vertices;         ///< Meters.
    std::vector<Vec3> normals;          ///< Unit length, one for each vertex; or none, for flat shading.
    std::vector<std::uint32_t> indices; ///< Three per triangle, counterclockwise as seen from outside; all in range.
    /// Texture coordinates, one for each vertex, or none: u to the right and v down, 0 to 1 across the picture.
    std::vector<glm::vec2> coordinates{};
    std::vector<BoneWeights> weights{}; ///< For a mesh with bones: one entry for each vertex.
    std::vector<Vec3> colors{}; ///< Linear, 0 to 1, one for each vertex, or none; multiply the color of the mesh.
};

/// A mesh for display only. It takes no part in the simulation, and moves with its body. A body that has visual meshes
/// is best shown by them instead of by its shapes.
struct VisualMesh {
    BodyId body;     ///< Null: scenery, which belongs to no body.
    Transform local; ///< In the frame of the body; of scenery, in the world.
    std::shared_ptr<const Surface> surface;
    Vec3 color{1.0f, 1.0f, 1.0f};             ///< Linear red, green and blue, each 0 to 1.
    std::shared_ptr<const Texture> texture{}; ///< Null: none. Its colors are multiplied with `color`.
    /// Empty: the mesh is rigid. Else it is skinned: the position of a vertex is the mean of the positions that its
    /// bones give it, weighted by their shares; `body` is null, and `local` is meaningless.
    std::vector<Bone> bones{};
    std::shared_ptr<const Finish> finish{}; ///< Null: smooth, like plastic.
};

/// The maximum speed at which a joint of a robot may be driven. The engine's motors do not enforce it; controllers that
/// set their targets should.
struct JointSpeedLimit {
    JointId joint;
    float speed = 0.0f; ///< rad/s or m/s, > 0.
};

/// A world and what came with it.
struct Scene {
    World world;
    SceneInfo info;
    std::vector<ForceFieldId> force_fields;
    std::vector<Appearance> appearances; ///< Only of shapes that have their own color.
    std::vector<std::string> warnings;   ///< Features of the file that were approximated or left out.
    std::vector<VisualMesh> visuals{};
    std::vector<JointAppearance> joint_appearances{}; ///< Only of joints that are shown.
    /// Joints of the file that are not in the world: joints without a dynamic body, and joints with more limits and
    /// drives than a joint can have. They have no effect, and are saved with the others.
    std::vector<JointDef> idle_joints{};
    /// Names of the layers in the shapes' collision filters: entry i is the name of bit i + 1. Bit 0 is the layer of
    /// shapes in no named layer. Layers without a name are saved with their number as the name.
    std::vector<std::string> collision_systems{};
    std::vector<JointSpeedLimit> speed_limits{}; ///< Of robots; not saved.
    /// Bodies that an editor treats as a group, two or more in each; a body is in at most one group.
    std::vector<std::vector<BodyId>> groups{};
};

/// Options for reading a file.
struct LoadOptions {
    bool fixed_base =
        false; ///< The base of a robot (URDF, MJCF, SDF) does not move. Refused (`unsupported`) for other files.
    /// Meshes on moving bodies are decomposed into convex parts even where the file does not ask for it
    /// (scene/decomposition.h).
    bool decompose = false;
    /// Receives every command that builds the world, from the empty world on (`World::set_command_listener`): a
    /// recorder, for example. Null: none.
    std::shared_ptr<CommandListener> listener{};
};

/// Reads a `.gltf`, `.glb` or URDF file (docs/urdf.md); the format is recognized by its first bytes, not by its name.
Scene load(const std::filesystem::path& path, const LoadOptions& options = {});

/// Adds a static body "floor", an infinite plane that faces up, at the height of the lowest point of all shapes, or at
/// y = 0 if there are none. Triggers and infinite shapes do not count.
void add_floor(Scene& scene);

/// Reads a scene from memory. `name` stands for the file in messages. Buffers in other files are refused.
Scene load_from_memory(std::span<const std::byte> bytes, const std::string& name);

/// Returns the present state of the scene as the text of a `.gltf` file, with embedded mesh data. A scene that `load`
/// reads from it is saved as the same bytes. Data of shapes and bodies that have been removed is left out.
std::string save_to_string(const Scene& scene);

/// Writes a scene to a file: a binary `.glb` if its name ends so, else `.gltf` as by `save_to_string`.
/// files/output_file.h documents how the file is replaced.
void save(const Scene& scene, const std::filesystem::path& path);

/// The `.gltf` and `.glb` files of a folder (not those of its subfolders), sorted by name. Throws `Error` (io).
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& directory);

/// An entry of a list of scenes.
struct SceneEntry {
    std::filesystem::path path;
    std::string name; ///< The file's name without its extension.
    std::string title, hint;
    std::size_t bodies = 0; ///< All kinds.
    std::string error;      ///< Why the file cannot be used; empty if it can.
};

/// The titles and hints of the `scene_files`, in the same order. Builds no worlds.
std::vector<SceneEntry> list_scenes(const std::filesystem::path& directory);

/// The folder of the scenes that come with Cairn: the environment variable CAIRN_SCENES if it is set, else
/// `../share/cairn/scenes` beside the program's own folder, else `scenes` of the source tree that the program was built
/// from.
std::filesystem::path scenes_directory();

/// Returns the file that a name given by a user stands for: a path to an existing file, or the name of a scene in
/// `scenes_directory()`, with or without its leading number and its extension, or that number alone
/// (`01_open_plane.gltf`, `01_open_plane`, `open_plane`, `01`, `1`). Throws `Error`: `io` if there is none,
/// `invalid_value` if the name is ambiguous.
std::filesystem::path find_scene(std::string_view path_or_name);

/// The same for a name in `scenes_directory()` only, never a path.
std::filesystem::path find_named_scene(std::string_view name);

} // namespace cairn::scene
