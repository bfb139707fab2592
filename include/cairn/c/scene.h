// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_SCENE_H
#define CAIRN_C_SCENE_H

#include <cairn/c/world.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Reads a scene file (.gltf, .glb) or a model (URDF, MJCF, SDF, USD) into a new world. `time_step` gets the step, in
/// seconds, that the scene is meant for; it may be null. Builds without scene files refuse (unsupported). Errors:
/// invalid_file, io, invalid_value, unsupported.
CAIRN_C_API cairn_result cairn_scene_load(const char* path, cairn_world** world, float* time_step);

/// Writes the world as it stands now to a file: a binary .glb if its name ends so, else .gltf. What came with it when
/// it was loaded is kept. Builds without scene files refuse (unsupported). Errors: io, invalid_value, wrong_state,
/// unsupported.
CAIRN_C_API cairn_result cairn_scene_save(const cairn_world* world, const char* path);

/// Reads what a scene file has from memory, as `cairn_scene_load` does from a file; other files that it names are
/// refused. `name` stands for the file in messages. Errors: invalid_file, invalid_value, unsupported.
CAIRN_C_API cairn_result cairn_scene_load_from_memory(const void* bytes, size_t size, const char* name,
                                                      cairn_world** world, float* time_step);

/// The text that `cairn_scene_save` writes to a .gltf file. `length` gets its length without the final zero; what has
/// no room in `capacity` bytes is cut off. Errors: invalid_value, wrong_state, unsupported.
CAIRN_C_API cairn_result cairn_scene_save_to_memory(const cairn_world* world, char* text, size_t capacity,
                                                    size_t* length);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_SCENE_H
