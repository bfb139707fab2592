// Builds a world from a text layer of USD.
#include "scene/usd.h"

#include "scene/decomposition.h"
#include "scene/layers.h"
#include "scene/loaded_world.h"
#include "scene/mass_sum.h"
#include "scene/model_meshes.h"
#include "scene/tessellation.h"
#include "scene/usd_looks.h"
#include "scene/usd_stage.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

bool is_shape(const UsdPrim& prim) {
    for (const char* type : {"Cube", "Sphere", "Cylinder", "Capsule", "Cone", "Plane", "Mesh"}) {
        if (prim.type == type) return true;
    }
    return false;
}

bool is_below(const std::string& path, const std::string& top) {
    return path.substr(0, top.size()) == top && (path.size() == top.size() || path[top.size()] == '/');
}

class WorldMaker {
  public:
    WorldMaker(const UsdStage& stage, const std::optional<std::filesystem::path>& folder, bool decomposes, Scene& scene)
        : stage_(stage), looks_(stage, folder, scene.warnings), decomposes_(decomposes), scene_(scene) {}

    void make() {
        for (const char* type : {"PhysicsScene", "PhysicsCollisionGroup"}) stage_.know_type(type);
        read_gravity();
        read_groups();
        for (const UsdPlace& place : stage_.places()) {
            if (place.body == place.prim) begin_body(place);
        }
        for (const UsdPlace& place : stage_.places()) {
            if (is_shape(*place.prim)) add_shape(place);
        }
        set_filters();
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (bodies_[i].body.type == BodyType::dynamic) settle_mass(bodies_[i]);
            dress(bodies_[i]);
            ids_[bodies_[i].prim] = add_model_body(bodies_[i].body, scene_);
        }
        add_usd_joints(stage_, ids_, scene_.warnings, scene_);
    }

  private:
    struct Part {
        std::optional<ModelShape> shape;
        std::optional<ModelVisual> look;
        std::vector<std::size_t> groups, pairs;
        double mass = 0.0; // given by the file; 0: computed from the density
        double density = 0.0;
        std::optional<SolidMass> enclosed; // at 1 kg/m3, in the frame of the body
    };
    struct Made {
        const UsdPrim* prim = nullptr;
        ModelBody body;
        NodeTransform frame; // pose and scale of the body
        std::vector<Part> parts;
    };

    void read_gravity() {
        for (const UsdPlace& place : stage_.places()) {
            const UsdPrim& prim = *place.prim;
            if (prim.type != "PhysicsScene") continue;
            const double size = stage_.number(prim, "physics:gravityMagnitude", -1.0);
            const glm::dvec3 given = stage_.vector3(prim, "physics:gravityDirection", glm::dvec3(0.0));
            const double length = std::sqrt(glm::dot(given, given));
            glm::dvec3 direction(0.0, -1.0, 0.0);
            if (length > 1e-9 && length < 1e9) {
                direction = parts_of(stage_.root()).rotation * (given / length);
            }
            const double strength = size >= 0.0 && size < 1e30 ? size * stage_.meters() : 9.81;
            if (!(strength <= 1e6)) stage_.fail(prim, "physics:gravityMagnitude", "must be at most 1000000 m/s2");
            WorldDef settings = scene_.world.settings();
            settings.gravity = Vec3(direction * strength);
            scene_.world.set_settings(settings);
            return;
        }
    }

    // Reads collision groups, and pairs of prims that must not collide.
    void read_groups() {
        for (const UsdPlace& place : stage_.places()) {
            const UsdPrim& prim = *place.prim;
            if (prim.type == "PhysicsCollisionGroup") {
                group_of_[prim.path] = groups_.size();
                stage_.has(prim, "CollectionAPI:colliders");
                groups_.push_back(&prim);
            }
            if (!stage_.has(prim, "PhysicsFilteredPairsAPI")) continue;
            const UsdValue* others = stage_.value(prim, "physics:filteredPairs");
            for (const std::string& other : others ? others->words : std::vector<std::string>()) {
                const auto number = [&](const std::string& path) {
                    return pair_prims_.insert({path, pair_prims_.size()}).first->second;
                };
                const std::size_t a = number(prim.path), b = number(other);
                filtered_pairs_.insert(std::minmax(a, b));
            }
        }
        for (std::size_t i = 0; i < groups_.size(); ++i) {
            const UsdValue* filtered = stage_.value(*groups_[i], "physics:filteredGroups");
            for (const std::string& path : filtered ? filtered->words : std::vector<std::string>()) {
                const auto found = group_of_.find(path);
                if (found != group_of_.end()) filtered_groups_.insert(std::minmax(i, found->second));
            }
        }
    }

    Made& begin(const UsdPlace& place) {
        Made made;
        made.prim = place.prim;
        made.frame = parts_of(place.world);
        made.body.name = place.prim->name;
        made.body.place = stage_.place(*place.prim);
        made.body.world = {made.frame.translation, made.frame.rotation};
        index_[place.prim] = bodies_.size();
        bodies_.push_back(std::move(made));
        return bodies_.back();
    }

    void begin_body(const UsdPlace& place) {
        const UsdPrim& prim = *place.prim;
        Made& made = begin(place);
        const bool is_kinematic = stage_.flag(prim, "physics:kinematicEnabled", false);
        made.body.type = is_kinematic ? BodyType::kinematic : BodyType::dynamic;
        made.body.velocity = place.above.linear * speed(prim, "physics:velocity");
        made.body.angular_velocity = parts_of(place.above).rotation * speed(prim, "physics:angularVelocity") * degree;
    }
    glm::dvec3 speed(const UsdPrim& prim, const char* name) const {
        const glm::dvec3 v = stage_.vector3(prim, name, glm::dvec3(0.0));
        if (!(glm::dot(v, v) < 1e18)) stage_.fail(prim, name, "must be below 1e9");
        return v;
    }

    void add_shape(const UsdPlace& place) {
        const UsdPrim& prim = *place.prim;
        const bool touches =
            stage_.has(prim, "PhysicsCollisionAPI") && stage_.flag(prim, "physics:collisionEnabled", true);
        stage_.has(prim, "PhysicsMeshCollisionAPI");
        if (place.body == nullptr && !touches) return add_scenery(place);
        if (place.body == nullptr) begin(place).body.type = BodyType::static_;
        Made& owner = bodies_[index_.at(place.body ? place.body : place.prim)];
        Part part;
        const bool is_dynamic = owner.body.type == BodyType::dynamic;
        UsdSolid solid;
        try {
            solid = usd_solid(stage_, place, owner.body.world, !is_dynamic || !touches, decomposes_, scene_.warnings);
        } catch (const Error& error) {
            if (touches || error.code() == ErrorCode::invalid_file) throw;
            scene_.warnings.push_back(std::string(error.what()) + " (it is not shown)");
            return;
        }
        if (touches) {
            part.shape = ModelShape{*solid.shape, solid.at, {}, {}, {}, {}, looks_.color(place), stage_.place(prim)};
            if (solid.is_cut) part.shape->parts = surface_parts_.of(solid.surface);
            if (solid.surface) part.enclosed = surface_mass(*solid.surface, 1.0);
            read_material(place, part);
            note_filters(place, part);
        }
        if (place.is_seen) {
            part.look = ModelVisual{solid.surface, solid.surface ? Rigid() : solid.at};
            dress(place, owner.body.world, *part.look);
            if (!touches && !part.look->surface) {
                part.look->surface = std::make_shared<const Surface>(tessellate(*solid.shape));
            }
        }
        owner.parts.push_back(std::move(part));
    }

    void dress(const UsdPlace& place, const Rigid& body, ModelVisual& look) {
        try {
            looks_.dress(place, body, look);
        } catch (const Error& error) { // visuals do not affect the simulation
            scene_.warnings.push_back(std::string(error.what()) + " (its texture is left out)");
        }
    }

    void add_scenery(const UsdPlace& place) {
        if (!place.is_seen) return;
        try {
            const UsdSolid solid = usd_solid(stage_, place, Rigid(), true, false, scene_.warnings);
            ModelVisual look;
            look.surface = solid.surface ? solid.surface : std::make_shared<const Surface>(tessellate(*solid.shape));
            look.at = solid.surface ? Rigid() : solid.at;
            dress(place, Rigid(), look);
            scene_.visuals.push_back(
                {BodyId(), look.at.transform(), look.surface, look.color, look.texture, {}, look.finish});
        } catch (const Error& error) { // visuals do not affect the simulation
            if (error.code() == ErrorCode::invalid_file) throw;
            scene_.warnings.push_back(std::string(error.what()) + " (it is not shown)");
        }
    }

    const UsdPrim* material_of(const UsdPlace& place) const {
        for (const char* name : {"material:binding:physics", "material:binding"}) {
            const UsdValue* bound = inherited(stage_, place, name);
            const UsdPlace* found = bound && !bound->words.empty() ? stage_.find(bound->words[0]) : nullptr;
            if (found != nullptr && stage_.has(*found->prim, "PhysicsMaterialAPI")) return found->prim;
        }
        return nullptr;
    }

    void read_material(const UsdPlace& place, Part& part) {
        const UsdPrim* prim = material_of(place);
        const double meters = stage_.meters(), per_volume = 1.0 / (meters * meters * meters);
        if (prim != nullptr) {
            Material& material = part.shape->material;
            const auto friction = [&](const char* name) {
                return static_cast<float>(stage_.number(*prim, name, 0.0, 0.0, 1e6));
            };
            material.static_friction = friction("physics:staticFriction");
            material.dynamic_friction = friction("physics:dynamicFriction");
            material.restitution = static_cast<float>(stage_.number(*prim, "physics:restitution", 0.0, 0.0, 1.0));
            part.density = stage_.number(*prim, "physics:density", 0.0, 0.0, 1e12) * per_volume;
        }
        if (!stage_.has(*place.prim, "PhysicsMassAPI") || place.prim == place.body) return;
        part.mass = stage_.number(*place.prim, "physics:mass", 0.0, 0.0, 1e12);
        const double density = stage_.number(*place.prim, "physics:density", 0.0, 0.0, 1e12) * per_volume;
        if (density > 0.0) part.density = density;
    }

    void note_filters(const UsdPlace& place, Part& part) const {
        const std::string& path = place.prim->path;
        for (std::size_t i = 0; i < groups_.size(); ++i) {
            const UsdValue* members = stage_.value(*groups_[i], "collection:colliders:includes");
            for (const std::string& member : members ? members->words : std::vector<std::string>()) {
                if (is_below(path, member)) {
                    part.groups.push_back(i);
                    break;
                }
            }
        }
        for (const auto& [top, number] : pair_prims_) {
            if (is_below(path, top)) part.pairs.push_back(number);
        }
    }

    void set_filters() {
        using Kind = std::pair<std::vector<std::size_t>, std::vector<std::size_t>>;
        std::map<Kind, std::size_t> known;
        std::vector<Kind> kinds;
        for (Made& made : bodies_) {
            for (Part& part : made.parts) {
                if (part.shape && known.insert({{part.groups, part.pairs}, kinds.size()}).second) {
                    kinds.push_back({part.groups, part.pairs});
                }
            }
        }
        if (kinds.size() <= 1 && filtered_groups_.empty() && filtered_pairs_.empty()) return;
        if (kinds.size() > max_kinds) {
            throw Error(ErrorCode::unsupported, stage_.place(*bodies_[0].prim), {},
                        "must be in a layer with at most 63 combinations of collision groups and filtered pairs");
        }
        const auto share = [](const std::vector<std::size_t>& a, const std::vector<std::size_t>& b,
                              const std::set<std::pair<std::size_t, std::size_t>>& filtered) {
            for (const std::size_t i : a) {
                for (const std::size_t k : b) {
                    if (filtered.count(std::minmax(i, k)) != 0) return true;
                }
            }
            return false;
        };
        const auto filters = filters_of_kinds(kinds, [&](const Kind& a, const Kind& b) {
            return !share(a.first, b.first, filtered_groups_) && !share(a.second, b.second, filtered_pairs_);
        });
        for (std::size_t i = 0; i < kinds.size(); ++i)
            scene_.collision_systems.push_back("kind " + std::to_string(i + 1));
        for (Made& made : bodies_) {
            for (Part& part : made.parts) {
                if (part.shape) part.shape->filter = filters[known.at({part.groups, part.pairs})];
            }
        }
    }

    // Applies the mass properties that the body defines, which override those that follow from its colliders.
    void settle_mass(Made& made) {
        const UsdPrim& prim = *made.prim;
        stage_.has(prim, "PhysicsMassAPI");
        const double meters = stage_.meters();
        const double density = stage_.number(prim, "physics:density", 0.0, 0.0, 1e12) / (meters * meters * meters);
        MassSum sum;
        for (const Part& part : made.parts) {
            if (!part.shape) continue;
            SolidMass solid = part.enclosed ? *part.enclosed : shape_mass(part.shape->shape, 1.0);
            const Rigid at = part.enclosed ? Rigid() : part.shape->at;
            if (!(solid.mass > 0.0)) continue;
            const double own = part.mass > 0.0      ? part.mass / solid.mass
                               : part.density > 0.0 ? part.density
                               : density > 0.0      ? density
                                                    : 1000.0;
            sum.add(solid.mass * own, solid.inertia * own, at * Rigid{solid.center, {1.0, 0.0, 0.0, 0.0}});
        }
        const double given = stage_.number(prim, "physics:mass", 0.0, 0.0, 1e12);
        const glm::dvec3 inertia = stage_.vector3(prim, "physics:diagonalInertia", glm::dvec3(0.0));
        if (!(sum.mass() > 0.0)) {
            const double mass = given > 0.0 ? given : 1.0;
            sum.add(mass, fallback_inertia(mass), {});
            if (inertia == glm::dvec3(0.0)) {
                scene_.warnings.push_back(made.body.place + ": has no collider with mass; it is taken as a ball of " +
                                          std::to_string(mass) + " kg and 0.1 m radius");
            }
        }
        MassProperties properties = sum.properties();
        Rigid at{glm::dvec3(properties.center_of_mass), glm::dquat(properties.inertia_orientation)};
        glm::dvec3 moments(properties.inertia_diagonal);
        const double scale = given > 0.0 ? given / sum.mass() : 1.0;
        moments *= scale;
        const glm::dvec3 center = stage_.vector3(prim, "physics:centerOfMass", glm::dvec3(-1e38));
        if (center.x > -1e30 && center.y > -1e30 && center.z > -1e30) at.position = made.frame.scale * center;
        if (inertia != glm::dvec3(0.0)) {
            at.rotation = stage_.rotation(prim, "physics:principalAxes");
            const glm::dvec3 d = inertia * (meters * meters);
            const glm::dmat3 tensor(d.x, 0, 0, 0, d.y, 0, 0, 0, d.z);
            const glm::dmat3 real = valid_inertia(tensor, made.body.place, scene_.warnings);
            moments = {real[0][0], real[1][1], real[2][2]};
        }
        made.body.masses.push_back(
            {sum.mass() * scale, glm::dmat3(moments.x, 0, 0, 0, moments.y, 0, 0, 0, moments.z), at});
    }

    static void dress(Made& made) {
        const bool has_looks = std::any_of(made.parts.begin(), made.parts.end(), [](const Part& part) {
            return part.look && (!part.shape || part.look->texture || part.look->finish);
        });
        for (Part& part : made.parts) {
            if (has_looks && part.look) {
                if (!part.look->surface) {
                    part.look->surface = std::make_shared<const Surface>(tessellate(part.shape->shape));
                }
                made.body.looks.push_back(*part.look);
            }
            if (part.shape) made.body.shapes.push_back(*part.shape);
        }
    }

    const UsdStage& stage_;
    UsdLooks looks_;
    bool decomposes_;
    Scene& scene_;
    SurfaceParts surface_parts_;
    std::vector<Made> bodies_;
    std::map<const UsdPrim*, std::size_t> index_;
    std::map<const UsdPrim*, BodyId> ids_;
    std::vector<const UsdPrim*> groups_;
    std::map<std::string, std::size_t> group_of_, pair_prims_;
    std::set<std::pair<std::size_t, std::size_t>> filtered_groups_, filtered_pairs_;
};

} // namespace

