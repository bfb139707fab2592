#include "scene/mesh_files.h"

#include "scene/decimal.h"
#include "scene/decomposition.h"
#include "scene/gltf_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace cairn::scene {

namespace {

constexpr std::size_t max_numbers = std::size_t{1} << 28; // vertices, or indices
constexpr std::size_t max_materials = 10'000;

// Splits a text into lines, and lines into words.
class Lines {
  public:
    Lines(std::span<const std::byte> bytes, const std::string& name)
        : rest_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), name_(name) {
        if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);
    }

    bool next() {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++number_;
        return true;
    }
    // Returns the next word of the line; empty at its end.
    std::string_view word() {
        const std::size_t start = line_.find_first_not_of(" \t\r\f\v");
        if (start == std::string_view::npos) return line_ = {};
        line_.remove_prefix(start);
        const std::string_view found = line_.substr(0, line_.find_first_of(" \t\r\f\v"));
        line_.remove_prefix(found.size());
        return found;
    }
    // Returns the rest of the line, without spaces around it.
    std::string_view rest() {
        const std::size_t start = line_.find_first_not_of(" \t\r\f\v");
        if (start == std::string_view::npos) return {};
        return line_.substr(start, line_.find_last_not_of(" \t\r\f\v") + 1 - start);
    }
    float number() {
        const std::string_view text = word();
        const std::optional<double> value = parse_decimal(text);
        if (!value || !(std::fabs(*value) <= static_cast<double>(std::numeric_limits<float>::max()))) {
            fail("must have a number that fits a float", text);
        }
        return static_cast<float>(*value);
    }
    [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
        std::string shown;
        for (const char c : found.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
        throw Error(ErrorCode::invalid_file, name_ + ":" + std::to_string(number_), "\"" + shown + "\"", expected);
    }

  private:
    std::string_view rest_, line_;
    const std::string& name_;
    std::size_t number_ = 0;
};

bool is_index(std::string_view text) {
    const std::string_view digits = text.substr(!text.empty() && text[0] == '-' ? 1 : 0);
    return !digits.empty() && digits.size() <= 10 && digits.find_first_not_of("0123456789") == std::string_view::npos;
}

// Converts one index of a face, counted from 1, or backwards from -1, to an index from 0. Returns nothing unless it is
// below `count`.
std::optional<std::uint32_t> read_index(std::string_view index, std::size_t count) {
    if (!is_index(index)) return std::nullopt;
    const bool is_negative = index[0] == '-';
    const std::string_view digits = index.substr(is_negative ? 1 : 0);
    std::uint64_t value = 0;
    for (const char c : digits) value = value * 10 + static_cast<std::uint64_t>(c - '0');
    if (value == 0 || value > count) return std::nullopt;
    return static_cast<std::uint32_t>(is_negative ? count - value : value - 1);
}

// A vertex of a face: "7", "7/1", "7//3" or "-1/2/3".
struct ObjCorner {
    std::uint32_t vertex = 0, coordinate = MeshFile::nothing, normal = MeshFile::nothing;
};

class ObjReader {
  public:
    ObjReader(std::span<const std::byte> bytes, const std::string& name) : lines_(bytes, name) {}

    MeshFile read() {
        mesh_.materials.emplace_back();
        while (lines_.next()) read_line(lines_.word());
        if (mesh_.coordinates.empty()) mesh_.coordinate_of.clear();
        if (mesh_.normals.empty()) mesh_.normal_of.clear();
        return std::move(mesh_);
    }

