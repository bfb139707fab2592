// The types behind the pointers of the C API.
#pragma once

#include <cairn/world.h>

#include <variant>

#ifdef CAIRN_C_API_SCENES
#include "scene/scene.h"
#endif

// A world, with the scene data from its file.
struct cairn_world {
#ifdef CAIRN_C_API_SCENES
    cairn::scene::Scene scene;
    cairn::World& world() { return scene.world; }
#else
    cairn::World only_world;
    cairn::World& world() { return only_world; }
#endif
};

struct cairn_geometry {
    std::variant<cairn::Hull, cairn::Mesh, cairn::HeightField> shape;
};

struct cairn_snapshot {
    cairn::Snapshot snapshot;
};
