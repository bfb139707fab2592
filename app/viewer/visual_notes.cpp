#include "viewer/visual_notes.h"

#include <cairn/error.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"; // RFC 4648
constexpr std::size_t words_of_vertex = 6;

// Encodes words as base64: four digits for three bytes; the end is padded with zeros.
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

// Number of vertices, their positions and normals, indices.
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

// Texture coordinates of the vertices.
std::string text_of_coordinates(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> words;
    for (const MeshVertex& vertex : mesh.vertices)
        words.push_back(bits_of(vertex.inset.x)), words.push_back(bits_of(vertex.inset.y));
    return base64(words);
}

bool take_coordinates(const std::string& text, TriangleMesh& mesh) {
    const std::vector<std::uint32_t> words = words_of(text);
    if (words.size() != 2 * mesh.vertices.size()) return false;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const float u = float_of(words[2 * i]), v = float_of(words[2 * i + 1]);
        if (!std::isfinite(u) || !std::isfinite(v)) return false;
        mesh.vertices[i].inset = {u, v, 0.0f};
    }
    return true;
}

// Encodes three words per vertex.
std::string text_of_colors(const std::vector<Vec3>& colors) {
    std::vector<std::uint32_t> words;
    for (const Vec3& color : colors)
        for (int i = 0; i < 3; ++i) words.push_back(bits_of(color[i]));
    return base64(words);
}

// Empty if malformed.
std::vector<Vec3> colors_of(const std::string& text, std::size_t vertices) {
    const std::vector<std::uint32_t> words = words_of(text);
    if (words.size() != 3 * vertices) return {};
    std::vector<Vec3> colors(vertices);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const float part = float_of(words[i]);
        if (!(part >= 0.0f && part <= 1.0f)) return {};
        colors[i / 3][int(i % 3)] = part;
    }
    return colors;
}

constexpr std::size_t words_of_weights = 8;
std::string text_of_weights(const std::vector<BoneWeights>& weights) {
    std::vector<std::uint32_t> words;
    for (const BoneWeights& of_vertex : weights) {
        for (const std::uint16_t bone : of_vertex.bones) words.push_back(bone);
        for (const float share : of_vertex.shares) words.push_back(bits_of(share));
    }
    return base64(words);
}

// Empty if malformed.
std::vector<BoneWeights> weights_of(const std::string& text, std::size_t vertices) {
    const std::vector<std::uint32_t> words = words_of(text);
    if (words.size() != words_of_weights * vertices) return {};
    std::vector<BoneWeights> weights(vertices);
    for (std::size_t i = 0; i < vertices; ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t bone = words[words_of_weights * i + k];
            const float share = float_of(words[words_of_weights * i + 4 + k]);
            if (bone > 0xFFFF || !(share >= 0.0f && share <= 1.0f)) return {};
            weights[i].bones[k] = std::uint16_t(bone), weights[i].shares[k] = share;
        }
    return weights;
}

// Format of textures: the style, the size of the file in bytes, and its content.
constexpr std::uint32_t smooth_bit = 1, data_bit = 2;
constexpr std::size_t words_before_file = 5;
std::string text_of(const TexturePicture& texture) {
    const TextureStyle& style = texture.style;
    const std::string& file = *texture.file;
    std::vector<std::uint32_t> words{std::uint32_t(style.wrap_u), std::uint32_t(style.wrap_v),
                                     (style.is_smooth ? smooth_bit : 0) | (style.is_data ? data_bit : 0),
                                     bits_of(style.alpha_cutoff), std::uint32_t(file.size())};
    words.resize(words_before_file + (file.size() + 3) / 4);
    for (std::size_t i = 0; i < file.size(); ++i)
        words[words_before_file + i / 4] |= std::uint32_t(std::uint8_t(file[i])) << (8 * (i % 4));
    return base64(words);
}

std::shared_ptr<const TexturePicture> texture_of(const std::string& text) {
    const std::vector<std::uint32_t> words = words_of(text);
    constexpr auto last_wrap = std::uint32_t(TextureStyle::Wrap::clamp);
    if (words.size() < words_before_file || words[0] > last_wrap || words[1] > last_wrap) return nullptr;
    if (words[4] > 4 * (words.size() - words_before_file)) return nullptr;
    std::string file(words[4], '\0');
    for (std::size_t i = 0; i < file.size(); ++i)
        file[i] = char(words[words_before_file + i / 4] >> (8 * (i % 4)) & 255);
    const TextureStyle style{TextureStyle::Wrap(words[0]), TextureStyle::Wrap(words[1]), (words[2] & smooth_bit) != 0,
                             float_of(words[3]), (words[2] & data_bit) != 0};
    try {
        return std::make_shared<const TexturePicture>(
            read_texture(std::make_shared<const std::string>(std::move(file)), style));
    } catch (const Error&) {
        return nullptr; // a damaged texture is left out
    }
}

