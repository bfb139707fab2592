#include "scene/definitions.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

std::optional<Value> document_array(const Value& document, const char* extension, const char* member) {
    const auto extensions = document.find("extensions");
    if (!extensions) return std::nullopt;
    const auto found = extensions->find(extension);
    if (!found) return std::nullopt;
    return found->find(member);
}

// The element of `array` that `index` refers to.
Value element(const std::optional<Value>& array, const Value& index, const char* what) {
    const std::size_t count = array ? array->size(max_definitions, what) : 0;
    if (count == 0) index.fail(std::string("must be left out, as the file has no ") + what);
    return (*array)[index.index(count, what)];
}

float half_of(double size, const Value& place) {
    const double half = 0.5 * size;
    if (!positive_float.contains(half) || static_cast<float>(half) == 0.0f) {
        place.fail("must have a size that fits a float, with the scale of its node");
    }
    return static_cast<float>(half);
}

Shape read_sphere(const Value& shape, const glm::dvec3& scale, std::vector<std::string>& warnings) {
    double radius = 0.5;
    if (const auto sphere = shape.find("sphere")) {
        if (const auto given = sphere->find("radius")) radius = given->number(positive_float);
    }
    if (scale.x != scale.y || scale.y != scale.z) {
        warnings.push_back(shape.place() + "an unevenly scaled sphere is taken as a sphere of the largest scale");
    }
    return Sphere{half_of(2.0 * radius * std::max({scale.x, scale.y, scale.z}), shape)};
}

Shape read_box(const Value& shape, const glm::dvec3& scale) {
    glm::dvec3 size{1.0, 1.0, 1.0};
    if (const auto box = shape.find("box")) {
        if (const auto given = box->find("size")) size = given->vector3(positive_float);
    }
    size *= scale;
    return Box{{half_of(size.x, shape), half_of(size.y, shape), half_of(size.z, shape)}};
}

Shape read_plane(const Value& shape, const glm::dvec3& scale) {
    Plane result; // through the origin, facing +y
    const auto plane = shape.find("plane");
    if (!plane) return result;
    if (const auto sides = plane->find("doubleSided"); sides && sides->boolean()) {
        sides->refuse("planes are solid on one side here, so this must be false or left out");
    }
    const auto along_x = plane->find("sizeX"), along_z = plane->find("sizeZ");
    if (!along_x && !along_z) return result;
    if (!along_x || !along_z) {
        plane->refuse("a plane that is infinite along one axis alone is not supported: give sizeX and sizeZ, or none");
    }
    result.half_extents = glm::vec2(half_of(along_x->number(positive_float) * scale.x, *along_x),
                                    half_of(along_z->number(positive_float) * scale.z, *along_z));
    return result;
}

CombineRule read_rule(const Value& value) {
    const std::string name = value.text();
    if (name == "average") return CombineRule::average;
    if (name == "minimum") return CombineRule::minimum;
    if (name == "maximum") return CombineRule::maximum;
    if (name == "multiply") return CombineRule::multiply;
    value.fail("must be \"average\", \"minimum\", \"maximum\" or \"multiply\"");
}

std::set<std::string> read_systems(const std::optional<Value>& list) {
    std::set<std::string> systems;
    if (!list) return systems;
    const std::size_t count = list->size(1000, "systems");
    for (std::size_t i = 0; i < count; ++i) systems.insert((*list)[i].text());
    return systems;
}

struct Filter {
    std::set<std::string> systems, with, not_with;
    bool has_with = false;
    std::optional<Value> place;
};

// Whether `a` keeps `b` away, in the strict reading: whatever the draft leaves open counts as kept away.
bool keeps_away(const Filter& a, const Filter& b) {
    for (const std::string& system : b.systems) {
        if (a.not_with.count(system) > 0 || (a.has_with && a.with.count(system) == 0)) return true;
    }
    return a.has_with && b.systems.empty();
}

} // namespace

Definitions::Definitions(const Value& document)
    : shapes_(document_array(document, "KHR_implicit_shapes", "shapes")),
      materials_(document_array(document, "KHR_physics_rigid_bodies", "physicsMaterials")),
      filters_(document_array(document, "KHR_physics_rigid_bodies", "collisionFilters")) {}

Shape Definitions::shape(const Value& index, const glm::dvec3& scale, std::vector<std::string>& warnings) const {
    const Value found = element(shapes_, index, "shapes");
    const glm::dvec3 size = glm::abs(scale);
    const Value type = found.require("type");
    const std::string name = type.text();
    if (name == "sphere") return read_sphere(found, size, warnings);
    if (name == "box") return read_box(found, size);
    if (name == "plane") return read_plane(found, size);
    type.refuse("shapes of the type \"" + name.substr(0, 40) +
                "\" are not supported yet; there are sphere, box and plane");
}

Substance Definitions::substance(const Value& index) const {
    const Value found = element(materials_, index, "physics materials");
    Substance result;
    Material& material = result.material;
    if (const auto value = found.find("staticFriction")) material.static_friction = value->real(nonnegative_float);
    if (const auto value = found.find("dynamicFriction")) material.dynamic_friction = value->real(nonnegative_float);
    if (const auto value = found.find("restitution")) material.restitution = value->real({0.0, 1.0, false});
    if (const auto value = found.find("frictionCombine")) material.friction_combine = read_rule(*value);
    if (const auto value = found.find("restitutionCombine")) material.restitution_combine = read_rule(*value);
    const auto extensions = found.find("extensions");
    const auto own = extensions ? extensions->find("CAIRN_material") : std::nullopt;
    if (!own) return result;
    if (const auto value = own->find("density")) result.density = value->real(nonnegative_float);
    if (const auto value = own->find("rolling_friction")) material.rolling_friction = value->real(nonnegative_float);
    if (const auto value = own->find("torsional_friction"))
        material.torsional_friction = value->real(nonnegative_float);
    return result;
}

void Definitions::use_filter(const std::optional<Value>& index) {
    if (!index) {
        some_without_filter_ = true;
        return;
    }
    element(filters_, *index, "collision filters");
    used_filters_.insert(index->index(max_definitions, "collision filters"));
    if (used_filters_.size() > max_used_filters) {
        index->fail("must be one of at most " + std::to_string(max_used_filters) + " collision filters in use");
    }
}

void Definitions::refuse_separating_filters() const {
    std::vector<Filter> filters;
    if (some_without_filter_) filters.push_back({});
    for (const std::size_t i : used_filters_) {
        const Value value = (*filters_)[i];
        const auto with = value.find("collideWithSystems");
        filters.push_back({read_systems(value.find("collisionSystems")), read_systems(with),
                           read_systems(value.find("notCollideWithSystems")), with.has_value(), value});
    }
    for (const Filter& a : filters) {
        for (const Filter& b : filters) {
            if (keeps_away(a, b)) a.place->refuse("collision filters that keep colliders apart are not supported yet");
        }
    }
}

} // namespace cairn::scene
