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

/// Where a scene is best looked at from.
struct Camera {
    Position position{6.0, 4.0, 10.0};  ///< Meters.
    Position target{0.0, 1.0, 0.0};     ///< The point in the middle of the picture, meters; not the position.
    float vertical_fov_degrees = 45.0f; ///< Full angle from the bottom to the top of the picture, 1 to 170.
    /// Its rays are parallel: at any distance the picture shows as much as that angle does at the distance of the
    /// target.
    bool is_orthographic = false;
};

/// A light, as KHR_lights_punctual has it.
struct Light {
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    Vec3 color{1.0f, 1.0f, 1.0f};      ///< Linear.
    float intensity = 1.0f;            ///< Lux of a directional light, candela of others.
    Position position{0.0, 0.0, 0.0};  ///< Meters; of no meaning for a directional one.
    Vec3 towards{0.0f, 1.0f, 0.0f};    ///< Unit, against the way it shines; of no meaning for a point.
    float range = 0.0f;                ///< Meters, beyond which it does not shine; 0: it has no end.
    float inner_cone = 0.0f;           ///< Of a spot: rad from its axis up to which it shines in full,
    float outer_cone = 0.78539816339f; ///< and where its light ends.
};

/// What a scene says about itself beside its bodies.
struct SceneInfo {
    std::string title;                    ///< A few words.
    std::string hint;                     ///< One line on what to watch or try.
    float time_step = 1.0f / 60.0f;       ///< s, 0.0001 to 1: the step that the scene is meant for.
    std::optional<Camera> camera;         ///< Absent: choose a view of your own.
    std::vector<Light> lights;            ///< Where they are at the beginning, and they stay there.
    std::vector<ForceField> force_fields; ///< Those in the world; `Scene::force_fields` has their handles.
};

/// The color that a file gives to a shape.
struct Appearance {
    BodyId body;
    ShapeId shape;
    Vec3 color{1.0f, 1.0f, 1.0f}; ///< Linear red, green and blue, each 0 to 1.
};

/// A joint that is to be seen: as a string from one of its places to the other.
struct JointAppearance {
    JointId joint;
    Vec3 color{1.0f, 1.0f, 1.0f}; ///< Linear red, green and blue, each 0 to 1.
};

/// A picture that covers a surface, as a file has it.
struct Texture {
    enum class Wrap { repeat, mirror, clamp };
    std::shared_ptr<const std::string> file; ///< A whole PNG or JPEG file, not looked into. Its colors are sRGB.
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat; ///< How it goes on beyond its edges.
    bool is_smooth = true;     ///< Seen closely, colors go over into each other; or each texel is flat.
    float alpha_cutoff = 0.0f; ///< Where its alpha, 0 to 1, is less, nothing is drawn.
    bool is_data = false;      ///< Its texels are numbers, not colors in sRGB.
};

/// How a surface meets the light, beside its color. Textures lie where that of the color lies.
struct Finish {
    float roughness = 1.0f;                 ///< 0, a mirror, to 1.
    float metalness = 0.0f;                 ///< 0, or 1: a metal, which mirrors in its own color and has no other.
    std::shared_ptr<const Texture> rough{}; ///< Null: none. Green multiplies `roughness`, blue `metalness`.
    /// Null: none. Normals as colors, 0 to 1 for -1 to 1: red to the right in the texture, green up, blue outward.
    std::shared_ptr<const Texture> normals{};
    float normal_scale = 1.0f;              ///< Multiplies red and green of `normals`.
    Vec3 glow{0.0f, 0.0f, 0.0f};            ///< Light of the surface itself, linear, 0 to 1 each,
    float glow_strength = 1.0f;             ///< times this, >= 0.
    std::shared_ptr<const Texture> glows{}; ///< Null: none. Its colors are multiplied with `glow`.
};

/// By how much each of up to four bones carries a vertex. The shares come to 1.
struct BoneWeights {
    std::array<std::uint16_t, 4> bones{}; ///< Indices into `VisualMesh::bones`.
    std::array<float, 4> shares{1.0f, 0.0f, 0.0f, 0.0f};
};

/// What carries a part of a mesh that bends.
struct Bone {
    BodyId body; ///< Null: it stands still.
    /// From the coordinates of the mesh to the frame of the body, or to the world.
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0, 0.0, 0.0}; ///< Meters.
};

/// Triangles to look at. It never changes once it is in a scene, so that many meshes may share it.
struct Surface {
    std::vector<Vec3> vertices;         ///< Meters.
    std::vector<Vec3> normals;          ///< Unit length, one for each vertex; or none: draw flat triangles.
    std::vector<std::uint32_t> indices; ///< Three a triangle, counterclockwise as seen from outside; all in range.
    /// Where in a texture each vertex lies, one for each, or none: u to the right and v down, 0 to 1 across the
    /// picture.
    std::vector<glm::vec2> coordinates{};
    std::vector<BoneWeights> weights{}; ///< Of a mesh with bones: one for each vertex.
    std::vector<Vec3> colors{};         ///< Linear, 0 to 1, one for each vertex, or none: multiply that of the mesh.
};

