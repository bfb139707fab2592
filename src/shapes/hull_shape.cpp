// The public class Hull.
#include "shapes/hull.h"

#include <cairn/error.h>
#include <cairn/shape.h>

#include <string>

namespace cairn {

static_assert(sizeof(Vec3) == sizeof(math::Vec3) && alignof(Vec3) == alignof(math::Vec3),
              "points are handed over in place");

// GLM's and the engine's vectors both consist of three floats; spans of one are reinterpreted as the other, without a
// copy.
Hull::Hull(std::span<const Vec3> points)
    : data_(std::make_shared<const HullData>(
          build_hull({reinterpret_cast<const math::Vec3*>(points.data()), points.size()}))) {}

std::span<const Vec3> Hull::vertices() const {
    return {reinterpret_cast<const Vec3*>(data_->vertices.data()), data_->vertices.size()};
}

std::size_t Hull::face_count() const { return data_->faces.size(); }

std::span<const std::uint32_t> Hull::face(std::size_t index) const {
    if (index >= data_->faces.size())
        throw Error(ErrorCode::invalid_value, "Hull face", std::to_string(index),
                    "must be less than the number of faces, " + std::to_string(data_->faces.size()));
    const HullFace& face = data_->faces[index];
    return {data_->loops.data() + face.first, face.count};
}

double Hull::volume() const { return data_->unit_mass.mass; }

} // namespace cairn
