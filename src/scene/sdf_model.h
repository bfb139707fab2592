// An SDF file between its XML and the world: frames, links and joints by their places.
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
    std::size_t scope = 0;                  // whose names it refers to
    std::size_t base = sdf_none;            // the frame that counts where it names none; of the world: none
    Rigid pose;                             // in the frame that it refers to
    std::optional<XmlText> relative_to;     // instead of the base
    std::optional<XmlText> attached_to;     // a frame: what it moves with
    std::optional<XmlText> placement_frame; // of a model: the frame in it that its pose is of
    std::size_t link = sdf_none;            // of a link
    std::size_t model = sdf_none;           // of a model: its scope
    std::string place;                      // in the file
};

// The names of a model, or of the world.
struct SdfScope {
    std::size_t parent = 0;
    std::string prefix;                                // of the names of its links, "outer::inner::"
    std::string folder;                                // of the file that it comes from, in the folder of the main file
    std::size_t frame = 0;                             // of its own
    std::map<std::string, std::size_t> frames, models; // by name; of models, the scopes
    std::size_t canonical = sdf_none;                  // the link that its own frame moves with
    bool is_static = false, collides_itself = false, has_old_axes = false;
};

struct SdfLink {
    std::string name;
    std::size_t frame = 0, scope = 0;
    std::string place;
    bool is_static = false, is_kinematic = false;
    ModelBody body;                 // its poses are in the link
    std::vector<unsigned> bitmasks; // of its shapes
};

struct SdfJoint {
    XmlElement element;
    std::size_t frame = 0, scope = 0;
};

struct SdfModel {
    std::vector<SdfScope> scopes; // the first is the world
    std::vector<SdfFrame> frames; // the first is the world's
    std::vector<SdfLink> links;
    std::vector<SdfJoint> joints;
    std::vector<std::string> warnings;
    bool decomposes = false; // meshes that move
    SurfaceParts surface_parts;

    // The frame of that name, as seen from a scope. Throws through `name` if there is none.
    std::size_t find(std::size_t scope, const XmlText& name) const;
    // Where a frame stands in the world of the file.
    Rigid world(std::size_t frame, int depth = 0) const;
    // The link that a frame moves with; none for the world.
    std::size_t link_of(std::size_t frame, int depth = 0) const;

  private:
    std::size_t base_of(const SdfFrame& frame) const;
    Rigid in_model(std::size_t frame, std::size_t model, int depth) const;
};

// The pose that an element has as its child, and what it is relative to.
struct SdfPose {
    Rigid pose;
    std::optional<XmlText> relative_to;
};
SdfPose read_sdf_pose(const XmlElement& owner);

// Where the file is that a URI means: a path in the folder of the main file. Empty if it is none of that kind.
std::string sdf_path(const std::string& uri, const std::string& folder, const std::filesystem::path& root);

// Collisions, looks and mass of a link; their frames must be known.
void read_sdf_link(const XmlElement& element, std::size_t link, const std::optional<std::filesystem::path>& root,
                   ModelMeshes& meshes, SdfModel& model);

// Links that fixed joints hold together are one body.
struct SdfBodies {
    std::vector<std::size_t> body_of_link; // index of the ids below; sdf_none: the world
    std::vector<Rigid> worlds;             // of the bodies
    std::vector<BodyId> ids;
};
void add_sdf_joints(const SdfModel& model, const SdfBodies& bodies, std::vector<std::string>& warnings, Scene& scene);

} // namespace cairn::scene