/// A mesh that the file has for looks. It plays no part in the simulation, and moves with its body. A body that has
/// any is best shown by them instead of by its shapes.
struct VisualMesh {
    BodyId body;     ///< Null: scenery, which belongs to no body.
    Transform local; ///< In the frame of the body; of scenery, in the world.
    std::shared_ptr<const Surface> surface;
    Vec3 color{1.0f, 1.0f, 1.0f};             ///< Linear red, green and blue, each 0 to 1.
    std::shared_ptr<const Texture> texture{}; ///< Null: none. Its colors are multiplied with `color`.
    /// None: it is rigid. Else it bends: each vertex is where its bones carry it, by their shares in it, on the mean;
    /// `body` is null, and `local` means nothing.
    std::vector<Bone> bones{};
    std::shared_ptr<const Finish> finish{}; ///< Null: smooth, as of plastic.
};

/// How fast a joint of a robot may be driven. The engine's motors know no such limit: it is for who moves their
/// targets.
struct JointSpeedLimit {
    JointId joint;
    float speed = 0.0f; ///< rad/s or m/s, > 0.
};

/// A world and what came with it.
struct Scene {
    World world;
    SceneInfo info;
    std::vector<ForceFieldId> force_fields;
    std::vector<Appearance> appearances; ///< Only of shapes that have a color of their own.
    std::vector<std::string> warnings;   ///< What the file asks for that was done another way, or left out.
    std::vector<VisualMesh> visuals{};
    std::vector<JointAppearance> joint_appearances{}; ///< Only of joints that are to be seen.
    /// Joints of the file that are not in the world: those that join no dynamic body, and those with more limits and
    /// drives than a joint can have. They do nothing, and are saved with the others.
    std::vector<JointDef> idle_joints{};
    /// Names of the layers in the shapes' collision filters: the i-th is that of bit i + 1. Bit 0 is for what is in no
    /// named layer. Others get a name of their number when they are saved.
    std::vector<std::string> collision_systems{};
    std::vector<JointSpeedLimit> speed_limits{}; ///< Of robots; not saved.
    /// Bodies that belong together for who edits the scene, two or more in each; a body is in one at most.
    std::vector<std::vector<BodyId>> groups{};
};

/// How a file is read.
struct LoadOptions {
    bool fixed_base =
        false; ///< The base of a robot (URDF, MJCF, SDF) does not move. Of others: refused (`unsupported`).
    /// Meshes on bodies that move are cut into convex parts also where the file does not ask for it
    /// (scene/decomposition.h).
    bool decompose = false;
    /// Is told of everything that makes the world, from when it is empty (`World::set_command_listener`): a recorder,
    /// for example. Null: nobody.
    std::shared_ptr<CommandListener> listener{};
};

/// Reads a `.gltf`, `.glb` or URDF file (docs/urdf.md); which of them it is shows in its first bytes, not in its name.
Scene load(const std::filesystem::path& path, const LoadOptions& options = {});

/// Adds a static body "floor", an infinite plane that faces up, as high as the lowest point of all shapes, or where
/// there are none at y = 0. Triggers and what is infinite do not count.
void add_floor(Scene& scene);

/// Reads a scene from memory. `name` stands for the file in messages. Buffers in other files are refused.
Scene load_from_memory(std::span<const std::byte> bytes, const std::string& name);

/// The scene as it stands now, as the text of a `.gltf` file, with the data of meshes in it. What `load` reads from it
/// is saved again as the same bytes. What belongs to shapes and bodies that have been removed is left out.
std::string save_to_string(const Scene& scene);

/// Writes a scene to a file: a binary `.glb` if its name ends so, else `.gltf` as by `save_to_string`. How is said in
/// files/output_file.h.
void save(const Scene& scene, const std::filesystem::path& path);

/// The `.gltf` and `.glb` files of a folder (not those of its subfolders), sorted by name. Throws `Error` (io).
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& directory);

/// One line of a list of scenes.
struct SceneEntry {
    std::filesystem::path path;
    std::string name; ///< The file's name without its extension.
    std::string title, hint;
    std::size_t bodies = 0; ///< All kinds.
    std::string error;      ///< Why the file cannot be used; empty if it can.
};

/// What the files of `scene_files` say of themselves, in that order. Builds no worlds.
std::vector<SceneEntry> list_scenes(const std::filesystem::path& directory);

/// The folder of the scenes that come with Cairn: the environment variable CAIRN_SCENES if it is set, else
/// `../share/cairn/scenes` beside the program's own folder, else `scenes` of the source tree that it was
/// built from.
std::filesystem::path scenes_directory();

/// The file that a user means: a path to an existing file, or the name of a scene in `scenes_directory()`,
/// with or without its leading number and its extension, or that number alone (`01_open_plane.gltf`, `01_open_plane`,
/// `open_plane`, `01`, `1`). Throws `Error`: `io` if there is none, `invalid_value` if several are meant.
std::filesystem::path find_scene(std::string_view path_or_name);

/// The same for such a name alone, whatever files there are.
std::filesystem::path find_named_scene(std::string_view name);

} // namespace cairn::scene
