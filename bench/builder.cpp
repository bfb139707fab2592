#include "bench/builder.h"

#include "bench/mass.h"

namespace cairn::bench {

SceneBody& Builder::body(Motion motion, Vec3 position, std::span<const Part> parts, float density, Quat rotation) {
    SceneBody body;
    body.motion = motion;
    body.position = position;
    body.rotation = rotation;
    body.density = density;
    body.first_part = scene.parts.size();
    body.part_count = parts.size();
    scene.parts.insert(scene.parts.end(), parts.begin(), parts.end());
    if (motion == Motion::dynamic) {
        MassProperties sum;
        for (const Part& part : parts) sum = sum + mass_of(scene, part, double(density));
        body.mass = static_cast<float>(sum.mass);
        body.center_of_mass = Vec3(sum.center);
        body.inertia = Mat3(sum.inertia);
        ++scene.dynamic_count;
    }
    scene.bodies.push_back(body);
    return scene.bodies.back();
}

void Builder::room(float half_width, float height) {
    constexpr float thickness = 2.0f; // half thickness
    const float outer = half_width + 2 * thickness, center = half_width + thickness, middle = height / 2;
    box(Motion::fixed, {0, -thickness, 0}, {outer, thickness, outer});
    const auto wall = [&](Vec3 position, Vec3 half_extents, Vec3 inner_face) {
        Part part = box_part(half_extents);
        part.inner_face = inner_face;
        body(Motion::fixed, position, part);
    };
    wall({center, middle, 0}, {thickness, middle, outer}, {-1, 0, 0});
    wall({-center, middle, 0}, {thickness, middle, outer}, {1, 0, 0});
    wall({0, middle, center}, {half_width, middle, thickness}, {0, 0, -1});
    wall({0, middle, -center}, {half_width, middle, thickness}, {0, 0, 1});
    const float reach = half_width + 0.5f;
    scene.lower_bound = {-reach, -0.5f, -reach};
    scene.upper_bound = {reach, 1e9f, reach};
}

void Builder::drum(Vec3 center, float half_width, float half_depth, float speed) {
    constexpr float thickness = 1.0f; // half thickness
    const float outer = half_width + 2 * thickness, depth = half_depth + 2 * thickness;
    std::vector<Part> walls;
    const auto wall = [&](Vec3 position, Vec3 half_extents, Vec3 inner_face) {
        walls.push_back(box_part(half_extents, position));
        walls.back().inner_face = inner_face;
    };
    const float x = half_width + thickness, z = half_depth + thickness;
    wall({x, 0, 0}, {thickness, outer, depth}, {-1, 0, 0});
    wall({-x, 0, 0}, {thickness, outer, depth}, {1, 0, 0});
    wall({0, x, 0}, {half_width, thickness, depth}, {0, -1, 0});
    wall({0, -x, 0}, {half_width, thickness, depth}, {0, 1, 0});
    wall({0, 0, z}, {half_width, half_width, thickness}, {0, 0, -1});
    wall({0, 0, -z}, {half_width, half_width, thickness}, {0, 0, 1});
    body(Motion::kinematic, center, walls).angular_velocity = {0, 0, speed};
    scene.lower_bound = {-1e9f, -1e9f, -half_depth - 0.5f};
    scene.upper_bound = {1e9f, 1e9f, half_depth + 0.5f};
    scene.axis_point = center;
    scene.axis_distance = std::sqrt(2.0f) * half_width + 0.5f;
}

} // namespace cairn::bench
