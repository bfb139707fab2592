// Triangles of the meshes of a document, for colliders and for visuals.
#pragma once

#include "scene/accessors.h"
#include "scene/node_graph.h"
#include "scene/node_transform.h"

#include <cairn/math.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_meshes = 1'000'000;
inline constexpr std::size_t max_primitives = 100'000; // per mesh
// The most vertices and indices of all colliders and visual meshes of a file together, counted once per use.
inline constexpr std::size_t max_surface_numbers = std::size_t{1} << 26;

// One primitive of a mesh, as triangles.
struct Triangles {
    std::vector<Vec3> vertices;
    std::vector<Vec3> normals; // one for each vertex, or none
    std::vector<std::uint32_t> indices;
    std::optional<Value> material;   // the index of the material
    std::optional<Value> attributes; // of the primitive
    std::optional<Value> own;        // the extension CAIRN_mesh of the primitive
};

// The triangles that a collider's geometry.node refers to.
struct GatheredTriangles {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices;
    struct Part {
        std::size_t triangles;    // in the order of the indices
        std::optional<Value> own; // the extension CAIRN_mesh of the primitive
    };
    std::vector<Part> parts;
};

class Surfaces {
  public:
    // The graph must outlive this object.
    Surfaces(const Value& document, Buffers buffers, const NodeGraph& graph)
        : meshes_(document.find("meshes")), nodes_(document.find("nodes")), accessors_(document, std::move(buffers)),
          graph_(graph) {}

    // Returns the primitives of the mesh that `index` refers to, which are read once. Primitives without triangles are
    // left out, with a warning.
    const std::vector<Triangles>& mesh(const Value& index, std::vector<std::string>& warnings);

    // Returns the mesh of a node and those of the nodes below it (except below another node with a motion), in the
    // frame of that node, then mapped by `map`. A reflection reverses the triangles, so that their outside stays
    // outside.
    GatheredTriangles geometry(const Value& node_index, const Affine& map, std::vector<std::string>& warnings);

    // Returns `triangles` mapped by `map`.
    Triangles mapped(const Triangles& triangles, const Affine& map, const Value& place);

    Accessors& accessors() { return accessors_; }

  private:
    std::vector<Triangles> read(const Value& mesh, std::vector<std::string>& warnings);
    std::optional<Triangles> read_primitive(const Value& primitive, std::vector<std::string>& warnings);
    void gather(std::size_t node, const Affine& map, std::size_t depth, GatheredTriangles& result,
                std::vector<std::string>& warnings);

    std::optional<Value> meshes_, nodes_;
    Accessors accessors_;
    const NodeGraph& graph_;
    std::map<std::size_t, std::vector<Triangles>> read_;
    std::size_t remaining_numbers_ = max_surface_numbers;
};

} // namespace cairn::scene