// Reads the meshes of notes, each on first use.
class MeshReader {
  public:
    explicit MeshReader(const Notes& notes) : notes_(notes) {
        if (const auto lines = notes.find("textured"); lines != notes.end()) {
            std::istringstream words(lines->second);
            for (std::string mesh, texture; words >> mesh >> texture;) texture_of_mesh_[mesh] = texture;
        }
    }
    std::shared_ptr<const ShapeMesh> operator()(const std::string& number) {
        const auto [place, is_new] = meshes_.try_emplace(number);
        if (is_new) place->second = read(number);
        return place->second;
    }

  private:
    std::shared_ptr<const ShapeMesh> read(const std::string& number) {
        const auto text = notes_.find("mesh " + number);
        std::optional<TriangleMesh> mesh = text == notes_.end() ? std::nullopt : mesh_of(text->second);
        if (!mesh) return nullptr;
        const auto coordinates = notes_.find("coordinates " + number);
        const auto colors = notes_.find("tints " + number), finish = notes_.find("finish " + number);
        if (colors != notes_.end()) mesh->colors = colors_of(colors->second, mesh->vertices.size());
        const auto weights = notes_.find("weights " + number);
        std::vector<BoneWeights> of_bones;
        if (weights != notes_.end()) of_bones = weights_of(weights->second, mesh->vertices.size());
        const bool is_covered = coordinates != notes_.end() && take_coordinates(coordinates->second, *mesh);
        ShapeMesh made = make_shape_mesh(std::move(*mesh), MeshVisual::visual);
        made.weights = std::move(of_bones);
        if (const auto texture = texture_of_mesh_.find(number); is_covered && texture != texture_of_mesh_.end())
            made.texture = texture_named(texture->second);
        if (finish != notes_.end()) made.finish = finish_of(finish->second, is_covered);
        return std::make_shared<const ShapeMesh>(std::move(made));
    }
    // Null if malformed.
    std::shared_ptr<const Finish> finish_of(const std::string& text, bool is_covered) {
        std::istringstream words(text);
        Finish finish;
        std::string rough, normals, glows;
        Vec3& glow = finish.glow;
        if (!(words >> finish.roughness >> finish.metalness >> finish.normal_scale >> glow.x >> glow.y >> glow.z >>
              finish.glow_strength >> rough >> normals >> glows))
            return nullptr;
        if (is_covered) {
            finish.rough = texture_named(rough), finish.normals = texture_named(normals);
            finish.glows = texture_named(glows);
        }
        return std::make_shared<const Finish>(std::move(finish));
    }
    std::shared_ptr<const TexturePicture> texture_named(const std::string& number) {
        const auto [place, is_new] = textures_.try_emplace(number);
        const auto text = notes_.find("texture " + number);
        if (is_new && text != notes_.end()) place->second = texture_of(text->second);
        return place->second;
    }

    const Notes& notes_;
    std::map<std::string, std::string> texture_of_mesh_;
    std::map<std::string, std::shared_ptr<const ShapeMesh>> meshes_;
    std::map<std::string, std::shared_ptr<const TexturePicture>> textures_;
};

// Writes meshes and textures as notes, each once.
class NoteWriter {
  public:
    Notes notes;
    std::size_t bytes = 0;

    std::size_t number_of(const ShapeMesh& mesh) {
        const auto [place, is_new] = meshes_.emplace(&mesh, meshes_.size());
        if (!is_new) return place->second;
        const std::string number = std::to_string(place->second);
        add("mesh " + number, viewer::text_of(mesh.triangles));
        if (!mesh.weights.empty()) add("weights " + number, text_of_weights(mesh.weights));
        if (!mesh.triangles.colors.empty()) add("tints " + number, text_of_colors(mesh.triangles.colors));
        if (mesh.texture || mesh.finish) add("coordinates " + number, text_of_coordinates(mesh.triangles));
        if (mesh.texture) notes["textured"] += number + ' ' + number_of(mesh.texture) + '\n';
        if (mesh.finish) add("finish " + number, text_of(*mesh.finish));
        return place->second;
    }

  private:
    // The number of a texture, or a dash for none.
    std::string number_of(const std::shared_ptr<const TexturePicture>& texture) {
        if (!texture) return "-";
        const auto [place, is_new] = textures_.emplace(texture.get(), textures_.size());
        if (is_new) add("texture " + std::to_string(place->second), viewer::text_of(*texture));
        return std::to_string(place->second);
    }
    std::string text_of(const Finish& finish) {
        std::ostringstream words;
        words << std::setprecision(std::numeric_limits<float>::max_digits10) << finish.roughness << ' '
              << finish.metalness << ' ' << finish.normal_scale << ' ' << finish.glow.x << ' ' << finish.glow.y << ' '
              << finish.glow.z << ' ' << finish.glow_strength << ' ' << number_of(finish.rough) << ' '
              << number_of(finish.normals) << ' ' << number_of(finish.glows);
        return words.str();
    }
    void add(std::string name, std::string text) {
        bytes += text.size();
        notes.emplace(std::move(name), std::move(text));
    }

    std::map<const ShapeMesh*, std::size_t> meshes_;
    std::map<const TexturePicture*, std::size_t> textures_;
};

