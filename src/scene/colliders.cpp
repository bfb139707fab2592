#include "scene/colliders.h"

#include "scene/document.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cairn::scene {

namespace {

bool has_no_mass(const Shape& shape) {
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<Mesh>(shape) ||
           std::holds_alternative<HeightField>(shape);
}

// Returns only the vertices that triangles use: others are no part of the surface.
std::vector<Vec3> used_vertices(const GatheredTriangles& triangles) {
    std::vector<bool> used(triangles.vertices.size(), false);
    for (const std::uint32_t corner : triangles.indices) used[corner] = true;
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) result.push_back(triangles.vertices[i]);
    }
    return result;
}

} // namespace

std::vector<TurnedShape> Colliders::shapes(const Value& geometry, const glm::dvec3& scale, BodyType type,
                                           bool is_trigger, std::vector<std::string>& warnings) {
    const auto index = geometry.find("shape"), node = geometry.find("node");
    if (index && node) node->fail("must not stand beside a shape");
    const auto convex = geometry.find("convexHull");
    bool is_hull = convex && convex->boolean();
    if (node) {
        std::vector<TurnedShape> result;
        if (!is_hull && type == BodyType::dynamic && !is_trigger) {
            for (const Hull& part : parts_of(geometry, *node, scale, warnings)) result.push_back({part});
            warnings.push_back(
                geometry.place() + "a mesh on a dynamic body is taken as " +
                (result.size() == 1 ? "its convex hull" : std::to_string(result.size()) + " convex parts"));
        } else {
            if (!is_hull && type == BodyType::dynamic) {
                warnings.push_back(geometry.place() + "a mesh on a dynamic body is taken as its convex hull");
                is_hull = true;
            }
            result.push_back({mesh_shape(geometry, *node, scale, is_hull, warnings)});
        }
        for (TurnedShape& made : result) {
            if (auto* hull = std::get_if<Hull>(&made.shape)) hull->rounding = read_rounding(geometry, scale, warnings);
        }
        if (const auto own = extension(geometry, "CAIRN_shape"); own && std::holds_alternative<Mesh>(result[0].shape)) {
            warnings.push_back(own->place() + "is for boxes, cylinders and hulls, and is left out");
        }
        return result;
    }
    if (!index) geometry.fail("must have a member \"shape\" or \"node\"");
    TurnedShape made = implicit_shape(*index, scale, warnings);
    if (has_no_mass(made.shape) && type == BodyType::dynamic) {
        geometry.refuse("planes and height fields have no mass and may only belong to static and kinematic bodies");
    }
    return {made};
}

// Returns the convex parts that approximate the mesh.
const std::vector<Hull>& Colliders::parts_of(const Value& geometry, const Value& node, const glm::dvec3& scale,
                                             std::vector<std::string>& warnings) {
    const Key key{node.index(max_nodes, "nodes"), false, scale.x, scale.y, scale.z};
    std::shared_ptr<const Surface>& surface = surfaces_in_parts_[key];
    if (!surface) {
        GatheredTriangles triangles = surfaces_.geometry(node, affine(scale), warnings);
        surface =
            std::make_shared<const Surface>(Surface{std::move(triangles.vertices), {}, std::move(triangles.indices)});
    }
    try {
        return surface_parts_.of(surface);
    } catch (const Error& error) {
        geometry.fail(error);
    }
}

TurnedShape Colliders::implicit_shape(const Value& index, const glm::dvec3& scale, std::vector<std::string>& warnings) {
    const Key key{index.index(max_definitions, "shapes"), false, scale.x, scale.y, scale.z};
    if (const auto known = height_fields_.find(key); known != height_fields_.end()) return {known->second};
    const TurnedShape made = definitions_.shape(index, scale, surfaces_.accessors(), warnings);
    if (std::holds_alternative<HeightField>(made.shape)) height_fields_.emplace(key, made.shape);
    return made;
}

// Concatenates the materials of the primitives of a mesh.
SurfaceMaterials Colliders::materials_of(const GatheredTriangles& triangles) {
    SurfaceMaterials result;
    const auto has_materials = [](const auto& part) {
        return part.own && (part.own->find("materials") || part.own->find("numbers"));
    };
    if (std::none_of(triangles.parts.begin(), triangles.parts.end(), has_materials)) return result;
    for (const auto& part : triangles.parts) {
        const std::size_t first = result.materials.size();
        SurfaceMaterials own;
        if (has_materials(part)) own = definitions_.surface_materials(*part.own, part.triangles, surfaces_.accessors());
        own.numbers.resize(part.triangles);
        result.materials.insert(result.materials.end(), own.materials.begin(), own.materials.end());
        if (result.materials.size() > std::numeric_limits<std::uint16_t>::max())
            part.own->fail("must not raise the materials of a collider above 65535");
        for (const std::uint16_t number : own.numbers)
            result.numbers.push_back(static_cast<std::uint16_t>(number == 0 ? 0 : number + first));
    }
    return result;
}

Shape Colliders::mesh_shape(const Value& geometry, const Value& node, const glm::dvec3& scale, bool is_hull,
                            std::vector<std::string>& warnings) {
    const Key key{node.index(max_nodes, "nodes"), is_hull, scale.x, scale.y, scale.z};
    if (const auto known = meshes_.find(key); known != meshes_.end()) return known->second;
    const GatheredTriangles triangles = surfaces_.geometry(node, affine(scale), warnings);
    try {
        const auto make = [&]() -> Shape {
            if (is_hull) return Hull(used_vertices(triangles));
            return Mesh(triangles.vertices, triangles.indices, materials_of(triangles));
        };
        return meshes_.emplace(key, make()).first->second;
    } catch (const Error& error) {
        geometry.fail(error);
    }
}

} // namespace cairn::scene
