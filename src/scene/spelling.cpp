#include "scene/spelling.h"

#include "scene/document.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace cairn::scene {

namespace {

constexpr std::size_t max_warnings_per_object = 20, max_warnings_in_all = 1000; // far more warnings than are ever shown

// Ignores differences that are easily confused: case and underscores.
std::string plain_name(const std::string& name) {
    std::string result;
    for (const char c : name.substr(0, 64)) {
        if (c != '_') result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return result;
}

// Returns how many letters must be inserted, deleted or replaced (Wagner and Fischer 1974).
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t k = 0; k < b.size(); ++k) {
            const std::size_t changed = diagonal + (a[i] == b[k] ? 0 : 1);
            diagonal = row[k + 1];
            row[k + 1] = std::min({changed, row[k] + 1, row[k + 1] + 1});
        }
    }
    return row.back();
}

// Returns the known name that was most likely meant; empty if none is similar enough.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
    const std::string plain = plain_name(name);
    std::string best;
    std::size_t least = std::max<std::size_t>(2, plain.size() / 3) + 1;
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(plain, plain_name(candidate));
        if (distance >= least || distance >= candidate.size()) continue;
        least = distance;
        best = candidate;
    }
    return best;
}

// A type of object of the draft or of Cairn's extensions: its members and their types.
struct Kind {
    struct Member {
        const char* name;
        const char* kind = nullptr; // type of the object, or of the objects in a list
    };
    std::vector<Member> members;
};

const std::map<std::string, Kind>& kinds() {
    static const std::map<std::string, Kind> all{
        {"node", {{{"motion", "motion"}, {"collider", "collider"}, {"trigger", "trigger"}, {"joint", "node joint"}}}},
        {"motion",
         {{{"isKinematic"},
           {"mass"},
           {"centerOfMass"},
           {"inertiaDiagonal"},
           {"inertiaOrientation"},
           {"linearVelocity"},
           {"angularVelocity"},
           {"gravityFactor"}}}},
        {"collider", {{{"geometry", "geometry"}, {"physicsMaterial"}, {"collisionFilter"}}}},
        {"trigger", {{{"geometry", "geometry"}, {"nodes"}, {"collisionFilter"}}}},
        {"geometry", {{{"shape"}, {"node"}, {"convexHull"}}}},
        {"node joint", {{{"connectedNode"}, {"joint"}, {"enableCollision"}}}},
        {"physics", {{{"physicsMaterials", "material"}, {"physicsJoints", "joint"}, {"collisionFilters", "filter"}}}},
        {"material",
         {{{"staticFriction"}, {"dynamicFriction"}, {"restitution"}, {"frictionCombine"}, {"restitutionCombine"}}}},
        {"filter", {{{"collisionSystems"}, {"collideWithSystems"}, {"notCollideWithSystems"}}}},
        {"joint", {{{"limits", "limit"}, {"drives", "drive"}}}},
        {"limit", {{{"linearAxes"}, {"angularAxes"}, {"min"}, {"max"}, {"stiffness"}, {"damping"}}}},
        {"drive",
         {{{"type"},
           {"mode"},
           {"axis"},
           {"maxForce"},
           {"positionTarget"},
           {"velocityTarget"},
           {"stiffness"},
           {"damping"}}}},
        {"shapes", {{{"shapes", "shape"}}}},
        {"shape",
         {{{"type"},
           {"sphere", "sphere"},
           {"box", "box"},
           {"capsule", "column"},
           {"cylinder", "column"},
           {"plane", "plane"}}}},
        {"sphere", {{{"radius"}}}},
        {"box", {{{"size"}}}},
        {"column", {{{"height"}, {"radiusBottom"}, {"radiusTop"}}}},
        {"plane", {{{"sizeX"}, {"sizeZ"}, {"doubleSided"}}}},
        {"CAIRN_body",
         {{{"linear_damping"},
           {"angular_damping"},
           {"allow_sleep"},
           {"enabled"},
           {"group"},
           {"character", "character"}}}},
        {"character",
         {{{"up"},
           {"max_slope"},
           {"step_height"},
           {"stick_distance"},
           {"skin"},
           {"mass"},
           {"max_push_force"},
           {"air_acceleration"},
           {"flies"},
           {"walk_velocity"}}}},
        {"CAIRN_material",
         {{{"density"}, {"rolling_friction"}, {"torsional_friction"}, {"surface_velocity"}, {"one_way"}}}},
        {"CAIRN_shape", {{{"rounding"}}}},
        {"CAIRN_height_field",
         {{{"columns"}, {"rows"}, {"spacing"}, {"heights"}, {"holes"}, {"materials"}, {"numbers"}}}},
        {"CAIRN_mesh", {{{"materials"}, {"numbers"}}}},
    };
    return all;
}

// No limit on the elements of a list, as it is in memory already.
constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

