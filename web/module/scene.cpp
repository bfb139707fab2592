// Additions to the C API for the playground and the three.js meshes: triangles of shapes, and their colors.
#include "c_api/convert.h"
#include "c_api/support.h"

#include "scene/scene.h"
#include "scene/tessellation.h"

#include <cairn/c/cairn.h>

#include <memory>

using namespace cairn;
using namespace cairn::c_api;

extern "C" {

// Triangles in the frame of a shape, with the numbers of vertices and of indices; `normals` is null for flat-shaded
// triangles.
struct cairn_web_triangles {
    scene::Surface* surface;
    const Vec3 *vertices, *normals;
    size_t vertex_count;
    const uint32_t* indices;
    size_t index_count;
};

// Creates the triangles of a shape, to be freed by cairn_web_triangles_release.
CAIRN_C_API cairn_result cairn_web_shape_triangles(const cairn_world* world, cairn_shape_id shape,
                                                   cairn_web_triangles* result) {
    return guarded([&] {
        required(result, "result");
        auto surface = std::make_unique<scene::Surface>(scene::tessellate(world_of(world).shape(to_cpp(shape))));
        *result = {nullptr,
                   surface->vertices.data(),
                   surface->normals.empty() ? nullptr : surface->normals.data(),
                   surface->vertices.size(),
                   surface->indices.data(),
                   surface->indices.size()};
        result->surface = surface.release();
    });
}

CAIRN_C_API void cairn_web_triangles_release(scene::Surface* surface) { delete surface; }

// The color that a scene file gives to a shape: linear red, green and blue, each 0 to 1. `found` receives whether the
// file gives one.
CAIRN_C_API cairn_result cairn_web_shape_color(const cairn_world* world, cairn_shape_id shape, cairn_vec3* color,
                                               bool* found) {
    return guarded([&] {
        required(color, "color"), required(found, "found");
        world_of(world).body_of(to_cpp(shape)); // throws if the shape is invalid
        *found = false;
        for (const scene::Appearance& appearance : world->scene.appearances) {
            if (appearance.shape != to_cpp(shape)) continue;
            *color = to_c(appearance.color);
            *found = true;
        }
    });
}
}
