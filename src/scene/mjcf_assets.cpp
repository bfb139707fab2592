// Meshes, height fields and materials of MJCF models.
#include "scene/gltf_file.h"
#include "scene/mjcf_model.h"
#include "scene/tessellation.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace cairn::scene {

namespace {

constexpr std::size_t max_inline_numbers = std::size_t{1} << 22;

std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().generic_string(); }

// The binary height field format of MuJoCo: rows, columns, and heights from the row of least y on.
struct Heights {
    std::size_t rows = 0, columns = 0;
    std::vector<float> values; // beginning with the row of greatest y
};

Heights binary_heights(const std::vector<std::byte>& bytes, const XmlText& file) {
    std::int32_t size[2] = {0, 0};
    if (bytes.size() >= sizeof size) std::memcpy(size, bytes.data(), sizeof size);
    if (size[0] < 2 || size[1] < 2 || size[0] > 16384 || size[1] > 16384 ||
        bytes.size() != 8 + 4 * static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1])) {
        file.fail("must be a file of 2 to 16384 rows and columns, and as many heights");
    }
    Heights heights{static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[1]), {}};
    heights.values.resize(heights.rows * heights.columns);
    for (std::size_t row = 0; row < heights.rows; ++row) {
        std::memcpy(&heights.values[(heights.rows - 1 - row) * heights.columns],
                    bytes.data() + 8 + 4 * row * heights.columns, 4 * heights.columns);
    }
    return heights;
}

} // namespace

MjcfAssets::MjcfAssets(const XmlElement& root, const MjcfSettings& settings, const MjcfDefaults& defaults,
                       std::optional<std::filesystem::path> folder)
    : settings_(settings), files_(std::move(folder)) {
    for (const XmlElement& section : root.children("asset")) {
        const auto list = [&](const char* tag, std::map<std::string, MjcfElement>& into) {
            for (const XmlElement& child : section.children(tag)) {
                const MjcfElement element(child, defaults, 0);
                std::string name = element.name();
                if (name.empty()) name = stem_of(element.word("file"));
                if (!into.insert({name, element}).second) child.fail("must not have the name of another one");
            }
        };
        list("mesh", meshes_);
        list("hfield", fields_);
        list("material", materials_);
        for (const XmlElement& child : section.children("texture")) {
            const MjcfElement element(child, defaults, 0);
            std::string name = element.name();
            if (name.empty()) name = stem_of(element.word("file"));
            textures_.insert({name, element}); // skyboxes have no name
        }
    }
}

const MjcfElement& MjcfAssets::find(const std::map<std::string, MjcfElement>& list, const XmlText& name) const {
    const auto found = list.find(name.text);
    if (found == list.end()) name.fail("must be the name of an asset");
    return found->second;
}

std::shared_ptr<const Surface> MjcfAssets::mesh(const XmlText& name) {
    std::shared_ptr<const Surface>& found = read_[name.text];
    if (!found) found = read_mesh(find(meshes_, name), false);
    return found;
}

std::shared_ptr<const Surface> MjcfAssets::look(const XmlText& name) {
    std::shared_ptr<const Surface>& found = looks_[name.text];
    if (!found) found = read_mesh(find(meshes_, name), true);
    return found;
}

