// The prims of a USD text layer with their transforms; shared by the readers of shapes, joints and looks.
#pragma once

#include "scene/model_body.h"
#include "scene/node_transform.h"
#include "scene/usd_text.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::scene {

// A prim and the properties it inherits from the prims above it.
struct UsdPlace {
    const UsdPrim* prim = nullptr;
    Affine world;                      // from the space of the prim to the world, in meters and with y up
    Affine above;                      // the same map for the parent prim
    const UsdPrim* body = nullptr;     // the rigid body that the prim belongs to
    std::vector<const UsdPrim*> chain; // the prim and its ancestors, from the root down
    bool is_seen = true;
};

// Finds prims by their paths, and records which properties are read.
class UsdStage {
  public:
    UsdStage(const UsdLayer& layer, std::string name);

    double meters() const { return meters_; }                       // meters per unit of the file
    const std::vector<UsdPlace>& places() const { return places_; } // in the order of the file
    const UsdPlace* find(const std::string& path) const;
    std::string place(const UsdPrim& prim) const; // for messages: box.usda:12: Cube </World/Box>
    const Affine& root() const { return root_; }

    // Returns null if the prim has no such property; the property counts as read.
    const UsdValue* value(const UsdPrim& prim, const std::string& name) const;
    double number(const UsdPrim& prim, const std::string& name, double otherwise) const; // may be infinite
    double number(const UsdPrim& prim, const std::string& name, double otherwise, double least, double most) const;
    bool flag(const UsdPrim& prim, const std::string& name, bool otherwise) const;
    std::string word(const UsdPrim& prim, const std::string& name, const std::string& otherwise = "") const;
    glm::dvec3 vector3(const UsdPrim& prim, const std::string& name, const glm::dvec3& otherwise) const;
    glm::dquat rotation(const UsdPrim& prim, const std::string& name) const; // real part first
    [[noreturn]] void fail(const UsdPrim& prim, const std::string& property, const std::string& expected) const;
    bool has(const UsdPrim& prim, std::string_view schema) const;
    void know_type(const char* type) const { known_types_.insert(type); }

    // Returns a warning on one line that lists physics properties that were not read, and unsupported features of the
    // layer.
    std::optional<std::string> unused() const;

  private:
    void visit(const UsdPrim& prim, const UsdPlace& above, const Affine& world);
    Affine transform(const UsdPrim& prim, bool& resets) const;
    Affine operation(const UsdPrim& prim, const std::string& name) const;

    const UsdLayer& layer_;
    std::string name_;
    double meters_ = 0.01;
    Affine root_;
    std::vector<UsdPlace> places_;
    std::map<std::string, std::size_t> by_path_;
    mutable std::set<std::string> asked_, known_types_, known_schemas_;
};

// Returns the nearest property of that name on the prim or above it.
const UsdValue* inherited(const UsdStage& stage, const UsdPlace& place, const std::string& name);

// The shape of a prim in the frame of `body`. A mesh of a static body stays triangles where the file asks for that.
struct UsdSolid {
    std::optional<Shape> shape;
    Rigid at;                               // pose of the shape
    std::shared_ptr<const Surface> surface; // of a mesh, in the frame of the body
    bool is_cut = false;                    // decomposed into convex parts, which are also in the frame of the body
};
UsdSolid usd_solid(const UsdStage& stage, const UsdPlace& place, const Rigid& body, bool is_static, bool decomposes,
                   std::vector<std::string>& warnings);

// Returns the triangles of a mesh, in the frame of `body`, with texture coordinates; no two triangles share vertices.
// Null without primvars:st. Throws Error as `usd_solid` does.
std::shared_ptr<const Surface> usd_covered_surface(const UsdStage& stage, const UsdPlace& place, const Rigid& body);

// Adds the joints; `bodies` maps the prims of rigid bodies to their ids.
void add_usd_joints(const UsdStage& stage, const std::map<const UsdPrim*, BodyId>& bodies,
                    std::vector<std::string>& warnings, Scene& scene);

Affine inverse_of(const Rigid& frame);

} // namespace cairn::scene
