#include "scene/usd_looks.h"

#include <cairn/error.h>

#include <algorithm>

namespace cairn::scene {

namespace {

constexpr double default_gray = 0.7;      // for shapes without a color
constexpr double default_roughness = 0.5; // default of UsdPreviewSurface

Vec3 color_from(std::vector<double> rgb, double otherwise) {
    rgb.resize(3, otherwise);
    const auto part = [&](std::size_t i) { return static_cast<float>(std::clamp(rgb[i], 0.0, 1.0)); };
    return {part(0), part(1), part(2)};
}

Texture::Wrap wrap_of(const std::string& word) {
    if (word == "mirror") return Texture::Wrap::mirror;
    return word == "clamp" || word == "black" ? Texture::Wrap::clamp : Texture::Wrap::repeat;
}

} // namespace

// Returns the prim that an input is connected to.
const UsdPrim* UsdLooks::source(const UsdPrim& prim, const std::string& input) const {
    const UsdValue* connected = stage_.value(prim, input + ".connect");
    if (connected == nullptr || connected->words.empty()) return nullptr;
    const std::string& path = connected->words[0];
    const UsdPlace* found = stage_.find(path.substr(0, path.find('.')));
    return found != nullptr ? found->prim : nullptr;
}

const UsdPrim* UsdLooks::surface_of(const UsdPlace& place) const {
    const UsdValue* bound = inherited(stage_, place, "material:binding");
    const UsdPlace* material = bound != nullptr && !bound->words.empty() ? stage_.find(bound->words[0]) : nullptr;
    const UsdPrim* surface = material != nullptr ? source(*material->prim, "outputs:surface") : nullptr;
    return surface != nullptr && stage_.word(*surface, "info:id") == "UsdPreviewSurface" ? surface : nullptr;
}

std::optional<Vec3> UsdLooks::color_of(const UsdPrim& prim, const std::string& input) const {
    const UsdValue* value = stage_.value(prim, input);
    if (value == nullptr) return std::nullopt;
    if (value->numbers.size() != 3) stage_.fail(prim, input, "must be three numbers");
    return color_from(value->numbers, 0.0);
}

std::shared_ptr<const Texture> UsdLooks::read_texture(const UsdPrim& texture) {
    const std::string file = stage_.word(texture, "inputs:file");
    if (file.empty()) stage_.fail(texture, "inputs:file", "must name a picture");
    Texture made;
    made.file = files_.picture({file, stage_.place(texture) + ": inputs:file"}, file, "");
    made.wrap_u = wrap_of(stage_.word(texture, "inputs:wrapS"));
    made.wrap_v = wrap_of(stage_.word(texture, "inputs:wrapT"));
    return std::make_shared<const Texture>(std::move(made));
}

UsdLooks::Paint UsdLooks::read(const UsdPrim& surface) {
    Paint paint;
    const UsdPrim* texture = source(surface, "inputs:diffuseColor");
    if (texture != nullptr && stage_.word(*texture, "info:id") == "UsdUVTexture") {
        try {
            paint.texture = read_texture(*texture);
        } catch (const Error& error) { // visuals do not affect the simulation
            warnings_.push_back(std::string(error.what()) + " (the texture is left out)");
        }
    }
    try {
        if (!paint.texture) paint.color = color_of(surface, "inputs:diffuseColor");
        const bool says_any = stage_.value(surface, "inputs:roughness") != nullptr ||
                              stage_.value(surface, "inputs:metallic") != nullptr ||
                              stage_.value(surface, "inputs:emissiveColor") != nullptr;
        if (!says_any) return paint;
        Finish finish;
        finish.roughness = static_cast<float>(stage_.number(surface, "inputs:roughness", default_roughness, 0.0, 1.0));
        finish.metalness = static_cast<float>(stage_.number(surface, "inputs:metallic", 0.0, 0.0, 1.0));
        finish.glow = color_of(surface, "inputs:emissiveColor").value_or(Vec3(0.0f));
        paint.finish = std::make_shared<const Finish>(std::move(finish));
    } catch (const Error& error) {
        warnings_.push_back(std::string(error.what()) + " (it is left out)");
    }
    return paint;
}

const UsdLooks::Paint& UsdLooks::paint(const UsdPlace& place) {
    const UsdPrim* surface = surface_of(place);
    const auto [known, is_new] = known_.try_emplace(surface);
    if (is_new && surface != nullptr) known->second = read(*surface);
    return known->second;
}

Vec3 UsdLooks::color(const UsdPlace& place) {
    if (const std::optional<Vec3> own = paint(place).color) return *own;
    const UsdValue* color = inherited(stage_, place, "primvars:displayColor");
    return color_from(color != nullptr ? color->numbers : std::vector<double>(), default_gray);
}

void UsdLooks::dress(const UsdPlace& place, const Rigid& body, ModelVisual& look) {
    const Paint& own = paint(place);
    look.color = color(place);
    look.finish = own.finish;
    if (!own.texture) return;
    std::shared_ptr<const Surface> covered = usd_covered_surface(stage_, place, body);
    if (!covered) {
        warnings_.push_back(stage_.place(*place.prim) + ": has no primvars:st (its texture is left out)");
        return;
    }
    look.surface = std::move(covered);
    look.at = Rigid();
    look.texture = own.texture;
    look.color = Vec3(1.0f);
}

} // namespace cairn::scene