std::shared_ptr<const Surface> MjcfAssets::read_mesh(const MjcfElement& element, bool is_look) {
    const glm::dvec3 scale = element.vector3("scale", glm::dvec3(1.0));
    std::shared_ptr<const Surface> result;
    if (const auto file = element.attribute("file")) {
        std::string path = file->text;
        if (settings_.strips_paths) path = std::filesystem::path(path).filename().generic_string();
        result = is_look ? files_.look(*file, path, settings_.mesh_folder, scale)
                         : files_.load(*file, path, settings_.mesh_folder, scale);
    } else if (const auto corners = element.attribute("vertex")) {
        const std::vector<double> numbers = corners->numbers(12, max_inline_numbers);
        std::vector<Vec3> vertices;
        for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
            vertices.push_back(Vec3(glm::dvec3(numbers[i], numbers[i + 1], numbers[i + 2]) * scale));
        }
        const auto faces = element.attribute("face");
        std::vector<std::uint32_t> indices;
        for (const double index : faces ? faces->numbers(3, max_inline_numbers) : std::vector<double>()) {
            if (!(index >= 0.0 && index < static_cast<double>(vertices.size()) && index == std::floor(index))) {
                faces->fail("must have indices of vertices, from 0");
            }
            indices.push_back(static_cast<std::uint32_t>(index));
        }
        if (indices.size() % 3 != 0) faces->fail("must have three numbers for each triangle");
        try {
            result = std::make_shared<const Surface>(faces ? scaled_surface(vertices, indices, glm::dvec3(1.0))
                                                           : tessellate(Hull(vertices)));
        } catch (const Error& error) {
            element.fail(error.what());
        }
    } else {
        throw Error(ErrorCode::unsupported, element.place(), {}, "must have the attribute file or vertex");
    }
    const auto place = element.attribute("refpos"), turn = element.attribute("refquat");
    if (!place && !turn) return result;
    Rigid reference;
    if (place) reference.position = place->vector3();
    if (turn) {
        const std::vector<double> q = turn->numbers(4, 4);
        reference.rotation = glm::dquat(q[0], q[1], q[2], q[3]);
        const double square = glm::dot(reference.rotation, reference.rotation);
        if (!(square > 1e-12 && square < 1e12)) turn->fail("must not be zero");
        reference.rotation = glm::normalize(reference.rotation);
    }
    Surface moved = *result;
    const Rigid back = inverse(reference);
    for (Vec3& v : moved.vertices) v = Vec3(back.rotation * glm::dvec3(v) + back.position);
    for (Vec3& n : moved.normals) n = Vec3(back.rotation * glm::dvec3(n));
    return std::make_shared<const Surface>(std::move(moved));
}

HeightField MjcfAssets::height_field(const XmlText& name) {
    const MjcfElement& element = find(fields_, name);
    const auto size = element.attribute("size");
    if (!size) element.fail("must have the attribute size");
    const std::vector<double> extent = size->numbers(4, 4);
    Heights heights;
    if (const auto file = element.attribute("file"); file && !file->text.empty()) {
        const std::filesystem::path found = files_.find(*file, file->text, settings_.mesh_folder);
        if (found.extension() == ".png" || found.extension() == ".PNG") {
            throw Error(ErrorCode::unsupported, file->place, "\"" + printable(file->text) + "\"",
                        "must be a binary file of heights, as pictures are not read");
        }
        heights = binary_heights(read_file(found), *file);
    } else {
        const auto rows = element.attribute("nrow"), columns = element.attribute("ncol");
        if (!rows || !columns) element.fail("must have a file, or the attributes nrow and ncol");
        heights.rows = static_cast<std::size_t>(rows->whole(2, 16384));
        heights.columns = static_cast<std::size_t>(columns->whole(2, 16384));
        const std::size_t count = heights.rows * heights.columns;
        if (count > max_inline_numbers) rows->fail("must be fewer heights");
        heights.values.assign(count, 0.0f);
        if (const auto elevation = element.attribute("elevation")) {
            const std::vector<double> given = elevation->numbers(count, count);
            for (std::size_t i = 0; i < count; ++i) heights.values[i] = static_cast<float>(given[i]);
        }
    }
    float least = std::numeric_limits<float>::max(), most = -least;
    for (const float value : heights.values) {
        if (!(std::fabs(value) <= 1e30f)) element.fail("must have finite heights");
        least = std::min(least, value);
        most = std::max(most, value);
    }
    const float scale = most > least ? static_cast<float>(extent[2]) / (most - least) : 0.0f;
    for (float& value : heights.values) value = (value - least) * scale;
    try {
        return HeightField(static_cast<int>(heights.columns), static_cast<int>(heights.rows),
                           {static_cast<float>(2.0 * extent[0] / static_cast<double>(heights.columns - 1)),
                            static_cast<float>(2.0 * extent[1] / static_cast<double>(heights.rows - 1))},
                           heights.values);
    } catch (const Error& error) {
        throw Error(ErrorCode::invalid_file, element.place(), {}, error.what());
    }
}

} // namespace cairn::scene
