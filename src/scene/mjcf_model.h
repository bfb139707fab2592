// An MJCF model between the file and the world: bodies, their joints and what stands on them.
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

// What drives a coordinate of a joint: force = stiffness (position - q) + damping (velocity - q') + force.
struct MjcfDrive {
    double stiffness = 0.0, damping = 0.0;
    double stiffness_position = 0.0, damping_velocity = 0.0, force = 0.0; // sums over all that drives it
    double most = 0.0;                                                    // sum of the bounds of the force
    bool is_driven = false, is_bounded = true;                            // by actuators; all of them have a bound
};

struct MjcfJoint {
    enum class Kind { free, ball, hinge, slide };
    Kind kind = Kind::hinge;
    std::string name, place;
    glm::dvec3 anchor{0.0}, axis{0.0, 0.0, 1.0}; // in its body
    std::size_t part = 0;
    double reference = 0.0;                          // of a hinge or slide: the coordinate as the model is drawn
    double start = 0.0, speed = 0.0;                 // that coordinate, and its rate, when the world begins
    glm::dquat start_turn{1.0, 0.0, 0.0, 0.0};       // of a ball joint
    Rigid start_pose;                                // of a free joint
    glm::dvec3 start_velocity{0.0}, start_spin{0.0}; // of free and ball joints
    std::optional<std::pair<double, double>> range;
    std::optional<double> effort;
    double stiffness = 0.0, damping = 0.0, rest = 0.0, friction = 0.0, armature = 0.0;
    MjcfDrive drive;
    JointId id; // null if it became no joint of its own kind

    bool is_scalar() const { return kind == Kind::hinge || kind == Kind::slide; }
    // What it moves its body by when its coordinate is `by` more than as the model is drawn; in the frame of the body.
    Rigid motion(double by) const;
};

struct MjcfGeom {
    std::string name, place;
    std::optional<ModelShape> shape; // none: only to be seen
    std::optional<ModelLook> look;   // none: not to be seen; without a surface: that of the shape
    unsigned contype = 1, conaffinity = 1;
};

// Bodies that no joint parts.
struct MjcfPart {
    enum class Kind { fixed, mocap, moving };
    Kind kind = Kind::moving;
    ModelBody body; // its `world` is where it stands as the model is drawn until `MjcfTree::place`
    std::size_t parent = 0;
    Rigid frame; // in the parent, as the model is drawn
    Rigid drawn; // in the world of the file, as the model is drawn
    std::vector<std::size_t> joints;
    std::vector<MjcfGeom> geoms;
    bool lacks_looks = false; // something of it cannot be shown
    BodyId id;                // null: the world, where nothing stands
    double own_mass = 0.0;
};

struct MjcfAttached {
    std::size_t part = 0;
    Rigid at; // in the part
};

struct MjcfModel {
    const MjcfSettings& settings;
    const MjcfDefaults& defaults;
    std::vector<MjcfPart> parts; // parents first; the first is the world
    std::vector<MjcfJoint> joints;
    std::map<std::string, MjcfAttached> bodies, sites;
    std::map<std::string, std::size_t> joint_names;
    bool is_whole = true; // false: elements that are not read may have had bodies and joints of their own
    std::vector<std::string> warnings;
    bool decomposes = false; // meshes that move
    SurfaceParts surface_parts{};

    const MjcfJoint* joint(const XmlText& name); // throws, or null where the model is not whole
};

// What a geom looks like by its material.
struct MjcfMaterial {
    std::optional<XmlText> color;
    std::shared_ptr<const Texture> texture; // none: not covered
    Vec3 tint{1.0f, 1.0f, 1.0f};            // linear: the color of a flat texture around the geom
    std::array<double, 2> repeat{1.0, 1.0}; // how often the texture lies across the geom, or across 2 m
    bool is_uniform = false;                // across 2 m
};

class MjcfAssets {
  public:
    MjcfAssets(const XmlElement& root, const MjcfSettings& settings, const MjcfDefaults& defaults,
               std::optional<std::filesystem::path> folder);
    // Throw Error through `name` if there is none of that name, or if its file cannot be read.
    std::shared_ptr<const Surface> mesh(const XmlText& name);
    HeightField height_field(const XmlText& name);
    // The mesh to look at.
    std::shared_ptr<const Surface> look(const XmlText& name);
    // Nothing if there is none of that name. A texture that cannot be shown is left out, which a warning says.
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

// The surface of a geom with its places in the texture of its material: those of its file, or else, as in MuJoCo, those
// seen along its z axis. `half_sizes`: of the geom along x and y; 0 of what has no end.
Surface mjcf_covered(const Surface& surface, const Rigid& in_geom, const MjcfMaterial& material,
                     const glm::dvec2& half_sizes);
// The picture that a texture describes in words, as a PNG file.
std::string mjcf_builtin_picture(const MjcfElement& texture);

// Adds a geom that stands at `frame` in the part, and its mass if `has_mass`.
void add_mjcf_geom(const MjcfElement& element, const Rigid& frame, bool has_mass, const std::string& suffix,
                   MjcfPart& part, MjcfAssets& assets, MjcfModel& model);

// Goes through the world body. With `fixed_base`, free joints hold.
void read_mjcf_bodies(const XmlElement& root, bool fixed_base, MjcfAssets& assets, MjcfModel& model);

// Where all parts stand when the world begins, by the first key frame if there is one. Returns its control values.
std::vector<double> place_mjcf_parts(const XmlElement& root, MjcfModel& model);

// What the actuators add to the drives of joints.
void read_mjcf_actuators(const XmlElement& root, const std::vector<double>& control, MjcfModel& model);

// Which geoms meet, by contype, conaffinity and pairs.
void set_mjcf_filters(const XmlElement& root, MjcfModel& model, Scene& scene);

// Joints between the parts, whose bodies are in the scene; some make bodies of their own.
void add_mjcf_joints(MjcfModel& model, Scene& scene);
// Equality constraints, and what does not collide.
void add_mjcf_constraints(const XmlElement& root, MjcfModel& model, Scene& scene);

} // namespace cairn::scene
