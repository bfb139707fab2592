#include "scene/definitions.h"

#include "scene/document.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cairn::scene {

namespace {

constexpr int max_grid = 1 << 24; // columns or rows of a height field
constexpr std::size_t max_surface_materials = 65'535;

std::optional<Value> document_array(const Value& document, const char* name, const char* member) {
    const auto found = extension(document, name);
    return found ? found->find(member) : std::nullopt;
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
        warnings.push_back(shape.place() + "a nonuniformly scaled sphere is replaced by a sphere of the largest scale");
    }
    return Sphere{half_of(2.0 * radius * std::max({scale.x, scale.y, scale.z}), shape)};
}

Shape read_box(const Value& shape, const glm::dvec3& scale, std::vector<std::string>& warnings) {
    glm::dvec3 size{1.0, 1.0, 1.0};
    if (const auto box = shape.find("box")) {
        if (const auto given = box->find("size")) size = given->vector3(positive_float);
    }
    size *= scale;
    return Box{{half_of(size.x, shape), half_of(size.y, shape), half_of(size.z, shape)},
               read_rounding(shape, scale, warnings)};
}

Shape read_plane(const Value& shape, const glm::dvec3& scale) {
    Plane result; // through the origin, facing +y
    const auto plane = shape.find("plane");
    if (!plane) return result;
    if (const auto sides = plane->find("doubleSided")) result.double_sided = sides->boolean();
    // A plane is infinite without a size; some exporters write 0 for that.
    const auto half = [&](const char* name, double factor) {
        const auto size = plane->find(name);
        const double along = size ? size->number(nonnegative_float) : 0.0;
        return along > 0.0 ? half_of(along * factor, *size) : std::numeric_limits<float>::infinity();
    };
    const glm::vec2 extents(half("sizeX", scale.x), half("sizeZ", scale.z));
    if (!std::isinf(extents.x) || !std::isinf(extents.y)) result.half_extents = extents;
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

// The sizes of a capsule or a cylinder, which have the same members.
struct Column {
    double height = 0.5, bottom = 0.25, top = 0.25;
};

Column read_column(const Value& shape, const char* member) {
    Column column;
    const auto given = shape.find(member);
    if (!given) return column;
    if (const auto value = given->find("height")) column.height = value->number(positive_float);
    if (const auto value = given->find("radiusBottom")) column.bottom = value->number(nonnegative_float);
    if (const auto value = given->find("radiusTop")) column.top = value->number(nonnegative_float);
    if (column.bottom == 0.0 && column.top == 0.0) given->fail("must have a positive radius at one end at least");
    return column;
}

// A pointed shape of the engine has its tip at the top; one with its tip at the bottom is turned upside down.
template <class Column3d> TurnedShape upright_column(Column column, const glm::dvec3& scale, const Value& shape) {
    TurnedShape result;
    if (column.bottom == 0.0) {
        std::swap(column.bottom, column.top);
        result.rotation = Quat(0.0f, 1.0f, 0.0f, 0.0f); // half a turn about x
    }
    const double across = std::max(scale.x, scale.z);
    Column3d made;
    made.half_height = half_of(column.height * scale.y, shape);
    made.radius = half_of(2.0 * column.bottom * across, shape);
    if (column.top == 0.0) {
        made.radius_top = 0.0f;
    } else if (column.top != column.bottom) {
        made.radius_top = half_of(2.0 * column.top * across, shape);
    }
    result.shape = made;
    return result;
}

TurnedShape read_capsule(const Value& shape, const glm::dvec3& scale, std::vector<std::string>& warnings) {
    if (scale.x != scale.y || scale.y != scale.z) {
        warnings.push_back(shape.place() +
                           "a nonuniformly scaled capsule keeps round ends: its height is scaled along y, "
                           "its radii by the larger of the scales along x and z");
    }
    return upright_column<Capsule>(read_column(shape, "capsule"), scale, shape);
}

TurnedShape read_cylinder(const Value& shape, const glm::dvec3& scale, std::vector<std::string>& warnings) {
    if (scale.x != scale.z) {
        warnings.push_back(shape.place() +
                           "a nonuniformly scaled cylinder stays round: its radii are scaled by the larger "
                           "of the scales along x and z");
    }
    TurnedShape result = upright_column<Cylinder>(read_column(shape, "cylinder"), scale, shape);
    std::get<Cylinder>(result.shape).rounding = read_rounding(shape, scale, warnings);
    return result;
}

} // namespace

float read_rounding(const Value& place, const glm::dvec3& scale, std::vector<std::string>& warnings) {
    const auto own = extension(place, "CAIRN_shape");
    const auto given = own ? own->find("rounding") : std::nullopt;
    if (!given) return 0.0f;
    const glm::dvec3 size = glm::abs(scale);
    const double radius = given->number(nonnegative_float) * std::max({size.x, size.y, size.z});
    if (!nonnegative_float.contains(radius)) given->fail("must fit a float, with the scale of its node");
    if (radius > 0.0 && (size.x != size.y || size.y != size.z)) {
        warnings.push_back(given->place() + "nonuniformly scaled, it is replaced by a ball of the largest scale");
    }
    return static_cast<float>(radius);
}

Definitions::Definitions(const Value& document)
    : shapes_(document_array(document, "KHR_implicit_shapes", "shapes")),
      materials_(document_array(document, "KHR_physics_rigid_bodies", "physicsMaterials")) {}

