// Poses of nodes: translation, rotation and scale, read from a node and composed down the hierarchy.
#pragma once

#include "scene/json_value.h"

namespace cairn::scene {

// Applied to a point in the order scale, rotation, translation (glTF 2.0, section 3.5.3).
struct NodeTransform {
    glm::dvec3 translation{0.0, 0.0, 0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0, 1.0, 1.0};
    bool is_skewed = false; // a rotation below a nonuniform scale: the components above only approximate the map
};

// The transform of a node relative to its parent, from its translation, rotation and scale or its matrix.
NodeTransform read_transform(const Value& node);

// Returns the transform of `child` in the frame in which `parent` is given.
NodeTransform compose(const NodeTransform& parent, const NodeTransform& child);

// Any affine map, as a node applies it to a mesh, with or without skew.
struct Affine {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0, 0.0, 0.0};
};
Affine read_affine(const Value& node);
Affine compose(const Affine& parent, const Affine& child);
Affine affine(const glm::dvec3& scale); // a scale only
NodeTransform parts_of(const Affine& map);

// Returns the rotation whose first axis is the direction of the first column, and whose second axis is in the plane of
// the first two columns; nothing if those are linearly dependent. A reflection is attributed to the last axis.
std::optional<glm::dquat> rotation_of(const glm::dmat3& linear);

// Refuses a transform that no body or shape can have: skewed, or out of the range of a float.
void require_usable(const NodeTransform& transform, const Value& node);

} // namespace cairn::scene
