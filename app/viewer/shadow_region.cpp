#include "viewer/shadow_region.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace cairn::viewer {

ShadowRegion shadow_region(const RenderFrame& frame) {
    const Vec3 target(frame.camera.target - frame.origin);
    const float distance =
        std::max(0.1f, lens_of(frame.camera) * float(glm::length(frame.camera.position - frame.camera.target)));
    const float reach = 5.0f * distance;
    float radius = 0.0f;
    const auto include = [&](const std::vector<Instance>& instances) {
        for (const Instance& instance : instances) {
            const float needed = glm::length(instance.position - target) + instance.bound_radius;
            if (needed < reach) radius = std::max(radius, needed);
        }
    };
    include(frame.spheres);
    include(frame.boxes);
    include(frame.capsules);
    include(frame.cylinders);
    for (const MeshInstances& group : frame.meshes) {
        if (group.mesh->look == MeshVisual::facets) {
            include(group.instances);
            continue;
        }
        for (const Instance& instance : group.instances) { // usually larger than its visible part
            const float needed = glm::length(instance.position - target) + instance.bound_radius;
            radius = std::max(radius, std::min(1.5f * distance, needed));
        }
    }
    if (radius <= 0.0f) radius = 0.5f * reach;
    constexpr float step = 1.3f; // coarse steps, so that the region rarely changes
    radius = std::pow(step, std::ceil(std::log(radius) / std::log(step)));
    return {target, radius};
}

} // namespace cairn::viewer
