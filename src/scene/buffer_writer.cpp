#include "scene/buffer_writer.h"

#include "scene/json_number.h"

#include <algorithm>
#include <cstring>

namespace cairn::scene {

namespace {

using Json = nlohmann::ordered_json;

// glTF 2.0, tables "accessor.componentType" and "bufferView.target".
constexpr int float_type = 5126, index_type = 5125, short_type = 5123;
constexpr int no_target = 0, vertex_target = 34962, index_target = 34963;

} // namespace

void BufferWriter::append(std::uint16_t word) {
    for (int i = 0; i < 2; ++i) bytes_ += static_cast<char>(word >> (8 * i) & 0xFFu);
}

void BufferWriter::append(std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes_ += static_cast<char>(word >> (8 * i) & 0xFFu);
}

void BufferWriter::append(float value) {
    std::uint32_t word = 0;
    std::memcpy(&word, &value, sizeof word);
    append(word);
}

// An accessor of the buffer view that is written next.
Json BufferWriter::accessor(int component_type, std::size_t count, const char* type) const {
    return {{"bufferView", views_.size()}, {"componentType", component_type}, {"count", count}, {"type", type}};
}

std::size_t BufferWriter::finish(std::size_t start, int target, Json accessor) {
    Json view{{"buffer", 0}, {"byteOffset", start}, {"byteLength", bytes_.size() - start}};
    if (target != no_target) view["target"] = target;
    views_.push_back(view.dump());
    accessors_.push_back(accessor.dump());
    return accessors_.size() - 1;
}

std::size_t BufferWriter::add_vertices(std::span<const Vec3> values, bool with_bounds) {
    return add_vectors(values, vertex_target, with_bounds);
}

std::size_t BufferWriter::add_vectors(std::span<const Vec3> values) { return add_vectors(values, no_target, false); }

std::size_t BufferWriter::add_vectors(std::span<const Vec3> values, int target, bool with_bounds) {
    const std::size_t start = bytes_.size();
    Vec3 low = values[0], high = values[0];
    for (const Vec3& v : values) {
        for (int i = 0; i < 3; ++i) {
            append(v[i]);
            low[i] = std::min(low[i], v[i]);
            high[i] = std::max(high[i], v[i]);
        }
    }
    Json entry = accessor(float_type, values.size(), "VEC3");
    if (with_bounds) entry["min"] = number_array(low), entry["max"] = number_array(high);
    return finish(start, target, std::move(entry));
}

std::size_t BufferWriter::add_quaternions(std::span<const Quat> values) {
    const std::size_t start = bytes_.size();
    for (const Quat& q : values) append(q.x), append(q.y), append(q.z), append(q.w);
    return finish(start, no_target, accessor(float_type, values.size(), "VEC4"));
}

std::size_t BufferWriter::add_indices(std::span<const std::uint32_t> values) {
    const std::size_t start = bytes_.size();
    for (const std::uint32_t v : values) append(v);
    return finish(start, index_target, accessor(index_type, values.size(), "SCALAR"));
}

std::size_t BufferWriter::add_numbers(std::span<const std::uint16_t> values) {
    const std::size_t start = bytes_.size();
    for (const std::uint16_t v : values) append(v);
    const std::size_t index = finish(start, no_target, accessor(short_type, values.size(), "SCALAR"));
    if (values.size() % 2 != 0) append(std::uint16_t{0}); // the next view must begin at a multiple of four bytes
    return index;
}

std::size_t BufferWriter::add_scalars(std::span<const float> values, bool with_bounds) {
    const std::size_t start = bytes_.size();
    for (const float v : values) append(v);
    Json entry = accessor(float_type, values.size(), "SCALAR");
    if (with_bounds) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        entry["min"] = Json::array({shortest(*low)}), entry["max"] = Json::array({shortest(*high)});
    }
    return finish(start, no_target, std::move(entry));
}

std::size_t BufferWriter::add_coordinates(std::span<const glm::vec2> values) {
    const std::size_t start = bytes_.size();
    for (const glm::vec2& v : values) append(v.x), append(v.y);
    return finish(start, vertex_target, accessor(float_type, values.size(), "VEC2"));
}

std::size_t BufferWriter::add_bone_numbers(std::span<const BoneWeights> weights) {
    const std::size_t start = bytes_.size();
    for (const BoneWeights& of_vertex : weights)
        for (const std::uint16_t bone : of_vertex.bones) append(bone);
    return finish(start, vertex_target, accessor(short_type, weights.size(), "VEC4"));
}

std::size_t BufferWriter::add_bone_shares(std::span<const BoneWeights> weights) {
    const std::size_t start = bytes_.size();
    for (const BoneWeights& of_vertex : weights)
        for (const float share : of_vertex.shares) append(share);
    return finish(start, vertex_target, accessor(float_type, weights.size(), "VEC4"));
}

std::size_t BufferWriter::add_bindings(std::span<const Bone> bones) {
    const std::size_t start = bytes_.size();
    for (const Bone& bone : bones) {
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) append(float(bone.linear[column][row]));
            append(0.0f);
        }
        for (int row = 0; row < 3; ++row) append(float(bone.translation[row]));
        append(1.0f);
    }
    return finish(start, no_target, accessor(float_type, bones.size(), "MAT4"));
}

std::size_t BufferWriter::add_file(const std::string& file) {
    views_.push_back(Json{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", file.size()}}.dump());
    bytes_ += file;
    bytes_.append((4 - bytes_.size() % 4) % 4, '\0'); // numeric views that follow must begin at multiples of four bytes
    return views_.size() - 1;
}

} // namespace cairn::scene
