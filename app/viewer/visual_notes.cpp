#include "viewer/visual_notes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"; // RFC 4648
constexpr std::size_t words_of_vertex = 6;

// Three bytes as four digits; zeros behind the last word.
std::string base64(const std::vector<std::uint32_t>& words) {
    std::string text;
    text.reserve(words.size() * 16 / 3 + 4);
    std::uint32_t bits = 0;
    int count = 0;
    const auto add = [&](std::uint32_t byte) {
        bits = bits << 8 | byte;
        if (++count < 3) return;
        for (int shift = 18; shift >= 0; shift -= 6) text += digits[bits >> shift & 63];
        bits = 0, count = 0;
    };
    for (const std::uint32_t word : words)
        for (int shift = 0; shift < 32; shift += 8) add(word >> shift & 255);
    while (count > 0) add(0);
    return text;
}

std::vector<std::uint32_t> words_of(const std::string& text) {
    std::array<std::uint8_t, 256> values{};
    values.fill(64);
    for (std::size_t i = 0; i < digits.size(); ++i) values[std::uint8_t(digits[i])] = std::uint8_t(i);
    std::vector<std::uint32_t> words;
    std::uint64_t bits = 0;
    int count = 0, bytes = 0;
    std::uint32_t word = 0;
    for (const char digit : text) {
        const std::uint8_t value = values[std::uint8_t(digit)];
        if (value > 63) return {};
        bits = bits << 6 | value;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        word |= std::uint32_t(bits >> count & 255) << (8 * bytes);
        if (++bytes < 4) continue;
        words.push_back(std::exchange(word, 0u));
        bytes = 0;
    }
    return words;
}

std::uint32_t bits_of(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, 4);
    return bits;
}
float float_of(std::uint32_t bits) {
    float value;
    std::memcpy(&value, &bits, 4);
    return value;
}

// How many vertices, their places and normals, indices.
std::string text_of(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> words{std::uint32_t(mesh.vertices.size())};
    words.reserve(1 + words_of_vertex * mesh.vertices.size() + mesh.indices.size());
    for (const MeshVertex& vertex : mesh.vertices)
        for (const Vec3& v : {vertex.corner, vertex.normal})
            for (int i = 0; i < 3; ++i) words.push_back(bits_of(v[i]));
    words.insert(words.end(), mesh.indices.begin(), mesh.indices.end());
    return base64(words);
}

std::optional<TriangleMesh> mesh_of(const std::string& text) {
    const std::vector<std::uint32_t> words = words_of(text);
    if (words.empty() || words[0] > (words.size() - 1) / words_of_vertex) return std::nullopt;
    TriangleMesh mesh;
    const std::uint32_t* at = words.data() + 1;
    const auto next = [&] {
        Vec3 v(0.0f);
        for (int i = 0; i < 3; ++i) v[i] = float_of(*at++);
        return v;
    };
    constexpr float largest = 1e9f;
    for (std::uint32_t i = 0; i < words[0]; ++i) {
        const Vec3 corner = next(), normal = next();
        if (!(glm::length(corner) < largest) || !(std::fabs(glm::length(normal) - 1.0f) < 1e-3f)) return std::nullopt;
        mesh.vertices.push_back({corner, Vec3(0.0f), normal});
    }
    for (const std::uint32_t* const end = words.data() + words.size(); at != end; ++at) {
        if (*at >= mesh.vertices.size()) return std::nullopt;
        mesh.indices.push_back(*at);
    }
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0) return std::nullopt;
    return mesh;
}

} // namespace

Notes notes_of(std::span<const Visual> visuals, const World& world, std::size_t max_bytes) {
    Notes notes;
    std::map<const ShapeMesh*, std::size_t> numbers;
    std::ostringstream lines;
    lines << std::setprecision(std::numeric_limits<double>::max_digits10);
    std::size_t bytes = 0;
    for (const Visual& visual : visuals) {
        const bool is_scenery = visual.body.is_null();
        if (!is_scenery && !world.is_valid(visual.body)) continue;
        const auto [place, is_new] = numbers.emplace(visual.mesh.get(), numbers.size());
        if (is_new) {
            std::string text = text_of(visual.mesh->triangles);
            bytes += text.size();
            if (bytes > max_bytes) return {};
            notes.emplace("mesh " + std::to_string(place->second), std::move(text));
        }
        const Position& p = visual.local.position;
        const Quat& q = visual.local.rotation;
        lines << place->second << ' ' << (is_scenery ? -1 : std::int64_t(visual.body.index())) << ' ' << p.x << ' '
              << p.y << ' ' << p.z << ' ' << q.w << ' ' << q.x << ' ' << q.y << ' ' << q.z << ' ' << visual.color.x
              << ' ' << visual.color.y << ' ' << visual.color.z << '\n';
    }
    if (!notes.empty()) notes.emplace("visuals", lines.str());
    return notes;
}

std::vector<Visual> visuals_of(const Notes& notes, const World& world) {
    std::vector<Visual> visuals;
    const auto lines = notes.find("visuals");
    if (lines == notes.end()) return visuals;
    std::map<std::int64_t, BodyId> bodies{{-1, BodyId()}};
    for (const BodyId body : world.bodies()) bodies.emplace(std::int64_t(body.index()), body);
    std::map<std::string, std::shared_ptr<const ShapeMesh>> meshes;
    std::istringstream words(lines->second);
    std::string number;
    std::int64_t slot = 0;
    Visual visual;
    Position& p = visual.local.position;
    Quat& q = visual.local.rotation;
    Vec3& color = visual.color;
    while (words >> number >> slot >> p.x >> p.y >> p.z >> q.w >> q.x >> q.y >> q.z >> color.x >> color.y >> color.z) {
        const auto body = bodies.find(slot);
        if (body == bodies.end() || !(std::fabs(glm::length(q) - 1.0f) < 1e-3f)) continue;
        const auto [place, is_new] = meshes.try_emplace(number);
        if (const auto text = notes.find("mesh " + number); is_new && text != notes.end())
            if (std::optional<TriangleMesh> mesh = mesh_of(text->second))
                place->second = std::make_shared<const ShapeMesh>(make_shape_mesh(std::move(*mesh), MeshLook::visual));
        if (!place->second) continue;
        visual.body = body->second;
        visual.mesh = place->second;
        visuals.push_back(visual);
        visuals.back().color = glm::clamp(color, 0.0f, 1.0f);
    }
    return visuals;
}

} // namespace cairn::viewer
