#include "scene/textures.h"

#include "scene/definitions.h"
#include "scene/document.h"
#include "scene/pictures.h"

#include <cmath>
#include <string_view>

namespace cairn::scene {

namespace {

constexpr std::size_t max_textures = 100'000, max_coordinate_sets = 64;
constexpr Range transform_range{-1e6, 1e6, false}, cutoff_range{0.0, 1e6, false};
constexpr Range share_range{0.0, 1.0, false}, strength_range{0.0, 1e6, false}, bump_range{-1e3, 1e3, false};
constexpr double half_opaque = 0.5; // glTF's default of `alphaCutoff`

// glTF 2.0, section 5.26: sampler codes for wrapping, and for magnification.
constexpr std::uint64_t clamped = 33071, mirrored = 33648, repeated = 10497, nearest = 9728;

Texture::Wrap wrap_of(const std::optional<Value>& sampler, const char* name) {
    const auto given = sampler ? sampler->find(name) : std::nullopt;
    const std::uint64_t code = given ? given->whole(0, 0xFFFF) : repeated;
    if (code == clamped) return Texture::Wrap::clamp;
    if (code == mirrored) return Texture::Wrap::mirror;
    if (code != repeated) given->fail("must be 33071, 33648 or 10497");
    return Texture::Wrap::repeat;
}

std::string text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; // bytes as characters
}

// Returns the textureInfo of the base color.
std::optional<Value> info_of(const Value& material) {
    const auto metal = material.find("pbrMetallicRoughness");
    return metal ? metal->find("baseColorTexture") : std::nullopt;
}

// KHR_texture_transform: scale, then rotation, then translation.
struct CoordinateMap {
    glm::dvec2 offset{0.0}, scale{1.0};
    double cosine = 1.0, sine = 0.0;

    explicit CoordinateMap(const std::optional<Value>& given) {
        if (!given) return;
        const auto read = [&](const char* name, glm::dvec2& pair) {
            const auto value = given->find(name);
            if (!value) return;
            if (value->size(2, "numbers") != 2) value->fail("must be an array of 2 numbers");
            pair = {(*value)[0].real(transform_range), (*value)[1].real(transform_range)};
        };
        read("offset", offset), read("scale", scale);
        if (const auto turn = given->find("rotation")) {
            const double angle = turn->real(transform_range);
            cosine = std::cos(angle), sine = std::sin(angle);
        }
    }
    bool operator==(const CoordinateMap&) const = default;
    glm::vec2 operator()(const glm::vec2& at) const {
        const double u = scale.x * double(at.x), v = scale.y * double(at.y);
        return {float(cosine * u + sine * v + offset.x), float(cosine * v - sine * u + offset.y)};
    }
};

// The texture coordinates that a textureInfo uses: one of the sets of a primitive, transformed.
struct TexturePlace {
    std::string attribute;
    CoordinateMap map;

    explicit TexturePlace(const Value& info) : map(extension(info, "KHR_texture_transform")) {
        const auto transform = extension(info, "KHR_texture_transform");
        auto set = transform ? transform->find("texCoord") : std::nullopt;
        if (!set) set = info.find("texCoord");
        attribute = "TEXCOORD_" + std::to_string(set ? set->whole(0, max_coordinate_sets) : 0);
    }
    bool operator==(const TexturePlace&) const = default;

    std::vector<glm::vec2> coordinates(const Triangles& triangles, Accessors& accessors) const {
        const auto accessor = triangles.attributes->find(attribute.c_str());
        if (!accessor) triangles.attributes->refuse("has no " + attribute);
        std::vector<glm::vec2> result = accessors.coordinates(*accessor);
        if (result.size() != triangles.vertices.size()) {
            accessor->fail("must have as many elements as POSITION, which has " +
                           std::to_string(triangles.vertices.size()));
        }
        for (glm::vec2& at : result) at = map(at);
        return result;
    }
};

// Returns the factor, which is 1 by default.
float factor(const std::optional<Value>& owner, const char* name, const Range& range) {
    const auto given = owner ? owner->find(name) : std::nullopt;
    return given ? given->real(range) : 1.0f;
}

// By default glTF treats a material as a metal; a material that defines only its color is hardly meant as one, so its
// finish is left to the viewer.
bool has_finish(const Value& material, const Finish& finish) {
    const auto metal = material.find("pbrMetallicRoughness");
    const bool is_metal = metal && metal->find("metallicFactor") && finish.metalness > 0.0f;
    const bool is_rough = metal && (metal->find("roughnessFactor") || metal->find("metallicRoughnessTexture"));
    return is_metal || is_rough || finish.normals || finish.glow != Vec3(0.0f);
}

// Reads the textures of a material in turn. All must use the same texture coordinates as the first one.
class FinishReader {
  public:
    using Read = std::function<std::shared_ptr<const Texture>(const Value& info, bool is_data)>;
    FinishReader(const Value& material, const Triangles& triangles, Accessors& accessors, Read read,
                 const Textures::Warn& warn)
        : material_(material), triangles_(triangles), accessors_(accessors), read_(std::move(read)), warn_(warn) {}

