// Scene files, where the library is built with them.
#include "c_api/support.h"

#include <cairn/c/cairn.h>

#include <memory>
#include <span>

using namespace cairn;
using namespace cairn::c_api;

#ifdef CAIRN_C_API_SCENES

cairn_result cairn_scene_load(const char* path, cairn_world** world, float* time_step) {
    return guarded([&] {
        required(world, "world");
        auto made = std::make_unique<cairn_world>(cairn_world{scene::load(&required(path, "path"))});
        if (time_step) *time_step = made->scene.info.time_step;
        *world = made.release();
    });
}

cairn_result cairn_scene_save(const cairn_world* world, const char* path) {
    return guarded([&] {
        world_of(world);
        scene::save(world->scene, &required(path, "path"));
    });
}

cairn_result cairn_scene_load_from_memory(const void* bytes, size_t size, const char* name, cairn_world** world,
                                          float* time_step) {
    return guarded([&] {
        required(world, "world");
        require_list(bytes, size, "bytes");
        const std::span text(static_cast<const std::byte*>(bytes), size);
        auto made = std::make_unique<cairn_world>(cairn_world{scene::load_from_memory(text, &required(name, "name"))});
        if (time_step) *time_step = made->scene.info.time_step;
        *world = made.release();
    });
}

cairn_result cairn_scene_save_to_memory(const cairn_world* world, char* text, size_t capacity, size_t* length) {
    return guarded([&] {
        require_room(text, capacity, length, "text");
        world_of(world);
        write_text(scene::save_to_string(world->scene), text, capacity, length);
    });
}

#else

cairn_result cairn_scene_load(const char*, cairn_world**, float*) {
    return guarded([] { throw Error(ErrorCode::unsupported, "scene files", "", "this build has none"); });
}

cairn_result cairn_scene_save(const cairn_world*, const char*) {
    return guarded([] { throw Error(ErrorCode::unsupported, "scene files", "", "this build has none"); });
}

cairn_result cairn_scene_load_from_memory(const void*, size_t, const char*, cairn_world**, float*) {
    return guarded([] { throw Error(ErrorCode::unsupported, "scene files", "", "this build has none"); });
}

cairn_result cairn_scene_save_to_memory(const cairn_world*, char*, size_t, size_t*) {
    return guarded([] { throw Error(ErrorCode::unsupported, "scene files", "", "this build has none"); });
}

#endif
