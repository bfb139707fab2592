// Calls of the C API with exactly one fault each; wrong_calls.c is generated from the table.
#pragma once

#include <cairn/cairn.h>
#ifdef __cplusplus
#include <cairn/c/cairn.h>
extern "C" {
#endif

// A world, and values that are valid in every call.
struct wrong_context {
    cairn_world* world;
    cairn_body_id body, stale_body;
    cairn_shape_id shape, stale_shape;
    cairn_joint_id joint, stale_joint;
    cairn_force_field_id force_field, stale_force_field;
    cairn_vec3 vec3;
    cairn_position position;
    cairn_quat quat;
    cairn_transform transform;
    cairn_bounds bounds;
    cairn_joint_def joint_def; // between two bodies of the world
};

struct wrong_call {
    const char* function;
    const char* what; // the argument that is wrong
    cairn_result (*call)(const struct wrong_context* context, int wrong);
    int wrong; // -1: no fault
    cairn_result expected;
};

extern const struct wrong_call wrong_calls[];
extern const int wrong_call_count;

#ifdef __cplusplus
}
#endif
