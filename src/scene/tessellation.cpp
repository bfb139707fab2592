#include "scene/tessellation.h"

#include <cairn/triangles.h>

#include <array>
#include <cmath>
#include <utility>

namespace cairn::scene {

namespace {

constexpr float plane_half_size = 100.0f; // m, for infinite planes
constexpr int sectors = 32;               // around the axis
constexpr int quarter = 8;                // steps from the equator of a sphere to its pole

// Returns cosine and sine of i / 32 turns, for i from -8 to 32, by the addition theorem: the same on every machine.
struct Turn {
    double cosine = 1.0, sine = 0.0;
};
constexpr Turn step{0.98078528040323044913, 0.19509032201612826785}; // of 2 pi / 32

Turn turn(int i) {
    Turn result;
    const double sine = i < 0 ? -step.sine : step.sine;
    for (int k = 0; k < std::abs(i); ++k) {
        result = {result.cosine * step.cosine - result.sine * sine, result.sine * step.cosine + result.cosine * sine};
    }
    return result;
}

// A point of the profile of a surface of revolution: its distance from the axis, its height, and its normal.
struct ProfilePoint {
    double radius, height, out, up;
};

// Adds the surface that a profile sweeps around the y axis; the profile goes upward, with its outside to the right.
void revolve(const std::vector<ProfilePoint>& profile, Surface& surface) {
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    for (const ProfilePoint& p : profile) {
        for (int i = 0; i <= sectors; ++i) {
            const Turn t = turn(i % sectors);
            surface.vertices.push_back(Vec3(p.radius * t.cosine, p.height, -p.radius * t.sine));
            surface.normals.push_back(Vec3(p.out * t.cosine, p.up, -p.out * t.sine));
        }
    }
    constexpr std::uint32_t row = sectors + 1;
    for (std::uint32_t k = 0; k + 1 < profile.size(); ++k) {
        for (std::uint32_t i = 0; i < sectors; ++i) {
            const std::uint32_t a = first + k * row + i, b = a + 1, c = b + row, d = a + row;
            // At a pole one of the two triangles has no area.
            if (profile[k].radius > 0.0) surface.indices.insert(surface.indices.end(), {a, b, c});
            if (profile[k + 1].radius > 0.0) surface.indices.insert(surface.indices.end(), {a, c, d});
        }
    }
}

void add_polygon(const std::vector<Vec3>& corners, Surface& surface) {
    glm::dvec3 sum(0.0); // Newell's normal: robust where vertices are collinear
    for (std::size_t i = 0; i < corners.size(); ++i) {
        sum +=
            glm::cross(glm::dvec3(corners[i] - corners[0]), glm::dvec3(corners[(i + 1) % corners.size()] - corners[0]));
    }
    const double length = std::sqrt(glm::dot(sum, sum));
    const Vec3 normal = length > 0.0 ? Vec3(sum / length) : Vec3(0.0f, 1.0f, 0.0f);
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    for (const Vec3& corner : corners) {
        surface.vertices.push_back(corner);
        surface.normals.push_back(normal);
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i) {
        surface.indices.insert(surface.indices.end(), {first, first + i - 1, first + i});
    }
}

void add_ball(double radius, double height, Surface& surface) {
    std::vector<ProfilePoint> profile;
    for (int i = -quarter; i <= quarter; ++i) {
        const Turn t = turn(i);
        const double out = std::abs(i) == quarter ? 0.0 : t.cosine;
        profile.push_back({radius * out, height + radius * t.sine, out, t.sine});
    }
    revolve(profile, surface);
}

struct Tessellator {
    Surface& surface;

