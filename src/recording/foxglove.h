// Messages in the schemas of Foxglove (https://docs.foxglove.dev/docs/sdk/schemas), which several programs read, and in
// Cairn's own schemas.
#pragma once

#include "recording/protobuf.h"

#include <cairn/math.h>
#include <cairn/shape.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace cairn::recording {

// Schemas of all messages of the packages foxglove and cairn that are written.
std::string foxglove_schemas();
std::string own_schemas();

ProtoWriter timestamp_message(std::uint64_t nanoseconds);
ProtoWriter transform_message(std::uint64_t nanoseconds, std::string_view parent, std::string_view child,
                              const Position& position, const Quat& rotation);

// Writes the primitives of one scene entity.
class EntityWriter {
  public:
    // `is_locked`: the entity moves with its frame.
    EntityWriter(std::uint64_t nanoseconds, std::string_view frame, std::string_view id, bool is_locked);
    void add_shape(const Shape& shape, const Vec3& position, const Quat& rotation, const Vec3& color);
    void add_arrow(const Position& from, const Vec3& way, const Vec3& color);
    const ProtoWriter& message() const { return entity_; }

  private:
    void add_box(const Transform& pose, const Vec3& size);
    void add_ball(const Transform& pose, float radius);
    void add_cylinder(const Transform& pose, float half_height, float low, float high);
    void add_triangles(const Transform& pose, std::span<const Vec3> points, std::span<const std::uint32_t> indices);

    ProtoWriter entity_, color_;
};

} // namespace cairn::recording
