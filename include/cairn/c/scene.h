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

/// Reads a scene file (.gltf, .glb) or a model (URDF, MJCF, SDF, USD) into a new world. `time_step` receives the time
/// step for which the scene is intended, in seconds; it may be null. Builds without scene files refuse the call
/// (unsupported). Errors: invalid_file, io, invalid_value, unsupported.
CAIRN_C_API cairn_result cairn_scene_load(const char* path, cairn_world** world, float* time_step);

/// Writes the present state of the world to a file: binary .glb if the name ends so, otherwise .gltf. Other contents of
/// the file from which the world was loaded are kept. Builds without scene files refuse the call (unsupported). Errors:
/// io, invalid_value, wrong_state, unsupported.
CAIRN_C_API cairn_result cairn_scene_save(const cairn_world* world, const char* path);

/// Reads the contents of a scene file from memory, as `cairn_scene_load` does from a file. References to other files
/// are refused. `name` stands for the file name in error messages. Errors: invalid_file, invalid_value, unsupported.
CAIRN_C_API cairn_result cairn_scene_load_from_memory(const void* bytes, size_t size, const char* name,
                                                      cairn_world** world, float* time_step);

/// Returns the text that `cairn_scene_save` writes to a .gltf file. `length` receives the length of the whole text
/// without the terminating zero; text beyond `capacity` bytes is cut off. Errors: invalid_value, wrong_state,
/// unsupported.
CAIRN_C_API cairn_result cairn_scene_save_to_memory(const cairn_world* world, char* text, size_t capacity,
                                                    size_t* length);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_SCENE_H