    void operator()(const Sphere& sphere) const { add_ball(sphere.radius, 0.0, surface); }
    void operator()(const Box& box) const {
        const Vec3 h = box.half_extents;
        for (int axis = 0; axis < 3; ++axis) {
            for (const float side : {-1.0f, 1.0f}) {
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                std::vector<Vec3> corners;
                for (const auto& [s, t] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
                    Vec3 corner;
                    corner[axis] = side * h[axis];
                    corner[u] = side * s * h[u];
                    corner[v] = t * h[v];
                    corners.push_back(corner);
                }
                add_polygon(corners, surface);
            }
        }
    }
    void operator()(const Plane& plane) const {
        const glm::dvec3 up = glm::normalize(glm::dvec3(plane.normal));
        const glm::dvec3 guess = plane.half_extents      ? glm::dvec3(plane.tangent)
                                 : std::fabs(up.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0)
                                                         : glm::dvec3(0.0, 0.0, 1.0);
        const glm::dvec3 x = glm::normalize(guess - up * glm::dot(up, guess)), z = glm::cross(x, up);
        glm::dvec2 half(plane.half_extents.value_or(glm::vec2(plane_half_size)));
        for (int i = 0; i < 2; ++i) half[i] = std::isinf(half[i]) ? double(plane_half_size) : half[i];
        const auto corner = [&](double s, double t) { return Vec3(x * (s * half.x) + z * (t * half.y)); };
        add_polygon({corner(-1, -1), corner(-1, 1), corner(1, 1), corner(1, -1)}, surface);
        if (plane.double_sided) add_polygon({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, surface);
    }
    void operator()(const Capsule& capsule) const {
        const double low = capsule.radius, high = capsule.radius_top.value_or(capsule.radius), h = capsule.half_height;
        const double rise = (low - high) / (2.0 * h); // sine of the elevation of the side's normal
        if (std::fabs(rise) >= 1.0) {                 // one sphere contains the other
            add_ball(low > high ? low : high, low > high ? -h : h, surface);
            return;
        }
        std::vector<ProfilePoint> profile;
        const double out = std::sqrt(1.0 - rise * rise);
        for (int i = -quarter; i < quarter && turn(i).sine < rise; ++i) {
            const Turn t = turn(i);
            const double side = i == -quarter ? 0.0 : t.cosine;
            profile.push_back({low * side, -h + low * t.sine, side, t.sine});
        }
        profile.push_back({low * out, -h + low * rise, out, rise});
        profile.push_back({high * out, h + high * rise, out, rise});
        for (int i = -quarter + 1; i <= quarter; ++i) {
            const Turn t = turn(i);
            const double side = i == quarter ? 0.0 : t.cosine;
            if (t.sine > rise) profile.push_back({high * side, h + high * t.sine, side, t.sine});
        }
        revolve(profile, surface);
    }
    void operator()(const Cylinder& cylinder) const {
        const double low = cylinder.radius, high = cylinder.radius_top.value_or(cylinder.radius);
        const double h = cylinder.half_height, slope = std::sqrt((low - high) * (low - high) + 4.0 * h * h);
        revolve({{0.0, -h, 0.0, -1.0}, {low, -h, 0.0, -1.0}}, surface);
        revolve({{low, -h, 2.0 * h / slope, (low - high) / slope}, {high, h, 2.0 * h / slope, (low - high) / slope}},
                surface);
        if (high > 0.0) revolve({{high, h, 0.0, 1.0}, {0.0, h, 0.0, 1.0}}, surface);
    }
    void operator()(const Hull& hull) const {
        for (std::size_t f = 0; f < hull.face_count(); ++f) {
            std::vector<Vec3> corners;
            for (const std::uint32_t i : hull.face(f)) corners.push_back(hull.vertices()[i]);
            add_polygon(corners, surface);
        }
    }
    void operator()(const Mesh& mesh) const {
        surface.vertices.assign(mesh.vertices().begin(), mesh.vertices().end());
        surface.indices.assign(mesh.indices().begin(), mesh.indices().end());
    }
    void operator()(const HeightField& field) const {
        const std::vector<Vec3> vertices = field.vertices();
        // The index of each height sample among the vertices plus 1; 0: none yet.
        std::vector<std::uint32_t> number(vertices.size(), 0);
        for (const std::uint32_t corner : field.indices()) {
            if (number[corner] == 0) {
                surface.vertices.push_back(vertices[corner]);
                number[corner] = static_cast<std::uint32_t>(surface.vertices.size());
            }
            surface.indices.push_back(number[corner] - 1);
        }
    }
};

} // namespace

Surface tessellate(const Shape& shape) {
    Surface surface;
    if (rounding_of(shape) > 0.0f) {
        ShapeTriangles triangles = rounded_triangles(shape);
        surface.vertices = std::move(triangles.vertices);
        surface.normals = std::move(triangles.normals);
        surface.indices = std::move(triangles.indices);
        return surface;
    }
    std::visit(Tessellator{surface}, shape);
    return surface;
}

} // namespace cairn::scene
