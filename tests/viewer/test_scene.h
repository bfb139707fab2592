/// \file test_scene.h
/// Small scenes for the viewer's tests.
#pragma once

#include "viewer/scene_source.h"
#include "viewer/stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace cairn::viewer::test {

/// Aspect ratio of the window, width over height.
inline constexpr float aspect = 16.0f / 9.0f;
/// Time between two frames, s.
inline constexpr double frame = 1.0 / 60.0;

/// The definition of a dynamic body at a position.
inline BodyDef body_at(const Position& position) {
    BodyDef def;
    def.position = position;
    return def;
}

inline BodyDef static_body() {
    BodyDef def;
    def.type = BodyType::static_;
    return def;
}

inline ShapeDef with_density(float density) {
    ShapeDef def;
    def.density = density;
    return def;
}

/// A plane with `boxes` cubes of 1 m side by side on it, 2 m apart along x, the first at the origin.
inline LoadedScene boxes_on_plane(int boxes = 2) {
    LoadedScene scene;
    scene.title = "boxes";
    scene.camera = {{0.0, 3.0, 10.0}, {0.0, 0.5, 0.0}};
    const BodyId ground = scene.world.create_body(static_body());
    scene.world.add_shape(ground, Plane{});
    for (int i = 0; i < boxes; ++i) {
        const BodyId box = scene.world.create_body(body_at({2.0 * i, 0.5, 0.0}));
        const ShapeId shape = scene.world.add_shape(box, Box{});
        scene.appearances.push_back({shape, {1.0f, 0.0f, 0.0f}});
    }
    return scene;
}

/// The vertices of a cube of 2 m; the bits of an index select the signs of the coordinates.
inline std::vector<Vec3> cube_corners() {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
    return corners;
}

/// The surface of that cube, facing outwards.
inline Mesh cube_surface() {
    const std::vector<std::uint32_t> triangles{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                                               1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};
    return Mesh(cube_corners(), triangles);
}

/// Hills with `side` heights along each edge, `spacing` meters apart, up to 1 m high.
inline HeightField hills(int side, float spacing) {
    std::vector<float> heights;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            heights.push_back(std::sin(0.6f * spacing * float(column)) * std::cos(0.5f * spacing * float(row)));
    return HeightField(side, side, {spacing, spacing}, heights);
}

/// Loads that number of boxes for a path that is a number, and fails for any other path.
inline LoadedScene load_boxes(const std::string& path) {
    if (path.find_first_not_of("0123456789") != std::string::npos)
        throw Error(ErrorCode::io, path, "", "must be a number");
    return boxes_on_plane(std::stoi(path));
}

/// The selected bodies, sorted.
inline std::vector<BodyId> selection_of(const Stage& stage) {
    std::vector<BodyId> bodies = stage.state().selection;
    std::sort(bodies.begin(), bodies.end());
    return bodies;
}

/// The bodies at these indices.
inline std::vector<BodyId> some_of(const std::vector<BodyId>& bodies, std::initializer_list<std::size_t> places) {
    std::vector<BodyId> some;
    for (const std::size_t i : places) some.push_back(bodies[i]);
    return some;
}

/// Advances the stage to that step.
inline void step_to(Stage& stage, std::uint64_t step) {
    while (stage.timeline().now().step < step) stage.step();
}

/// Seeks to that step of the timeline, and waits until the stage has reached it.
inline void seek(Stage& stage, std::uint64_t step) {
    stage.apply(command::SeekTo{step});
    for (int i = 0; i < 1000 && (stage.timeline().now().step != step || stage.until_next_step() == 0.0); ++i)
        stage.advance(0.0);
    ASSERT_EQ(stage.timeline().now().step, step);
}

} // namespace cairn::viewer::test
