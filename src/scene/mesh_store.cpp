#include "scene/mesh_store.h"

#include "scene/decimal.h"
#include "scene/gltf_file.h"
#include "scene/model_meshes.h"
#include "scene/nearby_files.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cairn::scene {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_vertices = std::size_t{1} << 26; // total of all meshes of a model

struct Mtl {
    std::optional<Vec3> color; // Kd
    std::string picture;       // map_Kd; relative to the folder of the material library
    std::string place;         // place of `picture` for messages: part.mtl:3: map_Kd
};

std::string trimmed(const std::string& text) {
    const std::size_t start = text.find_first_not_of(" \t\r");
    return start == std::string::npos ? std::string() : text.substr(start, text.find_last_not_of(" \t\r") + 1 - start);
}

// Returns the path of a file that another file names, relative to its folder `from`; it must lie in `root` or below it.
// Throws Error naming the place.
fs::path find_beside(const std::string& name, const fs::path& from, const fs::path& root, const std::string& place) {
    std::string path = name;
    std::replace(path.begin(), path.end(), '\\', '/');
    const NearbyFile found = nearby_file(path, from, root);
    const std::string shown = "\"" + printable(name, 200) + "\"";
    if (found.verdict == NearbyFile::Verdict::outside)
        throw Error(ErrorCode::io, place, shown, "must name a file in the model's folder or below it");
    if (found.verdict != NearbyFile::Verdict::found) throw Error(ErrorCode::io, place, shown, "there is no such file");
    return found.path;
}

// Reads a material library (Wavefront MTL), of which only the diffuse color and its texture are used.
class MtlReader {
  public:
    MtlReader(std::map<std::string, Mtl>& materials, std::vector<std::string>& warnings)
        : materials_(materials), warnings_(warnings) {}

    void read(const fs::path& file) {
        const std::vector<std::byte> bytes = read_file(file);
        std::istringstream lines(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        const std::string name = file.filename().generic_string();
        Mtl* current = nullptr;
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number) {
            const std::string text = trimmed(line), word = text.substr(0, text.find_first_of(" \t"));
            const std::string rest = trimmed(text.substr(word.size()));
            const std::string place = name + ":" + std::to_string(number) + ": " + word;
            if (word == "newmtl") current = &materials_[rest];
            if (current == nullptr) continue;
            if (word == "Kd") current->color = color(rest, place);
            if (word == "map_Kd") {
                // Options precede the name, which then must be one word.
                const std::size_t last = rest.find_last_of(" \t");
                current->picture = rest[0] == '-' && last != std::string::npos ? rest.substr(last + 1) : rest;
                current->place = place;
            }
        }
    }

  private:
    std::optional<Vec3> color(const std::string& rest, const std::string& place) {
        std::istringstream words(rest);
        Vec3 result(0.0f);
        std::string word;
        for (int i = 0; i < 3; ++i) {
            words >> word;
            const std::optional<double> part = parse_decimal(word);
            if (!part || !(*part >= 0.0)) {
                warnings_.push_back(place + ": must be three numbers >= 0, got \"" + printable(rest) +
                                    "\" (the color is left out)");
                return std::nullopt;
            }
            result[i] = static_cast<float>(std::min(*part, 1.0));
        }
        return result;
    }

    std::map<std::string, Mtl>& materials_;
    std::vector<std::string>& warnings_;
};

} // namespace

MeshStore::Key MeshStore::key(const NamedFile& file, const glm::dvec3& scale) {
    return {file.path.string(), scale.x, scale.y, scale.z};
}

