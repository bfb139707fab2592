// Textures of MJCF models, and how they are mapped to geoms.
#include "scene/mjcf_model.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr std::size_t most_pixels = 256; // per edge of a procedural picture
using Rgb = std::array<std::uint8_t, 3>;

Rgb color_of(const MjcfElement& texture, const char* name, double otherwise) {
    Rgb color{};
    const auto given = texture.attribute(name);
    const std::vector<double> parts = given ? given->numbers(3, 3) : std::vector<double>(3, otherwise);
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<std::uint8_t>(255.0 * std::clamp(parts[i], 0.0, 1.0)); // truncated as in MuJoCo
    return color;
}

float linear_of(std::uint8_t part) { // of sRGB
    const double value = part / 255.0;
    return static_cast<float>(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
}

bool is_flat_cube(const MjcfElement& texture) {
    return texture.word("type", "cube") == "cube" && texture.word("builtin") == "flat" && !texture.attribute("file");
}

// Returns the name of the texture for the color.
std::optional<XmlText> texture_name(const MjcfElement& material) {
    if (const auto name = material.attribute("texture")) return name;
    for (const XmlElement& layer : material.xml().children("layer")) {
        const std::string role = layer.text_of("role");
        if (role == "rgb" || role == "rgba") return layer.attribute("texture");
    }
    return std::nullopt;
}

// The gradient palette: colors from the first one, in the middle of the picture, to the second, with MuJoCo's profile.
constexpr std::size_t levels = 254;
constexpr std::uint8_t mark = 255;

double share_of_second(double from_middle) {
    const double at = 2.0 * from_middle - 1.0;
    return std::clamp(0.5 * (1.0 + at / std::sqrt(1.0 + at * at) * std::sqrt(2.0)), 0.0, 1.0);
}

std::vector<Rgb> palette(const Rgb& first, const Rgb& second, const Rgb& marks) {
    std::vector<Rgb> colors(mark + std::size_t{1}, marks);
    for (std::size_t level = 0; level <= levels; ++level)
        for (std::size_t i = 0; i < 3; ++i)
            colors[level][i] = static_cast<std::uint8_t>((first[i] * (levels - level) + second[i] * level) / levels);
    return colors;
}

} // namespace

std::string mjcf_builtin_picture(const MjcfElement& texture) {
    const auto words = texture.attribute("builtin"), marks = texture.attribute("mark");
    const std::size_t kind = words ? words->choice({"none", "gradient", "checker", "flat"}) : 0;
    if (kind == 0) texture.fail("must have a file, or the attribute builtin");
    const std::size_t marked = marks ? marks->choice({"none", "edge", "cross", "random"}) : 0;
    const auto edge = [&](const char* name) {
        const auto given = texture.attribute(name);
        if (!given) texture.fail(std::string("must have the attribute ") + name + ", as what is builtin has");
        return std::min(static_cast<std::size_t>(given->whole(1, 1'000'000)), most_pixels);
    };
    const std::size_t width = edge("width"), height = edge("height");
    std::vector<std::uint8_t> pixels;
    for (std::size_t row = 0; row < height; ++row) {
        for (std::size_t column = 0; column < width; ++column) {
            const double x = width > 1 ? 2.0 * double(column) / double(width - 1) - 1.0 : 0.0;
            const double y = height > 1 ? 2.0 * double(row) / double(height - 1) - 1.0 : 0.0;
            const bool is_second = kind == 2 && (row < height / 2) != (column < width / 2);
            const double share = kind == 1 ? share_of_second(std::sqrt(x * x + y * y)) : is_second ? 1.0 : 0.0;
            const bool is_edge = row == 0 || column == 0 || row + 1 == height || column + 1 == width;
            const bool is_cross = row == height / 2 || column == width / 2;
            const bool is_marked = (marked == 1 && is_edge) || (marked == 2 && is_cross);
            pixels.push_back(is_marked ? mark : static_cast<std::uint8_t>(std::lround(share * double(levels))));
        }
    }
    return png_file(
        width, height, pixels,
        palette(color_of(texture, "rgb1", 0.8), color_of(texture, "rgb2", 0.5), color_of(texture, "markrgb", 0.0)));
}

std::shared_ptr<const Texture> MjcfAssets::read_texture(const MjcfElement& element) {
    const auto type = element.attribute("type");
    if (!type || type->choice({"2d", "cube", "skybox"}) != 0)
        throw Error(ErrorCode::unsupported, element.place(), {}, "must be of type 2d to be shown");
    Texture made;
    const auto file = element.attribute("file");
    if (file) {
        std::string path = file->text;
        if (settings_.strips_paths) path = std::filesystem::path(path).filename().generic_string();
        made.file = files_.picture(*file, path, settings_.texture_folder);
    } else {
        made.file = std::make_shared<const std::string>(mjcf_builtin_picture(element));
    }
    return std::make_shared<const Texture>(std::move(made));
}

std::optional<MjcfMaterial> MjcfAssets::material(const XmlText& name, std::vector<std::string>& warnings) {
    const auto given = materials_.find(name.text);
    if (given == materials_.end()) return std::nullopt;
    const auto [known, is_new] = read_materials_.try_emplace(name.text);
    MjcfMaterial& made = known->second;
    if (!is_new) return made;
    const MjcfElement& element = given->second;
    made.color = element.attribute("rgba");
    const auto texture = texture_name(element);
    if (!texture) return made;
    try {
        const MjcfElement& picture = find(textures_, *texture);
        if (is_flat_cube(picture)) { // one color above, another around, usually the same; the mean is used
            const Rgb above = color_of(picture, "rgb1", 0.8), around = color_of(picture, "rgb2", 0.5);
            for (std::size_t i = 0; i < 3; ++i)
                made.tint[static_cast<int>(i)] = 0.5f * (linear_of(above[i]) + linear_of(around[i]));
            return made;
        }
        if (const auto repeat = element.attribute("texrepeat")) {
            const std::vector<double> numbers = repeat->numbers(1, 2);
            for (std::size_t i = 0; i < 2; ++i) {
                made.repeat[i] = numbers[std::min(i, numbers.size() - 1)];
                if (!(std::fabs(made.repeat[i]) <= 1e6)) repeat->fail("must be within 1000000");
            }
        }
        if (const auto uniform = element.attribute("texuniform")) made.is_uniform = uniform->boolean();
        made.texture = read_texture(picture);
    } catch (const Error& error) { // visuals do not affect the simulation
        warnings.push_back(std::string(error.what()) + " (the texture is left out)");
    }
    return made;
}

Surface mjcf_covered(const Surface& surface, const Rigid& in_geom, const MjcfMaterial& material,
                     const glm::dvec2& half_sizes) {
    Surface covered = surface;
    if (!covered.coordinates.empty()) return covered;
    for (const Vec3& vertex : surface.vertices) {
        const glm::dvec3 at = in_geom.rotation * glm::dvec3(vertex) + in_geom.position;
        glm::dvec2 place;
        for (int i = 0; i < 2; ++i) {
            const double unit = material.is_uniform || half_sizes[i] <= 0.0 ? 1.0 : half_sizes[i];
            const double turns = 0.5 * material.repeat[static_cast<std::size_t>(i)] * at[i] / unit;
            place[i] = (i == 0 ? turns : -turns) - 0.5;
        }
        covered.coordinates.emplace_back(place);
    }
    return covered;
}

} // namespace cairn::scene