  private:
    void read_line(std::string_view word) {
        if (word == "v") {
            mesh_.vertices.push_back(vector());
            if (mesh_.vertices.size() > max_numbers) lines_.fail("must not have more vertices", word);
        } else if (word == "vt") {
            const float u = number_or_nothing(), v = number_or_nothing();
            mesh_.coordinates.emplace_back(u, 1.0f - v); // OBJ counts v upward, Surface downward
            if (mesh_.coordinates.size() > max_numbers) lines_.fail("must not have more coordinates", word);
        } else if (word == "vn") {
            const float x = number_or_nothing(), y = number_or_nothing();
            mesh_.normals.emplace_back(x, y, number_or_nothing());
            if (mesh_.normals.size() > max_numbers) lines_.fail("must not have more normals", word);
        } else if (word == "f") {
            read_face(word);
        } else if (word == "usemtl") {
            const std::string name(lines_.rest());
            const auto found = std::find(mesh_.materials.begin(), mesh_.materials.end(), name);
            material_ = static_cast<std::uint32_t>(found - mesh_.materials.begin());
            if (found == mesh_.materials.end()) mesh_.materials.push_back(name);
            if (mesh_.materials.size() > max_materials) lines_.fail("must not have more materials", word);
        } else if (word == "mtllib") {
            mesh_.libraries.emplace_back(lines_.rest());
            if (mesh_.libraries.size() > max_materials) lines_.fail("must not have more libraries", word);
        }
    }
    Vec3 vector() {
        Vec3 result;
        for (int i = 0; i < 3; ++i) result[i] = lines_.number();
        return result;
    }
    // Malformed data for visuals is no reason to refuse a file: returns 0 where there is no number.
    float number_or_nothing() {
        const std::optional<double> value = parse_decimal(lines_.word());
        constexpr double most = 1e9;
        return value && std::fabs(*value) <= most ? static_cast<float>(*value) : 0.0f;
    }
    ObjCorner corner(std::string_view text) const {
        auto next = [rest = text]() mutable {
            const std::size_t end = rest.find('/');
            const std::string_view found = rest.substr(0, end);
            rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
            return found;
        };
        ObjCorner result;
        const std::string_view first = next();
        const std::optional<std::uint32_t> vertex = read_index(first, mesh_.vertices.size());
        if (!is_index(first)) lines_.fail("must have the index of a vertex", text);
        if (!vertex)
            lines_.fail("must have the index of one of the " + std::to_string(mesh_.vertices.size()) +
                            " vertices so far",
                        text);
        result.vertex = *vertex;
        result.coordinate = read_index(next(), mesh_.coordinates.size()).value_or(MeshFile::nothing);
        result.normal = read_index(next(), mesh_.normals.size()).value_or(MeshFile::nothing);
        return result;
    }
    void read_face(std::string_view word) {
        std::array<ObjCorner, 2> ends{}; // the first and the previous vertex of the face
        std::size_t count = 0;
        for (std::string_view text = lines_.word(); !text.empty(); text = lines_.word()) {
            const ObjCorner now = corner(text);
            if (count == 0) ends[0] = now;
            if (count >= 2) {
                for (const ObjCorner& of_triangle : {ends[0], ends[1], now}) {
                    mesh_.indices.push_back(of_triangle.vertex);
                    mesh_.coordinate_of.push_back(of_triangle.coordinate);
                    mesh_.normal_of.push_back(of_triangle.normal);
                }
                mesh_.material_of.push_back(material_);
            }
            ends[1] = now;
            ++count;
        }
        if (count < 3) lines_.fail("must have at least three corners in a face", word);
        if (mesh_.indices.size() > max_numbers) lines_.fail("must not have more faces", word);
    }

    Lines lines_;
    MeshFile mesh_;
    std::uint32_t material_ = 0;
};

void require_triangles(const MeshFile& mesh, const std::string& name) {
    if (mesh.indices.empty()) throw Error(ErrorCode::invalid_file, name, {}, "must have at least one triangle");
}

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
    return word;
}

// Binary STL: 80 arbitrary bytes, the number of triangles, and 50 bytes per triangle: a normal, three vertices, two
// attribute bytes.
constexpr std::size_t stl_header = 84, stl_triangle = 50;