const MeshFile& MeshStore::read(const NamedFile& file) {
    const auto known = files_.find(file.path);
    if (known != files_.end()) return known->second;
    const std::string shown = "\"" + file.shown + "\"";
    if (!is_mesh_file(file.path))
        throw Error(ErrorCode::unsupported, file.place, shown, "must be an .stl or .obj file");
    MeshFile mesh = load_mesh_file(file.path);
    vertices_ += mesh.vertices.size();
    if (vertices_ > max_vertices) {
        throw Error(ErrorCode::invalid_file, file.place, shown,
                    "must not raise the number of vertices of all meshes above " + std::to_string(max_vertices));
    }
    return files_.emplace(file.path, std::move(mesh)).first->second;
}

std::shared_ptr<const Surface> MeshStore::surface(const NamedFile& file, const glm::dvec3& scale) {
    const MeshFile& mesh = read(file);
    std::shared_ptr<const Surface>& found = scaled_[key(file, scale)].surface;
    if (!found) found = std::make_shared<const Surface>(scaled_surface(mesh.vertices, mesh.indices, scale));
    return found;
}

std::shared_ptr<const Surface> MeshStore::look(const NamedFile& file, const glm::dvec3& scale) {
    const MeshFile& mesh = read(file);
    if (mesh.coordinates.empty() && mesh.normals.empty()) return surface(file, scale);
    std::shared_ptr<const Surface>& found = scaled_[key(file, scale)].look;
    if (!found) found = std::make_shared<const Surface>(visual_surface(mesh, scale));
    return found;
}

const std::vector<MeshVisual>& MeshStore::looks(const NamedFile& file, const glm::dvec3& scale,
                                                std::vector<std::string>& warnings) {
    const MeshFile& mesh = read(file);
    std::vector<MeshVisual>& found = scaled_[key(file, scale)].looks;
    if (!found.empty()) return found;
    std::map<std::string, Mtl> materials;
    const fs::path folder = file.path.parent_path();
    const auto try_to = [&](const auto& act, const char* otherwise) {
        try {
            act();
        } catch (const Error& error) { // visuals do not affect the simulation
            warnings.push_back(std::string(error.what()) + otherwise);
        }
    };
    for (const std::string& library : mesh.libraries)
        try_to(
            [&] {
                const std::string place = file.path.filename().generic_string() + ": mtllib";
                MtlReader(materials, warnings).read(find_beside(library, folder, file.root, place));
            },
            " (its materials are left out)");
    if (materials.empty()) {
        found.push_back({look(file, scale), std::nullopt, nullptr});
        return found;
    }
    for (std::uint32_t i = 0; i < mesh.materials.size(); ++i) {
        Surface part = visual_surface(mesh, scale, i);
        if (part.indices.empty()) continue;
        const Mtl& material = materials[mesh.materials[i]];
        MeshVisual made{nullptr, material.color, nullptr};
        if (!material.picture.empty() && !part.coordinates.empty())
            try_to(
                [&] {
                    const fs::path path = find_beside(material.picture, folder, file.root, material.place);
                    Texture texture;
                    texture.file = pictures_.read(path, material.place, printable(material.picture, 200));
                    made.texture = std::make_shared<const Texture>(std::move(texture));
                },
                " (the texture is left out)");
        // A black Kd is meant for rendering without the texture.
        if (made.texture && made.color == Vec3(0.0f)) made.color.reset();
        made.surface = std::make_shared<const Surface>(std::move(part));
        found.push_back(std::move(made));
    }
    return found;
}

void add_mesh_looks(const fs::path& file, double scale, Scene& scene) {
    const fs::path folder = folder_on_disk(file.parent_path());
    MeshStore store;
    const std::string name = file.filename().generic_string();
    const std::vector<MeshVisual>& looks =
        store.looks({folder / file.filename(), folder, name, name}, glm::dvec3(scale), scene.warnings);
    if (std::none_of(looks.begin(), looks.end(), [](const MeshVisual& look) { return look.color || look.texture; }))
        return;
    for (const MeshVisual& look : looks) {
        scene.visuals.push_back(
            {scene.world.bodies().at(0), {}, look.surface, look.color.value_or(Vec3(1.0f)), look.texture});
    }
}

} // namespace cairn::scene
