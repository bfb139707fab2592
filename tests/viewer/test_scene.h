/// \file test_scene.h
/// Small scenes for the viewer's tests.
#pragma once

#include "viewer/scene_source.h"

#include <utility>

namespace cairn::viewer::test {

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

/// Loads `boxes` boxes for the path "N", and fails for a path that is not a number.
inline LoadedScene load_boxes(const std::string& path) {
    if (path.find_first_not_of("0123456789") != std::string::npos)
        throw Error(ErrorCode::io, path, "", "must be a number");
    return boxes_on_plane(std::stoi(path));
}

} // namespace cairn::viewer::test
