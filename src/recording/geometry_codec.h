// Serialization of hulls, meshes and height fields.
#pragma once

#include <cairn/shape.h>

#include <string>
#include <string_view>

namespace cairn::recording {

// `shape` must be a Hull, Mesh or HeightField; the rounding of a hull is not part of its geometry.
std::string encode_geometry(const Shape& shape);

// Throws Error(invalid_file), or whatever the shape's constructor throws. `what`: the subject in messages.
Shape decode_geometry(std::string_view bytes, const std::string& what);

// The data that copies of a shape share; null for shapes without shared data.
std::shared_ptr<const void> shared_geometry(const Shape& shape);

} // namespace cairn::recording