TurnedShape Definitions::shape(const Value& index, const glm::dvec3& scale, Accessors& accessors,
                               std::vector<std::string>& warnings) const {
    const Value found = element(shapes_, index, max_definitions, "shapes");
    const glm::dvec3 size = glm::abs(scale);
    const Value type = found.require("type");
    const std::string name = type.text();
    if (const auto own = extension(found, "CAIRN_shape"); own && name != "box" && name != "cylinder") {
        warnings.push_back(own->place() + "is for boxes, cylinders and hulls, and is left out");
    }
    if (name == "sphere") return {read_sphere(found, size, warnings)};
    if (name == "box") return {read_box(found, size, warnings)};
    if (name == "plane") return {read_plane(found, size)};
    if (name == "capsule") return read_capsule(found, size, warnings);
    if (name == "cylinder") return read_cylinder(found, size, warnings);
    if (name == "CAIRN_height_field") return {height_field(found, size, accessors)};
    type.refuse("shapes of the type \"" + name.substr(0, 40) +
                "\" are not supported; there are sphere, box, capsule, cylinder, plane and CAIRN_height_field");
}

PhysicsMaterial Definitions::substance(const Value& index) const {
    const Value found = element(materials_, index, max_definitions, "physics materials");
    PhysicsMaterial result;
    Material& material = result.material;
    if (const auto value = found.find("staticFriction")) material.static_friction = value->real(nonnegative_float);
    if (const auto value = found.find("dynamicFriction")) material.dynamic_friction = value->real(nonnegative_float);
    if (const auto value = found.find("restitution")) material.restitution = value->real({0.0, 1.0, false});
    if (const auto value = found.find("frictionCombine")) material.friction_combine = read_rule(*value);
    if (const auto value = found.find("restitutionCombine")) material.restitution_combine = read_rule(*value);
    const auto own = extension(found, "CAIRN_material");
    if (!own) return result;
    if (const auto value = own->find("density")) result.density = value->real(nonnegative_float);
    if (const auto value = own->find("rolling_friction")) material.rolling_friction = value->real(nonnegative_float);
    if (const auto value = own->find("torsional_friction"))
        material.torsional_friction = value->real(nonnegative_float);
    if (const auto value = own->find("surface_velocity")) result.surface_velocity = value->float_vector3();
    if (const auto value = own->find("one_way")) result.one_way = value->float_vector3();
    return result;
}

SurfaceMaterials Definitions::surface_materials(const Value& own, std::size_t parts, Accessors& accessors) const {
    const Value list = own.require("materials");
    const std::size_t count = list.size(max_surface_materials, "physics materials");
    constexpr std::size_t numbers_of_material = 7;
    accessors.count_against_limit(numbers_of_material * count, list);
    SurfaceMaterials result;
    for (std::size_t i = 0; i < count; ++i) result.materials.push_back(substance(list[i]).material);
    const auto index = own.find("numbers");
    if (!index) {
        result.numbers.assign(count == 0 ? 0 : parts, 1);
        return result;
    }
    if (accessors.count(*index) != parts) {
        index->fail("must be the index of an accessor with a number for each triangle or cell, which is " +
                    std::to_string(parts));
    }
    for (const std::uint32_t number : accessors.indices(*index)) {
        if (number > count) {
            index->fail("must have numbers up to that of the materials, " + std::to_string(count) + ", and has " +
                        std::to_string(number));
        }
        result.numbers.push_back(static_cast<std::uint16_t>(number));
    }
    return result;
}

Shape Definitions::height_field(const Value& shape, const glm::dvec3& scale, Accessors& accessors) const {
    const auto field = extension(shape, "CAIRN_height_field");
    if (!field) shape.fail("must have an extension \"CAIRN_height_field\"");
    const int columns = field->require("columns").integer(2, max_grid),
              rows = field->require("rows").integer(2, max_grid);
    const Value spacing = field->require("spacing");
    if (spacing.size(2, "numbers") != 2) spacing.fail("must be an array of 2 numbers");
    const glm::vec2 step(2.0f * half_of(spacing[0].number(positive_float) * scale.x, spacing),
                         2.0f * half_of(spacing[1].number(positive_float) * scale.z, spacing));
    const Value index = field->require("heights");
    const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    if (accessors.count(index) != count) {
        index.fail("must be the index of an accessor of columns times rows numbers, which is " + std::to_string(count));
    }
    std::vector<float> heights = accessors.scalars(index);
    for (float& height : heights) {
        const double scaled = height * scale.y;
        if (!any_float.contains(scaled)) index.fail("must have heights that fit a float, with the scale of the node");
        height = static_cast<float>(scaled) + 0.0f;
    }
    if (const auto holes = field->find("holes")) {
        const std::size_t holes_count = holes->size(count, "places in the heights");
        for (std::size_t i = 0; i < holes_count; ++i)
            heights[static_cast<std::size_t>((*holes)[i].integer(0, static_cast<int>(count) - 1))] = HeightField::hole;
    }
    SurfaceMaterials materials;
    if (field->find("materials") || field->find("numbers")) {
        const std::size_t cells = static_cast<std::size_t>(columns - 1) * static_cast<std::size_t>(rows - 1);
        materials = surface_materials(*field, cells, accessors);
    }
    try {
        return HeightField(columns, rows, step, heights, materials);
    } catch (const Error& error) {
        field->fail(error);
    }
}

} // namespace cairn::scene