Scene load_usd(std::span<const std::byte> bytes, const std::string& name,
               const std::optional<std::filesystem::path>& folder, const LoadOptions& options) {
    const UsdKind kind = usd_kind(bytes);
    if (kind != UsdKind::text) {
        throw Error(
            ErrorCode::unsupported, name, {},
            std::string(kind == UsdKind::binary ? "is a binary file of USD (.usdc)" : "is a package of USD (.usdz)") +
                ", which is not read: make a text layer (.usda) of it with the program usdcat of OpenUSD");
    }
    const UsdLayer layer = parse_usd(bytes, name);
    const UsdStage stage(layer, name);
    Scene scene{loaded_world({}, options), {}, {}, {}, {}};
    const auto title = layer.metadata.find("defaultPrim");
    if (title != layer.metadata.end() && !title->second.words.empty()) scene.info.title = title->second.words[0];
    if (scene.info.title.empty()) scene.info.title = std::filesystem::path(name).stem().generic_string();
    WorldMaker(stage, folder, options.decompose, scene).make();
    if (auto line = stage.unused()) scene.warnings.push_back(std::move(*line));
    if (scene.world.bodies().empty()) {
        scene.warnings.push_back(name + ": has no body: no prim of this layer has a PhysicsRigidBodyAPI or a "
                                        "PhysicsCollisionAPI, and nothing will move");
    }
    limit_warnings(scene.warnings);
    return scene;
}

} // namespace cairn::scene
