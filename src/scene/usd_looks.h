// The appearance of USD materials: UsdPreviewSurface, and UsdUVTexture for its color.
#pragma once

#include "scene/model_meshes.h"
#include "scene/usd_stage.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

class UsdLooks {
  public:
    // Pictures must lie in `folder` or below it; without a folder none are read.
    UsdLooks(const UsdStage& stage, std::optional<std::filesystem::path> folder, std::vector<std::string>& warnings)
        : stage_(stage), files_(std::move(folder)), warnings_(warnings) {}

    // Returns the color of a shape: that of its material, else its own, else gray.
    Vec3 color(const UsdPlace& place);
    // Applies the material of the prim to a look. `body`: the frame of the look's surface.
    void dress(const UsdPlace& place, const Rigid& body, ModelVisual& look);

  private:
    struct Paint {
        std::optional<Vec3> color;
        std::shared_ptr<const Texture> texture;
        std::shared_ptr<const Finish> finish;
    };
    const Paint& paint(const UsdPlace& place);
    Paint read(const UsdPrim& surface);
    std::shared_ptr<const Texture> read_texture(const UsdPrim& texture);
    const UsdPrim* surface_of(const UsdPlace& place) const;
    const UsdPrim* source(const UsdPrim& prim, const std::string& input) const;
    std::optional<Vec3> color_of(const UsdPrim& prim, const std::string& input) const;

    const UsdStage& stage_;
    ModelMeshes files_;
    std::vector<std::string>& warnings_;
    std::map<const UsdPrim*, Paint> known_; // keyed by the surface prim; null: no material
};

} // namespace cairn::scene
