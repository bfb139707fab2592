// The prims of a text layer of USD where they stand: what its readers have in common.
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

// A prim and what it has from those above it.
struct UsdPlace {
    const UsdPrim* prim = nullptr;
    Affine world;                      // from its own space to ours, in meters and with y up
    Affine above;                      // the same of the prim above
    const UsdPrim* body = nullptr;     // the rigid body that it belongs to
    std::vector<const UsdPrim*> chain; // itself and those above, from the root down
    bool is_seen = true;
};

// Knows all prims by their paths, and notes what is asked for.
class UsdStage {
  public:
    UsdStage(const UsdLayer& layer, std::string name);

    double meters() const { return meters_; }                       // of a unit of the file
    const std::vector<UsdPlace>& places() const { return places_; } // in the order of the file
    const UsdPlace* find(const std::string& path) const;
    std::string place(const UsdPrim& prim) const; // box.usda:12: Cube </World/Box>
    const Affine& root() const { return root_; }

    // Null if the prim has no such property; it counts as read.
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

    // One line that names what of physics nobody has asked for, and what of the layer is not followed.
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

// The nearest property of that name on the prim or above it.
const UsdValue* inherited(const UsdStage& stage, const UsdPlace& place, const std::string& name);

// A shape of a prim in the frame of `body`, of static bodies triangles where the file asks for them.
struct UsdSolid {
    std::optional<Shape> shape;
    Rigid at;                               // of the shape
    std::shared_ptr<const Surface> surface; // of a mesh, in the frame of the body
    bool is_cut = false;                    // into convex parts, which are also in the frame of the body
};
UsdSolid usd_solid(const UsdStage& stage, const UsdPlace& place, const Rigid& body, bool is_static, bool decomposes,
                   std::vector<std::string>& warnings);

// The triangles of a mesh, in the frame of `body`, with its places in textures, and each with vertices of its own. Null
// without primvars:st. Throws Error as `usd_solid` does.
std::shared_ptr<const Surface> usd_covered_surface(const UsdStage& stage, const UsdPlace& place, const Rigid& body);

// Joints between bodies, by the prims of those.
void add_usd_joints(const UsdStage& stage, const std::map<const UsdPrim*, BodyId>& bodies,
                    std::vector<std::string>& warnings, Scene& scene);

Affine inverse_of(const Rigid& frame);

} // namespace cairn::scene
