#include "viewer/culling.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace cairn::viewer {

SidePlanes side_planes(const glm::mat4& clip_from_world) {
    // -w <= x <= w and -w <= y <= w, where x, y and w are rows of the matrix times the point (Gribb and Hartmann 2001).
    const glm::mat4 rows = glm::transpose(clip_from_world);
    SidePlanes planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]};
    for (glm::vec4& plane : planes) plane /= glm::length(Vec3(plane));
    return planes;
}

std::vector<IndexRange> visible_ranges(const ShapeMesh& mesh, std::span<const Instance> instances,
                                       const SidePlanes& planes) {
    const auto is_visible = [&](const MeshPart& part) {
        return std::any_of(instances.begin(), instances.end(), [&](const Instance& instance) {
            const Quat rotation(instance.rotation.w, instance.rotation.x, instance.rotation.y, instance.rotation.z);
            const Vec3 center = instance.position + rotation * part.center;
            return std::none_of(planes.begin(), planes.end(), [&](const glm::vec4& plane) {
                return glm::dot(Vec3(plane), center) + plane.w < -part.radius;
            });
        });
    };
    std::vector<IndexRange> ranges;
    for (const MeshPart& part : mesh.parts) {
        if (!is_visible(part)) continue;
        if (!ranges.empty() && ranges.back().first + ranges.back().count == part.first)
            ranges.back().count += part.count;
        else
            ranges.push_back({part.first, part.count});
    }
    return ranges;
}

} // namespace cairn::viewer
