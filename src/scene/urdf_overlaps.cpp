#include "scene/urdf_overlaps.h"

#include "scene/layers.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace cairn::scene {

namespace {

using PartPair = std::pair<std::size_t, std::size_t>;

// Pairs of parts that overlap, but those of a joint, which do not collide anyway.
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

} // namespace

void separate_overlaps(const std::string& name, const std::vector<RobotPart>& parts, Scene& scene) {
    constexpr std::size_t max_named = 3;
    const std::set<PartPair> pairs = overlaps(parts, scene.world);
    if (pairs.empty()) return;
    std::vector<std::size_t> kinds; // the parts that have a layer of their own
    std::set<PartPair> apart;
    std::string named;
    for (const PartPair& pair : pairs) {
        std::vector<std::size_t> with = kinds;
        for (const std::size_t part : {pair.first, pair.second}) {
            if (std::find(with.begin(), with.end(), part) == with.end()) with.push_back(part);
        }
        if (with.size() > max_kinds) continue;
        kinds = std::move(with);
        apart.insert(pair);
        if (apart.size() > max_named) continue;
        named += std::string(named.empty() ? "" : ", ") + "\"" + parts[pair.first].links.front().link->name +
                 "\" and \"" + parts[pair.second].links.front().link->name + "\"";
    }
    const auto filters =
        filters_of_kinds(kinds, [&](std::size_t a, std::size_t b) { return apart.count(std::minmax(a, b)) == 0; });
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const RobotPart& part = parts[kinds[i]];
        scene.collision_systems.push_back(part.links.front().link->name);
        const std::vector<ShapeId> shapes = scene.world.body(part.body).shapes();
        for (std::size_t k = part.scenery; k < shapes.size(); ++k) scene.world.set_filter(shapes[k], filters[i]);
    }
    const std::size_t left = pairs.size() - apart.size();
    scene.warnings.push_back(
        name + ": links that overlap as the robot is drawn do not collide: " + named +
        (apart.size() > max_named ? " and " + std::to_string(apart.size() - max_named) + " other pairs" : "") +
        (left > 0 ? "; " + std::to_string(left) + " more pairs do, as only 63 links can be told apart" : ""));
}

} // namespace cairn::scene
