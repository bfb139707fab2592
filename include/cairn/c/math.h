// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_MATH_H
#define CAIRN_C_MATH_H

#include <cairn/c/base.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cairn_vec2 {
    float x, y;
} cairn_vec2;

/// Directions, velocities, extents, forces: float, SI units.
typedef struct cairn_vec3 {
    float x, y, z;
} cairn_vec3;

typedef struct cairn_dvec3 {
    double x, y, z;
} cairn_dvec3;

/// World position in meters: double, so that large worlds keep their precision.
typedef cairn_dvec3 cairn_position;

/// Rotation as a unit quaternion; the identity is 0, 0, 0, 1.
typedef struct cairn_quat {
    float x, y, z, w;
} cairn_quat;

/// A 3x3 matrix, stored by columns (inertia tensors, in kg m^2).
typedef struct cairn_mat3 {
    float columns[3][3];
} cairn_mat3;

/// A pose: rotate by `rotation`, then translate by `position` (meters).
typedef struct cairn_transform {
    cairn_position position; ///< Meters.
    cairn_quat rotation; ///< A unit quaternion.
} cairn_transform;
CAIRN_C_API cairn_transform cairn_default_transform(void);

/// An axis-aligned box in world space, in meters. Empty when any `min` exceeds its `max`.
typedef struct cairn_bounds {
    cairn_position min; ///< Least coordinates, meters.
    cairn_position max; ///< Greatest coordinates, meters.
} cairn_bounds;
CAIRN_C_API cairn_bounds cairn_default_bounds(void);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_MATH_H
