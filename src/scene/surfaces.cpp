#include "scene/surfaces.h"

#include "scene/document.h"

#include <cmath>
#include <limits>
#include <utility>

namespace cairn::scene {

namespace {

// glTF 2.0, section 3.7.2.1.
constexpr std::uint64_t mode_triangles = 4, mode_strip = 5; // 6 is a fan

// Converts strips and fans to single triangles with the winding that the format defines.
std::vector<std::uint32_t> single_triangles(const std::vector<std::uint32_t>& indices, std::uint64_t mode,
                                            const Value& place) {
    if (mode == mode_triangles) {
        if (indices.size() % 3 != 0) {
            place.fail("must have three corners for each triangle, and has " + std::to_string(indices.size()));
        }
        return indices;
    }
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        if (mode == mode_strip) {
            result.insert(result.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
        } else {
            result.insert(result.end(), {indices[i + 1], indices[i + 2], indices[0]});
        }
    }
    return result;
}

// Returns the matrix that maps normals when `linear` maps surfaces: its cofactors, which exist even where its inverse
// does not; a reflection negates them, so that the outside stays outside.
glm::dmat3 normal_map(const glm::dmat3& linear, bool mirrors) {
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    return mirrors ? -cofactors : cofactors;
}

} // namespace

const std::vector<Triangles>& Surfaces::mesh(const Value& index, std::vector<std::string>& warnings) {
    const Value found = element(meshes_, index, max_meshes, "meshes");
    const std::size_t number = index.index(max_meshes, "meshes");
    const auto known = read_.find(number);
    if (known != read_.end()) return known->second;
    return read_.emplace(number, read(found, warnings)).first->second;
}

std::vector<Triangles> Surfaces::read(const Value& mesh, std::vector<std::string>& warnings) {
    const Value primitives = mesh.require("primitives");
    const std::size_t count = primitives.size(max_primitives, "primitives");
    std::vector<Triangles> result;
    for (std::size_t i = 0; i < count; ++i) {
        if (auto triangles = read_primitive(primitives[i], warnings)) result.push_back(std::move(*triangles));
    }
    return result;
}

std::optional<Triangles> Surfaces::read_primitive(const Value& primitive, std::vector<std::string>& warnings) {
    if (extension(primitive, "KHR_draco_mesh_compression")) primitive.refuse("is compressed, which is not supported");
    const auto attributes = primitive.find("attributes");
    const auto positions = attributes ? attributes->find("POSITION") : std::nullopt;
    if (!positions) return std::nullopt; // glTF: "clients should skip" such primitives
    const auto given_mode = primitive.find("mode");
    const std::uint64_t mode = given_mode ? given_mode->whole(0, 6) : mode_triangles;
    if (mode < mode_triangles) {
        warnings.push_back(primitive.place() + "has points or lines, which are left out");
        return std::nullopt;
    }
    if (primitive.find("targets")) warnings.push_back(primitive.place() + "its morph targets are not applied");
    Triangles result;
    result.vertices = accessors_.vectors(*positions);
    const std::size_t count = result.vertices.size();
    if (const auto normals = attributes->find("NORMAL")) {
        result.normals = accessors_.vectors(*normals);
        if (result.normals.size() != count) {
            normals->fail("must have as many elements as POSITION, which has " + std::to_string(count));
        }
    }
    std::vector<std::uint32_t> corners;
    if (const auto indices = primitive.find("indices")) {
        corners = accessors_.indices(*indices);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (corners[i] >= count) {
                indices->fail("must stay below the " + std::to_string(count) + " vertices, and has " +
                              std::to_string(corners[i]) + " at " + std::to_string(i));
            }
        }
    } else {
        for (std::size_t i = 0; i < count; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    }
    result.indices = single_triangles(corners, mode, primitive);
    result.material = primitive.find("material");
    result.attributes = attributes;
    result.own = extension(primitive, "CAIRN_mesh");
    if (result.indices.empty()) return std::nullopt;
    return result;
}

Triangles Surfaces::mapped(const Triangles& triangles, const Affine& map, const Value& place) {
    const std::size_t numbers = triangles.vertices.size() + triangles.normals.size() + triangles.indices.size();
    if (numbers > remaining_numbers_) {
        place.fail("must not raise the number of vertices of all meshes in use above " +
                   std::to_string(max_surface_numbers));
    }
    remaining_numbers_ -= numbers;
    const bool mirrors = glm::determinant(map.linear) < 0.0;
    Triangles result = triangles;
    for (Vec3& vertex : result.vertices) {
        const glm::dvec3 moved = map.linear * glm::dvec3(vertex) + map.translation;
        for (int i = 0; i < 3; ++i) {
            if (!any_float.contains(moved[i])) place.fail("has a mesh that extends too far from the origin");
        }
        vertex = Vec3(moved) + Vec3(0.0f); // without negative zeros
    }
    const glm::dmat3 turn = normal_map(map.linear, mirrors);
    for (Vec3& normal : result.normals) {
        const glm::dvec3 turned = turn * glm::dvec3(normal);
        const double length = std::sqrt(glm::dot(turned, turned));
        // A unit vector to float precision is not normalized again, so that it does not drift.
        const bool is_unit = std::fabs(length - 1.0) < 1e-6;
        if (length > 0.0 && std::isfinite(length)) normal = Vec3(is_unit ? turned : turned / length) + Vec3(0.0f);
    }
    if (mirrors) {
        for (std::size_t i = 0; i + 2 < result.indices.size(); i += 3) {
            std::swap(result.indices[i + 1], result.indices[i + 2]);
        }
    }
    return result;
}

void Surfaces::gather(std::size_t node, const Affine& map, std::size_t depth, GatheredTriangles& result,
                      std::vector<std::string>& warnings) {
    const Value here = (*nodes_)[node];
    if (depth > max_node_depth) {
        here.fail("must be at most " + std::to_string(max_node_depth) + " nodes below its root");
    }
    if (const auto index = here.find("mesh")) {
        if (here.find("skin")) warnings.push_back(here.place() + "its skin is not applied");
        for (const Triangles& part : mesh(*index, warnings)) {
            const Triangles moved = mapped(part, map, here);
            const std::size_t first = result.vertices.size();
            if (first + moved.vertices.size() > std::numeric_limits<std::uint32_t>::max()) here.fail("is too large");
            result.vertices.insert(result.vertices.end(), moved.vertices.begin(), moved.vertices.end());
            for (const std::uint32_t corner : moved.indices) {
                result.indices.push_back(corner + static_cast<std::uint32_t>(first));
            }
            result.parts.push_back({moved.indices.size() / 3, moved.own});
        }
    }
    for (const std::size_t child : graph_.children[node]) {
        const Value below = (*nodes_)[child];
        const auto physics = extension(below, "KHR_physics_rigid_bodies");
        if (physics && physics->find("motion")) continue; // moves independently
        gather(child, compose(map, read_affine(below)), depth + 1, result, warnings);
    }
}

GatheredTriangles Surfaces::geometry(const Value& node_index, const Affine& map, std::vector<std::string>& warnings) {
    element(nodes_, node_index, max_nodes, "nodes");
    GatheredTriangles result;
    gather(node_index.index(max_nodes, "nodes"), map, 0, result, warnings);
    if (result.indices.empty()) {
        node_index.fail("must be the index of a node with a mesh that has triangles, on itself or below it");
    }
    return result;
}

} // namespace cairn::scene
