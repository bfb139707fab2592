#include "scene/models.h"

#include "scene/usd_text.h"

#include <cairn/error.h>

#include <string_view>

#ifdef CAIRN_SCENE_MODELS
#include "scene/mjcf.h"
#include "scene/sdf.h"
#include "scene/urdf.h"
#include "scene/usd.h"
#include "scene/xml_file.h"
#endif

namespace cairn::scene {

namespace {

// Whether the first character that is not white space is "<".
bool is_xml(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '<';
}

} // namespace

#ifdef CAIRN_SCENE_MODELS

std::optional<Scene> load_model(std::span<const std::byte> bytes, const std::string& name,
                                const std::optional<std::filesystem::path>& folder, const LoadOptions& options) {
    if (is_xml(bytes)) {
        const std::string root = root_tag(bytes);
        return (root == "mujoco" ? load_mjcf : root == "sdf" ? load_sdf : load_urdf)(bytes, name, folder, options);
    }
    if (options.fixed_base) {
        throw Error(ErrorCode::unsupported, name, {}, "must be a robot in URDF, MJCF or SDF for its base to be fixed");
    }
    if (usd_kind(bytes) != UsdKind::none) return load_usd(bytes, name, folder, options);
    return std::nullopt;
}

#else

std::optional<Scene> load_model(std::span<const std::byte> bytes, const std::string& name,
                                const std::optional<std::filesystem::path>&, const LoadOptions& options) {
    if (is_xml(bytes) || usd_kind(bytes) != UsdKind::none || options.fixed_base) {
        throw Error(ErrorCode::unsupported, name, {}, "must be glTF: this build reads no URDF, MJCF, SDF or USD");
    }
    return std::nullopt;
}

#endif

} // namespace cairn::scene
