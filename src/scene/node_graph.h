// The hierarchy of nodes: which nodes the scene shows, and the children of each.
#pragma once

#include "scene/json_value.h"

#include <cstddef>
#include <vector>

namespace cairn::scene {

inline constexpr std::size_t max_nodes = 1'000'000;
inline constexpr std::size_t max_node_depth = 256;

struct NodeGraph {
    std::vector<std::vector<std::size_t>> children; // by node
    std::vector<std::size_t> roots;                 // of the scene
};

// Reads and checks the children of all nodes: indices in range, at most one parent each, no cycles. `scene` is the
// scene object, if the file has one; without it, every node that has no parent is a root.
NodeGraph read_node_graph(const Value& document, const std::optional<Value>& scene);

} // namespace cairn::scene