class Speller {
  public:
    explicit Speller(std::vector<std::string>& warnings) : warnings_(warnings) {}

    // Values that are not an object or a list of objects are skipped; their reader refuses them.
    void check(const Value& value, const char* name) {
        if (value.is_array()) {
            const std::size_t count = value.size(any_number, "elements");
            for (std::size_t i = 0; i < count; ++i) check(value[i], name);
            return;
        }
        if (!value.is_object()) return;
        const Kind& kind = kinds().at(name);
        std::vector<std::string> known;
        for (const Kind::Member& member : kind.members) known.emplace_back(member.name);
        warn_of_unknown_members(value, known, warnings_);
        for (const Kind::Member& member : kind.members) {
            if (member.kind == nullptr) continue;
            if (const auto found = value.find(member.name)) check(*found, member.kind);
        }
        for (const char* own : {"CAIRN_material", "CAIRN_shape", "CAIRN_height_field"}) {
            if (const auto found = extension_of(value, own)) check(*found, own);
        }
    }

    void check_extensions(const Value& owner, const std::vector<std::pair<const char*, const char*>>& kinds_of) {
        if (!owner.is_object()) return;
        const auto extensions = owner.find("extensions");
        if (!extensions || !extensions->is_object()) return;
        for (const std::string& other : extensions->other_members(understood_extensions(), max_warnings_per_object)) {
            const std::string meant = nearest_name(other, understood_extensions());
            if (meant.empty()) continue; // an extension of another vendor
            warnings_.push_back(extensions->place() + "the extension \"" + other +
                                "\" is not known and has no effect; did you mean \"" + meant + "\"?");
        }
        for (const auto& [name, kind] : kinds_of) {
            if (const auto found = extensions->find(name)) check(*found, kind);
        }
    }

    // Cairn's own extras begin with "cairn".
    void check_extras(const Value& node) {
        const auto extras = node.is_object() ? node.find("extras") : std::nullopt;
        if (!extras || !extras->is_object()) return;
        for (const std::string& other : extras->other_members({"cairn_color"}, max_warnings_per_object)) {
            if (plain_name(other).substr(0, 5) != "cairn" || warnings_.size() > max_warnings_in_all) continue;
            warnings_.push_back(extras->place() + "the member \"" + other +
                                "\" is not known and has no effect; did you mean \"cairn_color\"?");
        }
    }

  private:
    static std::optional<Value> extension_of(const Value& owner, const char* name) {
        const auto extensions = owner.find("extensions");
        return extensions && extensions->is_object() ? extensions->find(name) : std::nullopt;
    }

    std::vector<std::string>& warnings_;
};

} // namespace

void warn_of_unknown_members(const Value& object, const std::vector<std::string>& known,
                             std::vector<std::string>& warnings) {
    if (warnings.size() > max_warnings_in_all) return;
    std::vector<std::string> all = known;
    all.insert(all.end(), {"extensions", "extras", "name"});
    for (const std::string& other : object.other_members(all, max_warnings_per_object)) {
        std::string text = object.place() + "the member \"" + other + "\" is not known and has no effect";
        if (const std::string meant = nearest_name(other, known); !meant.empty()) {
            text += "; did you mean \"" + meant + "\"?";
        } else {
            for (std::size_t i = 0; i < known.size(); ++i) text += (i == 0 ? "; known are " : ", ") + known[i];
        }
        warnings.push_back(std::move(text));
    }
}

void check_spelling(const Value& document, const std::optional<Value>& scene, std::vector<std::string>& warnings) {
    Speller speller(warnings);
    speller.check_extensions(document, {{"KHR_physics_rigid_bodies", "physics"}, {"KHR_implicit_shapes", "shapes"}});
    if (scene) speller.check_extensions(*scene, {});
    const auto nodes = document.find("nodes");
    const std::size_t count = nodes && nodes->is_array() ? nodes->size(any_number, "nodes") : 0;
    for (std::size_t i = 0; i < count; ++i) {
        speller.check_extras((*nodes)[i]);
        speller.check_extensions((*nodes)[i], {{"KHR_physics_rigid_bodies", "node"}, {"CAIRN_body", "CAIRN_body"}});
    }
    const auto meshes = document.find("meshes");
    const std::size_t mesh_count = meshes && meshes->is_array() ? meshes->size(any_number, "meshes") : 0;
    for (std::size_t i = 0; i < mesh_count; ++i) {
        const auto primitives = (*meshes)[i].is_object() ? (*meshes)[i].find("primitives") : std::nullopt;
        const std::size_t parts = primitives && primitives->is_array() ? primitives->size(any_number, "primitives") : 0;
        for (std::size_t k = 0; k < parts; ++k)
            speller.check_extensions((*primitives)[k], {{"CAIRN_mesh", "CAIRN_mesh"}});
    }
}

} // namespace cairn::scene
