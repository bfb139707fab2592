// Meshes that several tests share.
#pragma once

#include "geometry_test_support.h"

#include <vector>

namespace cairn::test {

struct Soup {
    std::vector<math::Vec3> vertices;
    std::vector<std::uint32_t> indices;
};

// A closed convex mesh of 2 sectors (rings - 1) triangles whose vertices are on a sphere about the origin.
inline Soup ball_soup(int rings, int sectors, double radius) {
    Soup soup;
    const double pi = 3.14159265358979323846;
    for (int r = 0; r <= rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const bool pole = r == 0 || r == rings;
            const double out = pole ? 0 : std::sin(pi * r / rings), angle = 2 * pi * s / sectors;
            soup.vertices.push_back(math::to_float(DVec3{
                radius * out * std::cos(angle), radius * std::cos(pi * r / rings), radius * out * std::sin(angle)}));
        }
    auto at = [&](int r, int s) { return std::uint32_t(r * sectors + s % sectors); };
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            if (r > 0) soup.indices.insert(soup.indices.end(), {at(r, s), at(r, s + 1), at(r + 1, s)});
            if (r + 1 < rings) soup.indices.insert(soup.indices.end(), {at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
        }
    return soup;
}

// Random triangles, some with shared vertices.
inline Soup random_soup(Random& random, std::size_t triangles, double reach) {
    Soup soup;
    for (std::size_t i = 0; i < triangles + 8; ++i) soup.vertices.push_back(math::to_float(random.point(reach)));
    for (std::size_t i = 0; i < triangles; ++i) {
        // Mostly small triangles, whose vertices are close to each other.
        const math::Vec3 center = soup.vertices[i];
        for (int k = 0; k < 3; ++k) {
            if (k == 0 && random(0, 1) < 0.5) {
                soup.indices.push_back(std::uint32_t(random.below(soup.vertices.size())));
            } else {
                soup.indices.push_back(std::uint32_t(soup.vertices.size()));
                soup.vertices.push_back(center + math::to_float(random.point(0.1 * reach)));
            }
        }
    }
    return soup;
}

inline HeightFieldData random_field(Random& random, int columns, int rows, float spacing_x, float spacing_z) {
    std::vector<float> heights(std::size_t(columns) * std::size_t(rows));
    for (float& h : heights) h = float(random(-1, 1));
    return build_height_field(columns, rows, spacing_x, spacing_z, heights);
}

} // namespace cairn::test
