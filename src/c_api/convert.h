// Conversion of vectors, handles and shapes with data between C and C++; the other structs are in generated/convert.h.
#pragma once

#include "c_api/support.h"

#include <cairn/c/cairn.h>
#include <cairn/world.h>

#include <string>

namespace cairn::c_api {

inline glm::vec2 to_cpp(cairn_vec2 v) { return {v.x, v.y}; }
inline Vec3 to_cpp(cairn_vec3 v) { return {v.x, v.y, v.z}; }
inline Position to_cpp(cairn_dvec3 v) { return {v.x, v.y, v.z}; }
inline Quat to_cpp(cairn_quat q) { return Quat(q.w, q.x, q.y, q.z); }
inline cairn_vec2 to_c(const glm::vec2& v) { return {v.x, v.y}; }
inline cairn_vec3 to_c(const Vec3& v) { return {v.x, v.y, v.z}; }
inline cairn_dvec3 to_c(const Position& v) { return {v.x, v.y, v.z}; }
inline cairn_quat to_c(const Quat& q) { return {q.x, q.y, q.z, q.w}; }
inline cairn_mat3 to_c(const Mat3& m) {
    cairn_mat3 c;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) c.columns[column][row] = m[column][row];
    return c;
}

inline BodyId to_cpp(cairn_body_id id) { return {id.bits}; }
inline ShapeId to_cpp(cairn_shape_id id) { return {id.bits}; }
inline JointId to_cpp(cairn_joint_id id) { return {id.bits}; }
inline ForceFieldId to_cpp(cairn_force_field_id id) { return {id.bits}; }
inline cairn_body_id to_c(BodyId id) { return {id.bits}; }
inline cairn_shape_id to_c(ShapeId id) { return {id.bits}; }
inline cairn_joint_id to_c(JointId id) { return {id.bits}; }
inline cairn_force_field_id to_c(ForceFieldId id) { return {id.bits}; }

// The conversions to C create a geometry that the caller must release.
Hull to_cpp(const cairn_hull& c);
Mesh to_cpp(const cairn_mesh& c);
HeightField to_cpp(const cairn_height_field& c);
cairn_hull to_c(const Hull& x);
cairn_mesh to_c(const Mesh& x);
cairn_height_field to_c(const HeightField& x);

inline std::string text_of(const char* text) { return text ? text : std::string(); }

} // namespace cairn::c_api
