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

/// Of a window: its width over its height.
inline constexpr float aspect = 16.0f / 9.0f;
/// Seconds between two pictures.
inline constexpr double frame = 1.0 / 60.0;

/// What a dynamic body at that place is made from.
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

/// A plane, and `boxes` boxes of one meter side by side on it, 2 m apart along x, the first at the origin.
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

/// A box of two meters as points, in the order of the bits of their number.
inline std::vector<Vec3> cube_corners() {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
    return corners;
}

/// Its surface, facing outwards.
inline Mesh cube_surface() {
    const std::vector<std::uint32_t> triangles{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                                               1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};
    return Mesh(cube_corners(), triangles);
}

/// Hills, `side` heights along each edge, `spacing` meters apart, up to a meter high.
inline HeightField hills(int side, float spacing) {
    std::vector<float> heights;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            heights.push_back(std::sin(0.6f * spacing * float(column)) * std::cos(0.5f * spacing * float(row)));
    return HeightField(side, side, {spacing, spacing}, heights);
}

/// Loads `boxes` boxes for the path "N", and fails for a path that is not a number.
inline LoadedScene load_boxes(const std::string& path) {
    if (path.find_first_not_of("0123456789") != std::string::npos)
        throw Error(ErrorCode::io, path, "", "must be a number");
    return boxes_on_plane(std::stoi(path));
}

/// What is selected, in order.
inline std::vector<BodyId> selection_of(const Stage& stage) {
    std::vector<BodyId> bodies = stage.state().selection;
    std::sort(bodies.begin(), bodies.end());
    return bodies;
}

/// Those of the bodies at these places among them.
inline std::vector<BodyId> some_of(const std::vector<BodyId>& bodies, std::initializer_list<std::size_t> places) {
    std::vector<BodyId> some;
    for (const std::size_t i : places) some.push_back(bodies[i]);
    return some;
}

/// Steps until that step is done.
inline void step_to(Stage& stage, std::uint64_t step) {
    while (stage.timeline().now().step < step) stage.step();
}

/// Goes to that step of the timeline, and waits until it is there.
inline void seek(Stage& stage, std::uint64_t step) {
    stage.apply(command::SeekTo{step});
    for (int i = 0; i < 1000 && (stage.timeline().now().step != step || stage.until_next_step() == 0.0); ++i)
        stage.advance(0.0);
    ASSERT_EQ(stage.timeline().now().step, step);
}

} // namespace cairn::viewer::test
