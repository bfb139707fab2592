// The intermediate form of an MJCF model between the file and the world: bodies, their joints, geoms and sites.
#pragma once

#include "scene/decomposition.h"
#include "scene/mjcf_settings.h"
#include "scene/model_body.h"
#include "scene/model_meshes.h"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cairn::scene {

// The drive of a joint coordinate: force = stiffness (position - q) + damping (velocity - q') + force.
struct MjcfDrive {
    double stiffness = 0.0, damping = 0.0;
    // Sums over all actuators and springs of the coordinate.
    double stiffness_position = 0.0, damping_velocity = 0.0, force = 0.0;
    double most = 0.0;                         // sum of the force bounds
    bool is_driven = false, is_bounded = true; // whether actuators drive it; whether all of them are bounded
};

struct MjcfJoint {
    enum class Kind { free, ball, hinge, slide };
    Kind kind = Kind::hinge;
    std::string name, place;
    glm::dvec3 anchor{0.0}, axis{0.0, 0.0, 1.0}; // in the frame of the body
    std::size_t part = 0;
    double reference = 0.0;                    // of a hinge or slide: the coordinate in the pose of the model file
    double start = 0.0, speed = 0.0;           // initial value and rate of that coordinate
    glm::dquat start_turn{1.0, 0.0, 0.0, 0.0}; // of a ball joint
    Rigid start_pose;                          // of a free joint
    glm::dvec3 start_velocity{0.0}, start_spin{0.0}; // of free and ball joints, initial
    std::optional<std::pair<double, double>> range;
    std::optional<double> effort;
    double stiffness = 0.0, damping = 0.0, rest = 0.0, friction = 0.0, armature = 0.0;
    MjcfDrive drive;
    JointId id; // null if the joint was not converted to a single joint of its own kind

    bool is_scalar() const { return kind == Kind::hinge || kind == Kind::slide; }
    // The displacement of the body, in its own frame, when the coordinate is greater by `by` than in the pose of the
    // file.
    Rigid motion(double by) const;
};

struct MjcfGeom {
    std::string name, place;
    std::optional<ModelShape> shape; // none: a visual only
    std::optional<ModelVisual> look; // none: invisible; without a surface: shown as the shape
    unsigned contype = 1, conaffinity = 1;
};

// A rigid part: one or more MJCF bodies that are not separated by joints.
struct MjcfPart {
    enum class Kind { fixed, mocap, moving };
    Kind kind = Kind::moving;
    ModelBody body; // its `world` is the pose in the model file until `MjcfTree::place`
    std::size_t parent = 0;
    Rigid frame; // in the parent, in the pose of the model file
    Rigid drawn; // in the world of the file, in the pose of the model file
    std::vector<std::size_t> joints;
    std::vector<MjcfGeom> geoms;
    bool lacks_looks = false; // some of its geoms cannot be shown
    BodyId id;                // null: the static world without any shape
    double own_mass = 0.0;
};

struct MjcfAttached {
    std::size_t part = 0;
    Rigid at; // in the frame of the part
};

struct MjcfModel {
    const MjcfSettings& settings;
    const MjcfDefaults& defaults;
    std::vector<MjcfPart> parts; // parents come first; the first part is the world
    std::vector<MjcfJoint> joints;
    std::map<std::string, MjcfAttached> bodies, sites;
    std::map<std::string, std::size_t> joint_names;
    bool is_whole = true; // false: elements that are not read may have contained bodies and joints
    std::vector<std::string> warnings;
    bool decomposes = false; // whether moving meshes are decomposed into convex parts
    SurfaceParts surface_parts{};

    const MjcfJoint* joint(const XmlText& name); // throws, or returns null where the model is not whole
};

// The appearance of a geom according to its material.
struct MjcfMaterial {
    std::optional<XmlText> color;
    std::shared_ptr<const Texture> texture; // none: no texture
    Vec3 tint{1.0f, 1.0f, 1.0f};            // linear; mean color of a flat cube texture, which is not mapped
    std::array<double, 2> repeat{1.0, 1.0}; // how often the texture repeats across the geom, or across 2 m
    bool is_uniform = false;                // true: `repeat` is per 2 m
};

class MjcfAssets {
  public:
    MjcfAssets(const XmlElement& root, const MjcfSettings& settings, const MjcfDefaults& defaults,
               std::optional<std::filesystem::path> folder);
    // The functions throw Error through `name` if there is no asset of that name, or if its file cannot be read.
    std::shared_ptr<const Surface> mesh(const XmlText& name);
    HeightField height_field(const XmlText& name);
    // Returns the mesh for visuals.
    std::shared_ptr<const Surface> look(const XmlText& name);
    // Returns nothing if there is no material of that name. A texture that cannot be shown is left out, with a warning.
    std::optional<MjcfMaterial> material(const XmlText& name, std::vector<std::string>& warnings);

  private:
    std::shared_ptr<const Texture> read_texture(const MjcfElement& element);
    std::shared_ptr<const Surface> read_mesh(const MjcfElement& element, bool is_look);
    const MjcfElement& find(const std::map<std::string, MjcfElement>& list, const XmlText& name) const;
    const MjcfSettings& settings_;
    ModelMeshes files_;
    std::map<std::string, MjcfElement> meshes_, fields_, materials_, textures_;
    std::map<std::string, std::shared_ptr<const Surface>> read_, looks_;
    std::map<std::string, MjcfMaterial> read_materials_;
};

// Returns the surface of a geom with coordinates in the texture of its material: those of its file, or else, as in
// MuJoCo, a projection along its z axis. `half_sizes`: of the geom along x and y; 0 where it is infinite.
Surface mjcf_covered(const Surface& surface, const Rigid& in_geom, const MjcfMaterial& material,
                     const glm::dvec2& half_sizes);
// Returns the picture of a procedural texture as a PNG file.
std::string mjcf_builtin_picture(const MjcfElement& texture);

// Adds a geom with the pose `frame` in the part, and its mass if `has_mass`.
void add_mjcf_geom(const MjcfElement& element, const Rigid& frame, bool has_mass, const std::string& suffix,
                   MjcfPart& part, MjcfAssets& assets, MjcfModel& model);

// Reads the tree of bodies below the world body. With `fixed_base`, free joints are locked.
void read_mjcf_bodies(const XmlElement& root, bool fixed_base, MjcfAssets& assets, MjcfModel& model);

// Sets the initial poses of all parts, from the first keyframe if there is one. Returns the keyframe's control values.
std::vector<double> place_mjcf_parts(const XmlElement& root, MjcfModel& model);

// Adds the actuators to the drives of joints.
void read_mjcf_actuators(const XmlElement& root, const std::vector<double>& control, MjcfModel& model);

// Sets the collision filters of geoms from contype, conaffinity and pairs.
void set_mjcf_filters(const XmlElement& root, MjcfModel& model, Scene& scene);

// Adds the joints between the parts, whose bodies are in the scene; some joints need bodies of their own.
void add_mjcf_joints(MjcfModel& model, Scene& scene);
// Adds the equality constraints, and the excluded pairs.
void add_mjcf_constraints(const XmlElement& root, MjcfModel& model, Scene& scene);

} // namespace cairn::scene
