// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_BASE_H
#define CAIRN_C_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32) && defined(CAIRN_C_BUILDING)
#define CAIRN_C_API __declspec(dllexport)
#elif defined(_WIN32)
#define CAIRN_C_API __declspec(dllimport)
#else
#define CAIRN_C_API __attribute__((visibility("default")))
#endif

/// The version of the binary interface that these headers describe; see `cairn_abi_version`.
#define CAIRN_ABI_VERSION 6

/// The result of a call. If it is not CAIRN_OK, nothing has changed, and `cairn_last_error` describes the error.
typedef int32_t cairn_result;
enum {
    CAIRN_OK = 0,
    CAIRN_ERROR_INVALID_VALUE = 1,  ///< An argument is null, NaN, infinite, or out of its range.
    CAIRN_ERROR_INVALID_HANDLE = 2, ///< A handle is null, stale, or belongs to another world.
    /// The call is not allowed in the present state (for example, during a step, or for a body of another type).
    CAIRN_ERROR_WRONG_STATE = 3,
    CAIRN_ERROR_INVALID_FILE = 4,   ///< A file or a buffer is malformed.
    CAIRN_ERROR_UNSUPPORTED = 5,    ///< The request is well formed, but this build does not support it.
    CAIRN_ERROR_IO = 6,             ///< A file could not be read or written.
    /// Memory ran out. The world is as it was, or refuses all calls (wrong_state) until it is restored.
    CAIRN_ERROR_OUT_OF_MEMORY = 7,
    CAIRN_ERROR_OTHER = 8           ///< Any other error; `cairn_last_error` has its text.
};

/// A world of rigid bodies. One world must not be used by two threads at the same time, except for functions that take
/// it as const, which may run on many threads while no other function uses it.
typedef struct cairn_world cairn_world;
/// The data of a hull, mesh or height field. It never changes, and may be used by many shapes, worlds and threads.
typedef struct cairn_geometry cairn_geometry;
/// The complete state of a world at one time, to which it can be restored.
typedef struct cairn_snapshot cairn_snapshot;

/// Names a body of a world; zero: null. Once that object is destroyed, its handle is stale. No new object gets the same
/// handle, except after `cairn_world_restore`.
typedef struct cairn_body_id {
    uint64_t bits;
} cairn_body_id;

/// Names a shape on a body of a world; zero: null. Once that object is destroyed, its handle is stale. No new object
/// gets the same handle, except after `cairn_world_restore`.
typedef struct cairn_shape_id {
    uint64_t bits;
} cairn_shape_id;

/// Names a joint of a world; zero: null. Once that object is destroyed, its handle is stale. No new object gets the
/// same handle, except after `cairn_world_restore`.
typedef struct cairn_joint_id {
    uint64_t bits;
} cairn_joint_id;

/// Names a force field of a world; zero: null. Once that object is destroyed, its handle is stale. No new object gets
/// the same handle, except after `cairn_world_restore`.
typedef struct cairn_force_field_id {
    uint64_t bits;
} cairn_force_field_id;

/// The version of the library's binary interface: CAIRN_ABI_VERSION of the headers with which it was built. It
/// increases when programs must be recompiled.
CAIRN_C_API int cairn_abi_version(void);

/// The version of the library, such as "0.1.0".
CAIRN_C_API const char* cairn_version(void);

/// The instruction set that the kernels of this process use: "avx512", "avx2", "sse2", "neon", "simd128" or "scalar".
/// Results do not depend on it.
CAIRN_C_API const char* cairn_instruction_set(void);

/// The number of hardware threads of this machine, 1 to 256: a good argument for `cairn_world_set_threads`.
CAIRN_C_API int cairn_hardware_threads(void);

/// The message of the last failed call on this thread: the argument, its value, and what was expected. Empty if no call
/// failed. Valid until the next call on this thread.
CAIRN_C_API const char* cairn_last_error(void);

/// The argument to which the last error on this thread refers, such as "BodyDef.mass"; may be empty.
CAIRN_C_API const char* cairn_last_error_field(void);

/// The value of that argument as text; may be empty.
CAIRN_C_API const char* cairn_last_error_value(void);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_BASE_H