MeshFile read_binary_stl(std::span<const std::byte> bytes, const std::string& name) {
    const std::size_t count = word_at(bytes, 80);
    if (count > (bytes.size() - stl_header) / stl_triangle) {
        throw Error(ErrorCode::invalid_file, name, std::to_string(bytes.size()) + " bytes",
                    "must have 84 bytes and 50 for each of its " + std::to_string(count) + " triangles");
    }
    MeshFile mesh;
    mesh.vertices.reserve(count * 3);
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t at = stl_header + stl_triangle * t + 12 * (corner + 1);
            Vec3 vertex;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t bits = word_at(bytes, at + 4 * i);
                float value = 0.0f;
                std::memcpy(&value, &bits, sizeof value);
                if (!std::isfinite(value)) {
                    throw Error(ErrorCode::invalid_file, name, {},
                                "must have finite numbers, and triangle " + std::to_string(t) + " does not");
                }
                vertex[static_cast<int>(i)] = value;
            }
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(vertex);
        }
    }
    return mesh;
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return result;
}

MeshFile read_ascii_stl(std::span<const std::byte> bytes, const std::string& name) {
    MeshFile mesh;
    Lines lines(bytes, name);
    int corners = -1; // vertices of the open loop so far; -1: no loop is open
    while (lines.next()) {
        const std::string_view first = lines.word();
        const std::string word = lower_case(first);
        if (word == "vertex") {
            if (corners < 0) lines.fail("must have vertices only between \"outer loop\" and \"endloop\"", first);
            if (++corners > 3) lines.fail("must have three vertices in a loop", first);
            Vec3 vertex;
            for (int i = 0; i < 3; ++i) vertex[i] = lines.number();
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(vertex);
        } else if (word == "outer") {
            if (corners >= 0) lines.fail("must close a loop before it opens the next", first);
            corners = 0;
        } else if (word == "endloop") {
            if (corners != 3) lines.fail("must have three vertices in a loop", first);
            corners = -1;
        } else if (!word.empty() && word != "facet" && word != "endfacet" && word != "solid" && word != "endsolid") {
            lines.fail("must be a line of an STL file", first);
        }
    }
    if (corners >= 0) lines.fail("must close its last loop", "");
    return mesh;
}

} // namespace

MeshFile read_obj(std::span<const std::byte> bytes, const std::string& name) {
    MeshFile mesh = ObjReader(bytes, name).read();
    require_triangles(mesh, name);
    return mesh;
}

Surface visual_surface(const MeshFile& mesh, const glm::dvec3& scale, std::optional<std::uint32_t> material) {
    const bool mirrors = scale.x * scale.y * scale.z < 0.0;
    const auto has_all = [](const std::vector<std::uint32_t>& list) {
        return !list.empty() && std::find(list.begin(), list.end(), MeshFile::nothing) == list.end();
    };
    const bool has_normals = has_all(mesh.normal_of), has_coordinates = !mesh.coordinate_of.empty();
    Surface made;
    struct Split {
        std::uint32_t coordinate, normal, next; // `next`: the next vertex at the same position
    };
    std::vector<std::uint32_t> first(mesh.vertices.size(), MeshFile::nothing); // by position: its last vertex
    std::vector<Split> splits;                                                 // by vertex
    const auto vertex_of = [&](std::size_t corner) {
        const std::uint32_t place = mesh.indices[corner];
        const std::uint32_t coordinate = has_coordinates ? mesh.coordinate_of[corner] : MeshFile::nothing,
                            normal = has_normals ? mesh.normal_of[corner] : MeshFile::nothing;
        for (std::uint32_t v = first[place]; v != MeshFile::nothing; v = splits[v].next)
            if (splits[v].coordinate == coordinate && splits[v].normal == normal) return v;
        splits.push_back({coordinate, normal, first[place]});
        made.vertices.push_back(Vec3(glm::dvec3(mesh.vertices[place]) * scale));
        if (has_coordinates)
            made.coordinates.push_back(coordinate == MeshFile::nothing ? glm::vec2(0.0f)
                                                                       : mesh.coordinates[coordinate]);
        if (has_normals) {
            const glm::dvec3 turned = glm::dvec3(mesh.normals[normal]) / scale;
            const double length = std::sqrt(glm::dot(turned, turned));
            made.normals.push_back(length > 0.0 ? Vec3(turned / length) : Vec3(0.0f, 1.0f, 0.0f));
        }
        return first[place] = static_cast<std::uint32_t>(splits.size() - 1);
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        if (material && mesh.material_of[i / 3] != *material) continue;
        const std::uint32_t a = vertex_of(i), b = vertex_of(i + 1), c = vertex_of(i + 2);
        made.indices.insert(made.indices.end(), {a, mirrors ? c : b, mirrors ? b : c});
    }
    return made;
}

