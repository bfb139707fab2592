// The intermediate form of an SDF file between its XML and the world: frames, links and joints with their poses.
#pragma once

#include "scene/decomposition.h"
#include "scene/model_body.h"
#include "scene/model_meshes.h"
#include "scene/xml_file.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t sdf_none = static_cast<std::size_t>(-1);

// A frame of reference that has a name: of a model, link, joint or frame.
struct SdfFrame {
    std::size_t scope = 0;                  // the scope in which its names are resolved
    std::size_t base = sdf_none;            // the default frame of its pose where it names none; sdf_none for the world
    Rigid pose;                             // in the frame that it is relative to
    std::optional<XmlText> relative_to;     // replaces the base
    std::optional<XmlText> attached_to;     // the frame that a frame element moves with
    std::optional<XmlText> placement_frame; // of a model: the frame in it whose pose `pose` is
    std::size_t link = sdf_none;            // the index, if it is the frame of a link
    std::size_t model = sdf_none;           // the scope, if it is the frame of a model
    std::string place;                      // in the file, for messages
};

// The namespace of a model, or of the world.
struct SdfScope {
    std::size_t parent = 0;
    std::string prefix;    // prefix of the names of its links, "outer::inner::"
    std::string folder;    // folder of the file that the model comes from, relative to that of the main file
    std::size_t frame = 0; // the frame of the model itself
    std::map<std::string, std::size_t> frames, models; // indices by name; `models` refers to scopes
    std::size_t canonical = sdf_none;                  // the canonical link, which the model's own frame moves with
    bool is_static = false, collides_itself = false, has_old_axes = false;
};

struct SdfLink {
    std::string name;
    std::size_t frame = 0, scope = 0;
    std::string place;
    bool is_static = false, is_kinematic = false;
    ModelBody body;                 // its poses are in the frame of the link
    std::vector<unsigned> bitmasks; // one for each shape
};

struct SdfJoint {
    XmlElement element;
    std::size_t frame = 0, scope = 0;
};

struct SdfModel {
    std::vector<SdfScope> scopes; // the first scope is the world
    std::vector<SdfFrame> frames; // the first frame is the world's
    std::vector<SdfLink> links;
    std::vector<SdfJoint> joints;
    std::vector<std::string> warnings;
    bool decomposes = false; // whether moving meshes are decomposed into convex parts
    SurfaceParts surface_parts;

    // Returns the frame of that name, resolved in a scope. Throws through `name` if there is none.
    std::size_t find(std::size_t scope, const XmlText& name) const;
    // Returns the pose of a frame in the world of the file.
    Rigid world(std::size_t frame, int depth = 0) const;
    // Returns the link that a frame moves with; sdf_none for the world.
    std::size_t link_of(std::size_t frame, int depth = 0) const;

  private:
    std::size_t base_of(const SdfFrame& frame) const;
    Rigid in_model(std::size_t frame, std::size_t model, int depth) const;
};

// The pose of an element, from its child `pose`, and the frame that it is relative to.
struct SdfPose {
    Rigid pose;
    std::optional<XmlText> relative_to;
};
SdfPose read_sdf_pose(const XmlElement& owner);

// Returns the path of the file that a URI refers to, relative to the folder of the main file. Empty for other kinds of
// URI.
std::string sdf_path(const std::string& uri, const std::string& folder, const std::filesystem::path& root);

// Reads collisions, visuals and mass of a link; the frames must be known.
void read_sdf_link(const XmlElement& element, std::size_t link, const std::optional<std::filesystem::path>& root,
                   ModelMeshes& meshes, SdfModel& model);

// Bodies of the model. Links that fixed joints connect are one body.
struct SdfBodies {
    std::vector<std::size_t> body_of_link; // index into `ids`; sdf_none: the world
    std::vector<Rigid> worlds;             // poses of the bodies
    std::vector<BodyId> ids;
};
void add_sdf_joints(const SdfModel& model, const SdfBodies& bodies, std::vector<std::string>& warnings, Scene& scene);

} // namespace cairn::scene
