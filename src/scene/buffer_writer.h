// Writes the arrays of numbers of a glTF file: one buffer, and the accessors that divide it.
#pragma once

#include "scene/scene.h"

#include <cairn/math.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cairn::scene {

class BufferWriter {
  public:
    // Each function returns the index of the new accessor.
    std::size_t add_vertices(std::span<const Vec3> values, bool with_bounds); // bounds are required for POSITION
    std::size_t add_vectors(std::span<const Vec3> values);                    // any other vectors, without bounds
    std::size_t add_quaternions(std::span<const Quat> values);
    std::size_t add_indices(std::span<const std::uint32_t> values);
    std::size_t add_numbers(std::span<const std::uint16_t> values);
    std::size_t add_scalars(std::span<const float> values, bool with_bounds);
    std::size_t add_coordinates(std::span<const glm::vec2> values);
    std::size_t add_bone_numbers(std::span<const BoneWeights> weights);
    std::size_t add_bone_shares(std::span<const BoneWeights> weights);
    std::size_t add_bindings(std::span<const Bone> bones); // inverse bind matrices
    std::size_t add_file(const std::string& file);         // returns the index of the buffer view

    bool empty() const { return accessors_.empty(); }
    const std::vector<std::string>& accessors() const { return accessors_; } // each accessor is a line of JSON
    const std::vector<std::string>& views() const { return views_; }
    const std::string& bytes() const { return bytes_; }

  private:
    std::size_t add_vectors(std::span<const Vec3> values, int target, bool with_bounds);
    void append(std::uint16_t word);
    void append(std::uint32_t word);
    void append(float value);
    nlohmann::ordered_json accessor(int component_type, std::size_t count, const char* type) const;
    std::size_t finish(std::size_t start, int target, nlohmann::ordered_json accessor);

    std::string bytes_;
    std::vector<std::string> accessors_, views_;
};

} // namespace cairn::scene