// Bodies by slot; the null body has slot -1.
using BodiesBySlot = std::map<std::int64_t, BodyId>;

std::int64_t slot_of(BodyId body) { return body.is_null() ? -1 : std::int64_t(body.index()); }

bool is_there(const Visual& visual, const World& world) {
    const auto valid = [&](BodyId body) { return body.is_null() || world.is_valid(body); };
    return valid(visual.body) &&
           std::all_of(visual.bones.begin(), visual.bones.end(), [&](const Bone& bone) { return valid(bone.body); });
}

// One line per bone: the index of the visual, the slot of the body, and the map from the mesh to its frame.
void write_bones(std::ostringstream& lines, std::size_t visual, const std::vector<Bone>& bones) {
    for (const Bone& bone : bones) {
        lines << visual << ' ' << slot_of(bone.body);
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) lines << ' ' << bone.linear[column][row];
        lines << ' ' << bone.translation.x << ' ' << bone.translation.y << ' ' << bone.translation.z << '\n';
    }
}

// Bones by index of the visual. Visuals with a bone whose body does not exist get no bones.
std::map<std::size_t, std::vector<Bone>> read_bones(const Notes& notes, const BodiesBySlot& bodies) {
    std::map<std::size_t, std::vector<Bone>> bones;
    std::set<std::size_t> broken;
    const auto lines = notes.find("bones");
    std::istringstream words(lines == notes.end() ? std::string() : lines->second);
    std::size_t visual = 0;
    std::int64_t slot = 0;
    while (words >> visual >> slot) {
        Bone bone;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) words >> bone.linear[column][row];
        if (!(words >> bone.translation.x >> bone.translation.y >> bone.translation.z)) break;
        const auto body = bodies.find(slot);
        if (body == bodies.end()) broken.insert(visual);
        if (body != bodies.end()) bone.body = body->second;
        bones[visual].push_back(bone);
    }
    for (const std::size_t number : broken) bones[number].clear();
    return bones;
}

// Whether the mesh's weights refer to these bones, or there are neither weights nor bones.
bool fit(const ShapeMesh& mesh, const std::vector<Bone>& bones) {
    if (mesh.weights.empty() || bones.empty()) return mesh.weights.empty() && bones.empty();
    return std::all_of(mesh.weights.begin(), mesh.weights.end(), [&](const BoneWeights& weights) {
        return *std::max_element(weights.bones.begin(), weights.bones.end()) < bones.size();
    });
}

} // namespace

Notes notes_of(std::span<const Visual> visuals, const World& world, std::size_t max_bytes) {
    NoteWriter writer;
    std::ostringstream lines, bones;
    lines << std::setprecision(std::numeric_limits<double>::max_digits10);
    bones << std::setprecision(std::numeric_limits<double>::max_digits10);
    std::size_t count = 0;
    for (const Visual& visual : visuals) {
        if (!is_there(visual, world)) continue;
        const std::size_t mesh = writer.number_of(*visual.mesh);
        if (writer.bytes > max_bytes) return {};
        const Position& p = visual.local.position;
        const Quat& q = visual.local.rotation;
        lines << mesh << ' ' << slot_of(visual.body) << ' ' << p.x << ' ' << p.y << ' ' << p.z << ' ' << q.w << ' '
              << q.x << ' ' << q.y << ' ' << q.z << ' ' << visual.color.x << ' ' << visual.color.y << ' '
              << visual.color.z << '\n';
        write_bones(bones, count++, visual.bones);
    }
    if (!writer.notes.empty()) writer.notes.emplace("visuals", lines.str());
    if (!bones.str().empty()) writer.notes.emplace("bones", bones.str());
    return std::move(writer.notes);
}

std::vector<Visual> visuals_of(const Notes& notes, const World& world) {
    std::vector<Visual> visuals;
    const auto lines = notes.find("visuals");
    if (lines == notes.end()) return visuals;
    BodiesBySlot bodies{{-1, BodyId()}};
    for (const BodyId body : world.bodies()) bodies.emplace(std::int64_t(body.index()), body);
    std::map<std::size_t, std::vector<Bone>> bones = read_bones(notes, bodies);
    MeshReader meshes(notes);
    std::istringstream words(lines->second);
    std::string number;
    std::int64_t slot = 0;
    Visual visual;
    Position& p = visual.local.position;
    Quat& q = visual.local.rotation;
    Vec3& color = visual.color;
    for (std::size_t count = 0;
         words >> number >> slot >> p.x >> p.y >> p.z >> q.w >> q.x >> q.y >> q.z >> color.x >> color.y >> color.z;
         ++count) {
        const auto body = bodies.find(slot);
        if (body == bodies.end() || !(std::fabs(glm::length(q) - 1.0f) < 1e-3f)) continue;
        visual.mesh = meshes(number);
        visual.bones = bones[count];
        if (!visual.mesh || !fit(*visual.mesh, visual.bones)) continue;
        visual.body = body->second;
        visuals.push_back(visual);
        visuals.back().color = glm::clamp(color, 0.0f, 1.0f);
    }
    return visuals;
}

} // namespace cairn::viewer
