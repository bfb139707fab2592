#include "world/wireframe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace cairn {

namespace {

constexpr int circle_steps = 24, arc_steps = 6;
constexpr float plane_half = 10.0f, plane_cell = 2.0f; // the drawn part of an infinite plane, m

// Points of the unit circle at steps of 15 degrees.
std::array<glm::vec2, circle_steps> unit_circle() {
    constexpr float cosine = 0.96592582628906831f, sine = 0.25881904510252074f;
    std::array<glm::vec2, circle_steps> points;
    glm::vec2 p(1.0f, 0.0f);
    for (glm::vec2& point : points) {
        point = p;
        p = {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
    }
    return points;
}

class EdgeLister {
  public:
    explicit EdgeLister(std::vector<Edge>& edges) : edges_(edges) {}

    void operator()(const Sphere& sphere) {
        for (int axis = 0; axis < 3; ++axis) circle(Vec3(0.0f), axis, sphere.radius);
    }
    void operator()(const Box& box) {
        for (int axis = 0; axis < 3; ++axis)
            for (const float side : {-1.0f, 1.0f}) {
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                Vec3 corners[4];
                for (int i = 0; i < 4; ++i) {
                    corners[i][axis] = side * (box.half_extents[axis] + box.rounding);
                    corners[i][u] = (i == 1 || i == 2 ? 1.0f : -1.0f) * box.half_extents[u];
                    corners[i][v] = (i >= 2 ? 1.0f : -1.0f) * box.half_extents[v];
                }
                loop(corners);
            }
    }
    void operator()(const Plane& plane) {
        const Vec3 normal = glm::normalize(plane.normal);
        Vec3 u = plane.tangent - glm::dot(plane.tangent, normal) * normal;
        if (!(glm::length(u) > 1e-6f * glm::length(plane.tangent)))
            u = glm::cross(normal, std::fabs(normal.x) < 0.5f ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
        u = glm::normalize(u);
        const Vec3 v = glm::cross(normal, u);
        const glm::vec2 half = glm::min(plane.half_extents.value_or(glm::vec2(plane_half)), glm::vec2(1e6f));
        const Vec3 corners[4] = {-half.x * u - half.y * v, half.x * u - half.y * v, half.x * u + half.y * v,
                                 half.y * v - half.x * u};
        loop(corners);
        edges_.push_back({Vec3(0.0f), 0.25f * std::min(half.x, half.y) * normal});
        if (plane.half_extents) return;
        for (float at = plane_cell - plane_half; at < plane_half; at += plane_cell) {
            edges_.push_back({at * u - plane_half * v, at * u + plane_half * v});
            edges_.push_back({at * v - plane_half * u, at * v + plane_half * u});
        }
    }
    void operator()(const Capsule& capsule) {
        const float low = capsule.radius, high = capsule.radius_top.value_or(low), apart = 2.0f * capsule.half_height;
        const float sine = (low - high) / apart; // of the angle between the lateral surface and the axis
        if (!(std::fabs(sine) < 1.0f)) {         // one end sphere contains the other
            const float radius = std::max(low, high), y = capsule.half_height * (low > high ? -1.0f : 1.0f);
            for (int axis = 0; axis < 3; ++axis) circle({0, y, 0}, axis, radius);
            return;
        }
        const float cosine = std::sqrt(1.0f - sine * sine);
        const Vec3 bottom(0, -capsule.half_height, 0), top(0, capsule.half_height, 0);
        circle(bottom + Vec3(0, low * sine, 0), 1, low * cosine);
        circle(top + Vec3(0, high * sine, 0), 1, high * cosine);
        for (const Vec3& side : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0), Vec3(0, 0, -1)}) {
            const Vec3 outward = cosine * side + Vec3(0, sine, 0);
            edges_.push_back({bottom + low * outward, top + high * outward});
            arc(bottom, low, outward, {0, -1, 0});
            arc(top, high, outward, {0, 1, 0});
        }
    }
    void operator()(const Cylinder& cylinder) {
        const float low = cylinder.radius, high = cylinder.radius_top.value_or(low), h = cylinder.half_height;
        const float r = cylinder.rounding, length = std::hypot(2.0f * h, low - high);
        // normal of the side: radial and axial component
        const glm::vec2 outward(2.0f * h / length, (low - high) / length);
        circle({0, -h - r, 0}, 1, low);
        circle({0, h + r, 0}, 1, high);
        if (r > 0.0f) {
            circle({0, -h + r * outward.y, 0}, 1, low + r * outward.x);
            circle({0, h + r * outward.y, 0}, 1, high + r * outward.x);
        }
        for (const Vec3& side : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0), Vec3(0, 0, -1)}) {
            const Vec3 shift = r * (outward.x * side + Vec3(0, outward.y, 0));
            edges_.push_back({low * side + Vec3(0, -h, 0) + shift, high * side + Vec3(0, h, 0) + shift});
        }
    }
    void operator()(const Hull& hull) {
        const std::span<const Vec3> vertices = hull.vertices();
        for (std::size_t f = 0; f < hull.face_count(); ++f) {
            const std::span<const std::uint32_t> face = hull.face(f);
            Vec3 normal(0.0f); // by Newell's method
            for (std::size_t i = 0; i < face.size(); ++i) {
                const Vec3 a = vertices[face[i]], b = vertices[face[(i + 1) % face.size()]];
                normal += glm::cross(a - vertices[face[0]], b - vertices[face[0]]);
            }
            const Vec3 shift = hull.rounding > 0.0f ? hull.rounding * glm::normalize(normal) : Vec3(0.0f);
            for (std::size_t i = 0; i < face.size(); ++i) {
                const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
                if (hull.rounding > 0.0f || a < b) edges_.push_back({vertices[a] + shift, vertices[b] + shift});
            }
        }
    }
    void operator()(const Mesh& mesh) { triangles(mesh.vertices(), mesh.indices()); }
    void operator()(const HeightField& field) { triangles(field.vertices(), field.indices()); }

  private:
    void triangles(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                pairs.push_back(std::minmax({indices[i + k], indices[i + (k + 1) % 3]}));
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        for (const auto& [a, b] : pairs) edges_.push_back({vertices[a], vertices[b]});
    }
    void loop(const Vec3 (&corners)[4]) {
        for (int i = 0; i < 4; ++i) edges_.push_back({corners[i], corners[(i + 1) % 4]});
    }
    // A circle about an axis of the shape's frame.
    void circle(const Vec3& center, int axis, float radius) {
        static const std::array<glm::vec2, circle_steps> unit = unit_circle();
        if (!(radius > 0.0f)) return;
        const auto point = [&](int i) {
            const glm::vec2 p = radius * unit[std::size_t(i % circle_steps)];
            Vec3 result = center;
            result[(axis + 1) % 3] += p.x;
            result[(axis + 2) % 3] += p.y;
            return result;
        };
        for (int i = 0; i < circle_steps; ++i) edges_.push_back({point(i), point(i + 1)});
    }
    // An arc on a sphere, from one direction to another.
    void arc(const Vec3& center, float radius, const Vec3& from, const Vec3& to) {
        if (!(radius > 0.0f)) return;
        const auto point = [&](int i) {
            const float t = float(i) / arc_steps;
            return center + radius * glm::normalize((1.0f - t) * from + t * to);
        };
        for (int i = 0; i < arc_steps; ++i) edges_.push_back({point(i), point(i + 1)});
    }

    std::vector<Edge>& edges_;
};

} // namespace

void list_edges(const Shape& shape, std::vector<Edge>& edges) {
    edges.clear();
    std::visit(EdgeLister(edges), shape);
}

} // namespace cairn
