#include "scene/node_graph.h"

#include <string>

namespace cairn::scene {

namespace {

constexpr std::size_t nobody = static_cast<std::size_t>(-1);

std::string node_name(std::size_t index) { return "nodes[" + std::to_string(index) + "]"; }

// Every node except the roots has exactly one parent, so a cycle is an endless chain of parents.
void refuse_circles(const Value& nodes, const std::vector<std::size_t>& parents) {
    std::vector<std::size_t> seen_from(parents.size(), nobody);
    for (std::size_t start = 0; start < parents.size(); ++start) {
        for (std::size_t node = start; node != nobody && seen_from[node] != start; node = parents[node]) {
            if (seen_from[node] != nobody) break; // visited from an earlier start, where the chain ended
            seen_from[node] = start;
            if (parents[node] != nobody && seen_from[parents[node]] == start) {
                nodes[node].fail("must not be its own ancestor");
            }
        }
    }
}

} // namespace

NodeGraph read_node_graph(const Value& document, const std::optional<Value>& scene) {
    NodeGraph graph;
    const auto nodes = document.find("nodes");
    const std::size_t count = nodes ? nodes->size(max_nodes, "nodes") : 0;
    graph.children.resize(count);
    std::vector<std::size_t> parents(count, nobody);
    for (std::size_t i = 0; i < count; ++i) {
        const auto children = (*nodes)[i].find("children");
        if (!children) continue;
        const std::size_t child_count = children->size(max_nodes, "children");
        for (std::size_t k = 0; k < child_count; ++k) {
            const Value entry = (*children)[k];
            const std::size_t child = entry.index(count, "nodes");
            if (parents[child] != nobody) {
                entry.fail("must not be listed twice; " + node_name(child) + " is a child of " +
                           node_name(parents[child]) + " already");
            }
            parents[child] = i;
            graph.children[i].push_back(child);
        }
    }
    if (nodes) refuse_circles(*nodes, parents);

    if (!scene) {
        for (std::size_t i = 0; i < count; ++i) {
            if (parents[i] == nobody) graph.roots.push_back(i);
        }
        return graph;
    }
    const auto roots = scene->find("nodes");
    const std::size_t root_count = roots ? roots->size(max_nodes, "nodes") : 0;
    std::vector<bool> listed(count, false);
    for (std::size_t k = 0; k < root_count; ++k) {
        const Value entry = (*roots)[k];
        const std::size_t root = entry.index(count, "nodes");
        if (parents[root] != nobody) {
            entry.fail("must be a root, and " + node_name(root) + " is a child of " + node_name(parents[root]));
        }
        if (listed[root]) entry.fail("must not be listed twice");
        listed[root] = true;
        graph.roots.push_back(root);
    }
    return graph;
}

} // namespace cairn::scene
