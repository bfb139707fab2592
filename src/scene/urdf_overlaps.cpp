#include "scene/urdf_overlaps.h"

#include "scene/layers.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace cairn::scene {

namespace {

using PartPair = std::pair<std::size_t, std::size_t>;

// Returns the pairs of parts that overlap, except pairs with a common joint, which do not collide anyway.
std::set<PartPair> overlaps(const std::vector<RobotPart>& parts, const World& world) {
    std::map<ShapeId, std::size_t> owners;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].body.is_null()) continue;
        const std::vector<ShapeId> shapes = world.body(parts[i].body).shapes();
        for (std::size_t k = parts[i].scenery; k < shapes.size(); ++k) owners.emplace(shapes[k], i);
    }
    const auto are_joined = [&](std::size_t a, std::size_t b) {
        return (parts[a].joint && parts[a].parent == b) || (parts[b].joint && parts[b].parent == a);
    };
    std::set<PartPair> pairs;
    for (const auto& [shape, part] : owners) {
        for (const ShapeId met : world.overlap(world.shape(shape), world.shape_transform(shape))) {
            const auto other = owners.find(met);
            if (other == owners.end() || other->second == part || are_joined(part, other->second)) continue;
            pairs.insert(std::minmax(part, other->second));
        }
    }
    return pairs;
}

// Returns parts, at most as many as there are layers, that cover all of the pairs, or as many as possible, choosing the
// part with the most pairs first. Removes the covered pairs from `pairs`.
std::vector<std::size_t> take_covering_parts(std::set<PartPair>& pairs) {
    std::vector<std::size_t> cover;
    while (!pairs.empty() && cover.size() < max_kinds) {
        std::map<std::size_t, std::size_t> counts;
        for (const auto& [a, b] : pairs) ++counts[a], ++counts[b];
        const std::size_t most = std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) {
                                     return a.second < b.second;
                                 })->first;
        cover.push_back(most);
        std::erase_if(pairs, [&](const PartPair& pair) { return pair.first == most || pair.second == most; });
    }
    return cover;
}

std::string names_of(const std::set<PartPair>& pairs, const std::vector<RobotPart>& parts) {
    constexpr std::size_t max_named = 3;
    std::string text;
    std::size_t named = 0;
    for (const auto& [a, b] : pairs) {
        if (named++ == max_named) break;
        text += std::string(text.empty() ? "" : ", ") + "\"" + parts[a].links.front().link->name + "\" and \"" +
                parts[b].links.front().link->name + "\"";
    }
    if (pairs.size() > max_named) text += " and " + std::to_string(pairs.size() - max_named) + " other pairs";
    return text;
}

} // namespace

// Two shapes collide if each is in a layer that the other collides with. So one part of each overlapping pair needs a
// layer of its own, which the other part's filter excludes.
void disable_overlapping_collisions(const std::string& name, const std::vector<RobotPart>& parts, Scene& scene) {
    std::set<PartPair> apart = overlaps(parts, scene.world), left = apart;
    if (apart.empty()) return;
    const std::vector<std::size_t> cover = take_covering_parts(left);
    for (const PartPair& pair : left) apart.erase(pair);
    std::map<std::size_t, CollisionFilter> filters;
    for (std::size_t i = 0; i < cover.size(); ++i) {
        filters[cover[i]].layers = std::uint64_t{1} << (i + 1);
        scene.collision_systems.push_back(parts[cover[i]].links.front().link->name);
    }
    const auto leave_out = [&](std::size_t part, std::size_t other) {
        const auto found = std::find(cover.begin(), cover.end(), other);
        if (found != cover.end()) filters[part].collides_with &= ~(std::uint64_t{2} << (found - cover.begin()));
    };
    for (const auto& [a, b] : apart) leave_out(a, b), leave_out(b, a);
    for (const auto& [part, filter] : filters) {
        const std::vector<ShapeId> shapes = scene.world.body(parts[part].body).shapes();
        for (std::size_t k = parts[part].scenery; k < shapes.size(); ++k) scene.world.set_filter(shapes[k], filter);
    }
    scene.warnings.push_back(
        name + ": links that overlap in the initial pose do not collide: " + names_of(apart, parts) +
        (left.empty() ? ""
                      : "; " + std::to_string(left.size()) + " more pairs do collide, because only " +
                            std::to_string(max_kinds) + " layers can distinguish links"));
}

} // namespace cairn::scene
