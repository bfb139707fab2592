#include "bench/save.h"

#include "bench/cairn_world.h"
#include "bench/overlap.h"

#include "scene/scene.h"

#include <cctype>
#include <cmath>
#include <limits>

namespace cairn::bench {

namespace {

struct View {
    Position low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    void add(const Position& center, double radius) {
        low = glm::min(low, center - radius);
        high = glm::max(high, center + radius);
    }
};

// A view of all dynamic bodies and meshes; floors may extend beyond it.
View view_of(const Scene& scene) {
    View view;
    for (const SceneBody& body : scene.bodies)
        for (std::size_t i = 0; i < body.part_count; ++i) {
            const Part& part = scene.parts[body.first_part + i];
            if (body.motion == Motion::fixed && part.shape != PartShape::mesh) continue;
            const PlacedPart placed = place(scene, part, {Position(body.position), body.rotation, {}, {}});
            view.add(placed.center, placed.bounding_radius);
        }
    return view;
}

scene::Camera camera_for(const Scene& scene) {
    const View view = view_of(scene);
    scene::Camera camera;
    camera.vertical_fov_degrees = 40.0f;
    constexpr double half_angle = 20 * 3.14159265358979323846 / 180;
    camera.target = 0.5 * (view.low + view.high);
    const double radius = 0.5 * glm::length(view.high - view.low);
    const Position direction = glm::normalize(Position(0.45, 0.4, 1.0));
    camera.position = camera.target + radius / std::sin(half_angle) * direction;
    return camera;
}

std::string_view description_of(const Scene& scene) {
    for (const SceneKind& kind : scene_kinds())
        if (kind.name == scene.name) return kind.description;
    return {};
}

} // namespace

std::filesystem::path save_scene(const Scene& scene, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw Error(ErrorCode::io, "folder", folder.string(),
                    "must be a folder, or a place for one" + (error ? " (" + error.message() + ")" : std::string()));
    scene::Scene saved;
    saved.world.set_settings(world_settings(scene));
    add_bodies(scene, saved.world, Walls::rectangles);
    saved.info.title = "Benchmark: " + scene.name;
    saved.info.hint = std::string(description_of(scene)) + " (" + std::to_string(scene.dynamic_count) + " bodies)";
    saved.info.hint[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(saved.info.hint[0])));
    saved.info.time_step = scene.time_step;
    saved.info.camera = camera_for(scene);
    const std::filesystem::path path = folder / (scene.name + ".gltf");
    scene::save(saved, path);
    return path;
}

} // namespace cairn::bench
