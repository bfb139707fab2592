#include "scene/buffer_writer.h"

#include "scene/json_number.h"

#include <algorithm>
#include <cstring>

namespace cairn::scene {

namespace {

using Json = nlohmann::ordered_json;

// glTF 2.0, tables "accessor.componentType" and "bufferView.target".
constexpr int float_type = 5126, index_type = 5125;
constexpr int no_target = 0, vertex_target = 34962, index_target = 34963;

} // namespace

void BufferWriter::append(std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes_ += static_cast<char>(word >> (8 * i) & 0xFFu);
}

void BufferWriter::append(float value) {
    std::uint32_t word = 0;
    std::memcpy(&word, &value, sizeof word);
    append(word);
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
    Json accessor{
        {"bufferView", views_.size()}, {"componentType", float_type}, {"count", values.size()}, {"type", "VEC3"}};
    if (with_bounds) accessor["min"] = number_array(low), accessor["max"] = number_array(high);
    return finish(start, target, std::move(accessor));
}

std::size_t BufferWriter::add_quaternions(std::span<const Quat> values) {
    const std::size_t start = bytes_.size();
    for (const Quat& q : values) append(q.x), append(q.y), append(q.z), append(q.w);
    return finish(
        start, no_target,
        {{"bufferView", views_.size()}, {"componentType", float_type}, {"count", values.size()}, {"type", "VEC4"}});
}

std::size_t BufferWriter::add_indices(std::span<const std::uint32_t> values) {
    const std::size_t start = bytes_.size();
    for (const std::uint32_t v : values) append(v);
    return finish(
        start, index_target,
        {{"bufferView", views_.size()}, {"componentType", index_type}, {"count", values.size()}, {"type", "SCALAR"}});
}

std::size_t BufferWriter::add_scalars(std::span<const float> values, bool with_bounds) {
    const std::size_t start = bytes_.size();
    for (const float v : values) append(v);
    Json accessor{
        {"bufferView", views_.size()}, {"componentType", float_type}, {"count", values.size()}, {"type", "SCALAR"}};
    if (with_bounds) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        accessor["min"] = Json::array({shortest(*low)}), accessor["max"] = Json::array({shortest(*high)});
    }
    return finish(start, no_target, std::move(accessor));
}

} // namespace cairn::scene
