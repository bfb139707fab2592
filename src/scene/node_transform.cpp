#include "scene/node_transform.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

// Scales beyond this range are errors of the file.
constexpr Range scale_range{-1e9, 1e9, false};
// Maximum cosine between two axes that count as perpendicular: a tenth of a tolerance of 1 mm per meter.
constexpr double skew_tolerance = 1e-4;

// Decomposes a linear map whose columns are perpendicular into rotation and scale. A reflection becomes a negative
// scale along x.
void decompose(glm::dmat3 linear, NodeTransform& out) {
    for (int i = 0; i < 3; ++i) out.scale[i] = std::sqrt(glm::dot(linear[i], linear[i]));
    if (out.scale.x == 0.0 || out.scale.y == 0.0 || out.scale.z == 0.0) {
        out.rotation = glm::dquat(1.0, 0.0, 0.0, 0.0); // flattened: shapes below this node are disabled
        return;
    }
    for (int i = 0; i < 3; ++i) linear[i] /= out.scale[i];
    for (int i = 0; i < 3; ++i) {
        if (std::fabs(glm::dot(linear[i], linear[(i + 1) % 3])) > skew_tolerance) {
            out.is_skewed = true;
        }
    }
    if (glm::dot(glm::cross(linear[0], linear[1]), linear[2]) < 0.0) {
        out.scale.x = -out.scale.x;
        linear[0] = -linear[0];
    }
    const glm::dquat q = glm::quat_cast(linear);
    out.rotation = q / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

} // namespace

NodeTransform parts_of(const Affine& map) {
    NodeTransform transform;
    transform.translation = map.translation;
    decompose(map.linear, transform);
    return transform;
}

namespace {

NodeTransform from_matrix(const Value& matrix) {
    const std::size_t count = matrix.size(16, "numbers");
    if (count != 16) matrix.fail("must be an array of 16 numbers");
    double m[16];
    for (std::size_t i = 0; i < 16; ++i) m[i] = matrix[i].number(any_float);
    if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0) {
        matrix.fail("must be an affine transform, with 0, 0, 0, 1 as its last row");
    }
    return parts_of({glm::dmat3({m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}), {m[12], m[13], m[14]}});
}

bool is_even(const glm::dvec3& scale) { return scale.x == scale.y && scale.y == scale.z; }

bool is_identity(const glm::dquat& q) { return q.x == 0.0 && q.y == 0.0 && q.z == 0.0; }

} // namespace

NodeTransform read_transform(const Value& node) {
    if (const auto matrix = node.find("matrix")) {
        for (const char* other : {"translation", "rotation", "scale"}) {
            if (const auto both = node.find(other)) both->fail("must not stand beside a matrix");
        }
        return from_matrix(*matrix);
    }
    NodeTransform transform;
    if (const auto translation = node.find("translation")) transform.translation = translation->vector3();
    if (const auto rotation = node.find("rotation")) transform.rotation = rotation->rotation();
    if (const auto scale = node.find("scale")) transform.scale = scale->vector3(scale_range);
    return transform;
}

NodeTransform compose(const NodeTransform& parent, const NodeTransform& child) {
    NodeTransform result;
    result.is_skewed = parent.is_skewed || child.is_skewed;
    result.translation = parent.translation + parent.rotation * (parent.scale * child.translation);
    if (is_even(parent.scale) || is_identity(child.rotation)) {
        result.rotation = parent.rotation * child.rotation;
        result.scale = parent.scale * child.scale;
    } else {
        glm::dmat3 linear = glm::mat3_cast(child.rotation);
        for (int i = 0; i < 3; ++i) linear[i] = (parent.scale * linear[i]) * child.scale[i];
        decompose(linear, result);
        result.rotation = parent.rotation * result.rotation;
    }
    return result;
}

Affine affine(const glm::dvec3& scale) {
    Affine result;
    for (int i = 0; i < 3; ++i) result.linear[i] *= scale[i];
    return result;
}

Affine read_affine(const Value& node) {
    const NodeTransform parts = read_transform(node);
    Affine result;
    result.translation = parts.translation;
    if (const auto matrix = node.find("matrix")) {
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) {
                result.linear[column][row] = (*matrix)[static_cast<std::size_t>(4 * column + row)].number(any_float);
            }
        }
        return result;
    }
    result.linear = glm::mat3_cast(parts.rotation) * affine(parts.scale).linear;
    return result;
}

Affine compose(const Affine& parent, const Affine& child) {
    return {parent.linear * child.linear, parent.linear * child.translation + parent.translation};
}

std::optional<glm::dquat> rotation_of(const glm::dmat3& linear) {
    const auto unit = [](const glm::dvec3& v) -> std::optional<glm::dvec3> {
        const double length = std::sqrt(glm::dot(v, v));
        return length > 1e-12 && length < 1e12 ? std::optional(v / length) : std::nullopt;
    };
    const auto x = unit(linear[0]), along = unit(linear[1]);
    if (!x || !along) return std::nullopt;
    const auto y = unit(*along - *x * glm::dot(*x, *along));
    if (!y) return std::nullopt;
    return glm::normalize(glm::quat_cast(glm::dmat3(*x, *y, glm::cross(*x, *y))));
}

void require_usable(const NodeTransform& transform, const Value& node) {
    if (transform.is_skewed) {
        node.refuse("is skewed by a rotation below a nonuniform scale, which would distort its shapes");
    }
    for (int i = 0; i < 3; ++i) {
        if (!any_float.contains(transform.translation[i]) || !scale_range.contains(transform.scale[i])) {
            node.fail("is too far from the origin or too large, with the transforms above it");
        }
    }
}

} // namespace cairn::scene
