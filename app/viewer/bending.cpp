#include "viewer/bending.h"

#include <glm/geometric.hpp>

namespace cairn::viewer {

TriangleMesh bent(const TriangleMesh& mesh, std::span<const BoneWeights> weights, std::span<const BoneMap> bones) {
    TriangleMesh result = mesh;
    for (std::size_t i = 0; i < result.vertices.size(); ++i) {
        glm::mat3 linear(0.0f);
        Vec3 translation(0.0f);
        for (std::size_t k = 0; k < weights[i].bones.size(); ++k) {
            const BoneMap& bone = bones[weights[i].bones[k]];
            linear += weights[i].shares[k] * bone.linear;
            translation += weights[i].shares[k] * bone.translation;
        }
        MeshVertex& vertex = result.vertices[i];
        vertex.corner = linear * vertex.corner + translation;
        // Normals transform by the cofactor matrix, like surface elements.
        const Vec3 turned = glm::mat3(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                      glm::cross(linear[0], linear[1])) *
                            vertex.normal;
        const float length = glm::length(turned);
        if (length > 0.0f) vertex.normal = turned / length;
    }
    return result;
}

} // namespace cairn::viewer