    std::shared_ptr<const Texture> take(const std::optional<Value>& info, bool is_data, const char* otherwise) {
        if (!info) return nullptr;
        try {
            const TexturePlace its(*info);
            if (place_ && !(its == *place_))
                info->refuse("must have the texCoord and the transform of the other textures of its material");
            std::vector<glm::vec2> corners = place_ ? coordinates : its.coordinates(triangles_, accessors_);
            auto texture = read_(*info, is_data);
            coordinates = std::move(corners);
            place_ = its;
            return texture;
        } catch (const Error& error) { // a faulty picture is no reason to refuse a scene
            warn_(std::string(error.what()) + otherwise);
            return nullptr;
        }
    }
    // Returns null if the material does not define a finish.
    std::shared_ptr<const Finish> finish() {
        const auto metal = material_.find("pbrMetallicRoughness");
        const char* const otherwise = " (this texture is left out)";
        Finish finish;
        finish.roughness = factor(metal, "roughnessFactor", share_range);
        finish.metalness = factor(metal, "metallicFactor", share_range);
        finish.rough = take(metal ? metal->find("metallicRoughnessTexture") : std::nullopt, true, otherwise);
        const auto normals = material_.find("normalTexture");
        finish.normals = take(normals, true, otherwise);
        finish.normal_scale = factor(normals, "scale", bump_range);
        if (const auto glow = material_.find("emissiveFactor")) finish.glow = glow->float_vector3(share_range);
        finish.glow_strength =
            factor(extension(material_, "KHR_materials_emissive_strength"), "emissiveStrength", strength_range);
        if (finish.glow != Vec3(0.0f)) finish.glows = take(material_.find("emissiveTexture"), false, otherwise);
        return has_finish(material_, finish) ? std::make_shared<const Finish>(std::move(finish)) : nullptr;
    }
    std::vector<glm::vec2> coordinates;

  private:
    const Value& material_;
    const Triangles& triangles_;
    Accessors& accessors_;
    const Read read_;
    const Textures::Warn& warn_;
    std::optional<TexturePlace> place_;
};

} // namespace

bool Textures::is_textured(const Value& material) { return info_of(material).has_value(); }

MaterialAppearance Textures::covering(const Value& material, const Triangles& triangles, const Warn& warn) {
    const auto read = [&](const Value& info, bool is_data) { return read_texture(info, material, is_data); };
    FinishReader reader(material, triangles, surfaces_.accessors(), read, warn);
    MaterialAppearance result;
    result.texture =
        reader.take(info_of(material), false, " (its texture is not shown: a plain gray, tinted by the base color)");
    try {
        result.finish = reader.finish();
    } catch (const Error& error) {
        warn(std::string(error.what()) + " (it is treated as smooth)");
    }
    result.coordinates = std::move(reader.coordinates);
    return result;
}

std::string Textures::read_picture(const Value& image) {
    const auto uri = image.find("uri");
    Buffers& buffers = surfaces_.accessors().buffers();
    std::string file = uri ? text_of(buffers.file(*uri)) : text_of(buffers.view(image.require("bufferView")).bytes);
    if (!is_picture(file)) image.refuse("is neither a PNG nor a JPEG picture");
    return file;
}

std::shared_ptr<const Texture> Textures::read_texture(const Value& info, const Value& material, bool is_data) {
    const Value texture = element(document_.find("textures"), info.require("index"), max_textures, "textures");
    const auto source = texture.find("source");
    if (!source) texture.refuse("has no picture in PNG or JPEG");
    const Value image = element(document_.find("images"), *source, max_textures, "images");
    const auto sampler_index = texture.find("sampler");
    std::optional<Value> sampler;
    if (sampler_index) sampler = element(document_.find("samplers"), *sampler_index, max_textures, "samplers");
    Texture result;
    result.wrap_u = wrap_of(sampler, "wrapS"), result.wrap_v = wrap_of(sampler, "wrapT");
    const auto enlarged = sampler ? sampler->find("magFilter") : std::nullopt;
    result.is_smooth = !enlarged || enlarged->whole(0, 0xFFFF) != nearest;
    result.is_data = is_data;
    const auto mode = is_data ? std::nullopt : material.find("alphaMode");
    const auto cutoff = material.find("alphaCutoff");
    if (mode && mode->text() == "MASK")
        result.alpha_cutoff = float(cutoff ? cutoff->real(cutoff_range) : half_opaque);
    else if (mode && mode->text() == "BLEND") // partial transparency is not supported: a cutoff replaces blending
        result.alpha_cutoff = float(half_opaque);
    const std::size_t number = source->index(max_textures, "images");
    const std::string key = std::to_string(number) + " " + std::to_string(int(result.wrap_u)) +
                            std::to_string(int(result.wrap_v)) + std::to_string(int(result.is_smooth)) + " " +
                            std::to_string(result.alpha_cutoff) + (is_data ? " data" : "");
    std::shared_ptr<const Texture>& known = known_[key];
    if (known) return known;
    std::shared_ptr<const std::string>& file = files_[number];
    if (!file) file = std::make_shared<const std::string>(read_picture(image));
    result.file = file;
    return known = std::make_shared<const Texture>(std::move(result));
}

} // namespace cairn::scene