MeshFile read_stl(std::span<const std::byte> bytes, const std::string& name) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    // Binary files may begin with "solid" too, but then their length identifies them.
    const bool has_header = bytes.size() >= stl_header;
    const bool is_exact = has_header && bytes.size() == stl_header + stl_triangle * std::size_t{word_at(bytes, 80)};
    const bool is_ascii = !is_exact && lower_case(text.substr(0, 5)) == "solid";
    if (!is_ascii && !has_header) {
        throw Error(ErrorCode::invalid_file, name, {},
                    bytes.empty() ? "is empty" : "is neither an ASCII STL file nor a whole binary one");
    }
    const MeshFile mesh = is_ascii ? read_ascii_stl(bytes, name) : read_binary_stl(bytes, name);
    require_triangles(mesh, name);
    return mesh;
}

bool is_mesh_file(const std::filesystem::path& path) {
    const std::string extension = lower_case(path.extension().generic_string());
    return extension == ".obj" || extension == ".stl";
}

MeshFile load_mesh_file(const std::filesystem::path& path) {
    const std::string name = path.filename().generic_string(),
                      extension = lower_case(path.extension().generic_string());
    const std::vector<std::byte> bytes = read_file(path);
    if (extension == ".obj") return read_obj(bytes, name);
    if (extension == ".stl") return read_stl(bytes, name);
    throw Error(ErrorCode::unsupported, name, {}, "must be an .obj or .stl file");
}

Scene scene_of_mesh(const MeshFile& mesh, const MeshImport& options, const std::string& name) {
    if (!(options.scale > 0.0) || !std::isfinite(options.scale)) {
        throw Error(ErrorCode::invalid_value, "MeshImport.scale", std::to_string(options.scale), "must be > 0");
    }
    if (!(options.density > 0.0f) || !std::isfinite(options.density)) {
        throw Error(ErrorCode::invalid_value, "MeshImport.density", std::to_string(options.density), "must be > 0");
    }
    std::vector<Vec3> vertices;
    for (const Vec3& v : mesh.vertices) vertices.push_back(Vec3(glm::dvec3(v) * options.scale));
    Scene scene{World(), {}, {}, {}, {}};
    scene.info.title = name;
    BodyDef body;
    body.name = name;
    body.type = options.as_hull ? BodyType::dynamic : BodyType::static_;
    ShapeDef def;
    def.density = options.density;
    try {
        if (options.as_hull) {
            DecompositionLimits limits;
            if (!options.decompose) limits.max_parts = 1;
            const std::vector<Hull> parts = decompose(vertices, mesh.indices, limits);
            const BodyId made = scene.world.create_body(body);
            for (const Hull& part : parts) scene.world.add_shape(made, part, def);
        } else {
            const Mesh shape(vertices, mesh.indices);
            if (shape.dropped_triangles() > 0) {
                scene.warnings.push_back(name + ": " + std::to_string(shape.dropped_triangles()) +
                                         " triangles without area are left out");
            }
            scene.world.add_shape(scene.world.create_body(body), shape, def);
        }
    } catch (const Error& error) {
        throw Error(ErrorCode::invalid_file, name, {}, error.what());
    }
    return scene;
}

} // namespace cairn::scene
