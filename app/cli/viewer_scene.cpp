#include "cli/viewer_scene.h"

#include "cli/outputs.h"
#include "cli/svg_plot.h"
#include "recording/recorder.h"
#include "recording/recording.h"
#include "scene/mesh_store.h"
#include "viewer/visual_notes.h"
#include "viewer/world_state.h"

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace cairn::cli {

std::vector<viewer::Appearance> appearances_of(const scene::Scene& scene) {
    std::vector<viewer::Appearance> appearances;
    appearances.reserve(scene.appearances.size());
    for (const scene::Appearance& appearance : scene.appearances) {
        appearances.push_back({appearance.shape, appearance.color});
    }
    return appearances;
}

namespace {

// Reads the textures of a scene, each once. An unreadable texture gives a warning.
class TextureReader {
  public:
    std::shared_ptr<const viewer::TexturePicture> operator()(const std::shared_ptr<const scene::Texture>& texture) {
        if (!texture) return nullptr;
        const auto [place, is_new] = known_.try_emplace(texture.get());
        if (!is_new) return place->second;
        try {
            const viewer::TextureStyle style{viewer::TextureStyle::Wrap(int(texture->wrap_u)),
                                             viewer::TextureStyle::Wrap(int(texture->wrap_v)), texture->is_smooth,
                                             texture->alpha_cutoff, texture->is_data};
            place->second = std::make_shared<const viewer::TexturePicture>(viewer::read_texture(texture->file, style));
        } catch (const Error& error) {
            print_warnings({{std::string(error.what()) + " (it is not shown)"}});
        }
        return place->second;
    }

    std::shared_ptr<const viewer::Finish> operator()(const std::shared_ptr<const scene::Finish>& finish) {
        if (!finish) return nullptr;
        std::shared_ptr<const viewer::Finish>& known = finishes_[finish.get()];
        if (!known)
            known = std::make_shared<const viewer::Finish>(
                viewer::Finish{finish->roughness, finish->metalness, (*this)(finish->rough), (*this)(finish->normals),
                               finish->normal_scale, finish->glow, finish->glow_strength, (*this)(finish->glows)});
        return known;
    }

  private:
    std::unordered_map<const scene::Texture*, std::shared_ptr<const viewer::TexturePicture>> known_;
    std::unordered_map<const scene::Finish*, std::shared_ptr<const viewer::Finish>> finishes_;
};

// Weights for each vertex of `visual_triangles`, which duplicates vertices for flat-shaded triangles.
std::vector<viewer::BoneWeights> weights_of(const scene::Surface& surface) {
    std::vector<viewer::BoneWeights> weights;
    const auto add = [&](std::size_t vertex) {
        weights.push_back({surface.weights[vertex].bones, surface.weights[vertex].shares});
    };
    if (surface.normals.empty())
        for (const std::uint32_t corner : surface.indices) add(corner);
    else
        for (std::size_t i = 0; i < surface.vertices.size(); ++i) add(i);
    return weights;
}

} // namespace

std::vector<viewer::Visual> visuals_of(const scene::Scene& scene) {
    std::vector<viewer::Visual> visuals;
    TextureReader read_texture;
    using Key = std::tuple<const scene::Surface*, const scene::Texture*, const scene::Finish*>;
    std::map<Key, std::shared_ptr<const viewer::ShapeMesh>> meshes;
    for (const scene::VisualMesh& visual : scene.visuals) {
        std::shared_ptr<const viewer::ShapeMesh>& mesh =
            meshes[{visual.surface.get(), visual.texture.get(), visual.finish.get()}];
        if (!mesh) {
            const scene::Surface& surface = *visual.surface;
            viewer::ShapeMesh made =
                viewer::make_shape_mesh(viewer::visual_triangles(surface.vertices, surface.normals, surface.indices,
                                                                 surface.coordinates, surface.colors),
                                        viewer::MeshVisual::visual);
            if (!surface.coordinates.empty()) made.texture = read_texture(visual.texture);
            made.finish = read_texture(visual.finish);
            if (!surface.weights.empty()) made.weights = weights_of(surface);
            mesh = std::make_shared<const viewer::ShapeMesh>(std::move(made));
        }
        visuals.push_back({visual.body, visual.local, mesh, visual.color});
        for (const scene::Bone& bone : visual.bones)
            visuals.back().bones.push_back({bone.body, bone.linear, bone.translation});
    }
    return visuals;
}

namespace {

// The reverse conversion, for saving a scene: surfaces and textures are shared as the meshes are.
class SurfaceMaker {
  public:
    scene::VisualMesh operator()(const viewer::Visual& visual) {
        const viewer::ShapeMesh& mesh = *visual.mesh;
        std::shared_ptr<const scene::Surface>& surface = surfaces_[&mesh];
        if (!surface) surface = std::make_shared<const scene::Surface>(surface_of(mesh));
        scene::VisualMesh made{visual.body, visual.local,          surface, visual.color, texture_of(mesh.texture),
                               {},          finish_of(mesh.finish)};
        for (const viewer::Bone& bone : visual.bones) made.bones.push_back({bone.body, bone.linear, bone.translation});
        return made;
    }

  private:
    static scene::Surface surface_of(const viewer::ShapeMesh& mesh) {
        scene::Surface surface;
        for (const viewer::MeshVertex& vertex : mesh.triangles.vertices) {
            surface.vertices.push_back(vertex.corner);
            surface.normals.push_back(vertex.normal);
            if (mesh.texture || mesh.finish) surface.coordinates.emplace_back(vertex.inset.x, vertex.inset.y);
        }
        for (const viewer::BoneWeights& weights : mesh.weights)
            surface.weights.push_back({weights.bones, weights.shares});
        surface.indices = mesh.triangles.indices;
        surface.colors = mesh.triangles.colors;
        return surface;
    }
    std::shared_ptr<const scene::Finish> finish_of(const std::shared_ptr<const viewer::Finish>& finish) {
        if (!finish) return nullptr;
        std::shared_ptr<const scene::Finish>& known = finishes_[finish.get()];
        if (!known)
            known = std::make_shared<const scene::Finish>(scene::Finish{
                finish->roughness, finish->metalness, texture_of(finish->rough), texture_of(finish->normals),
                finish->normal_scale, finish->glow, finish->glow_strength, texture_of(finish->glows)});
        return known;
    }
    std::shared_ptr<const scene::Texture> texture_of(const std::shared_ptr<const viewer::TexturePicture>& picture) {
        if (!picture) return nullptr;
        std::shared_ptr<const scene::Texture>& texture = textures_[picture.get()];
        if (!texture) {
            const viewer::TextureStyle& style = picture->style;
            texture = std::make_shared<const scene::Texture>(scene::Texture{
                picture->file, scene::Texture::Wrap(int(style.wrap_u)), scene::Texture::Wrap(int(style.wrap_v)),
                style.is_smooth, style.alpha_cutoff, style.is_data});
        }
        return texture;
    }

    std::unordered_map<const viewer::ShapeMesh*, std::shared_ptr<const scene::Surface>> surfaces_;
    std::unordered_map<const viewer::TexturePicture*, std::shared_ptr<const scene::Texture>> textures_;
    std::unordered_map<const viewer::Finish*, std::shared_ptr<const scene::Finish>> finishes_;
};

} // namespace

std::vector<viewer::JointAppearance> strings_of(const scene::Scene& scene) {
    std::vector<viewer::JointAppearance> strings;
    for (const scene::JointAppearance& shown : scene.joint_appearances) strings.push_back({shown.joint, shown.color});
    return strings;
}

std::vector<viewer::Light> lights_of(const scene::Scene& scene) {
    std::vector<viewer::Light> lights;
    for (const scene::Light& light : scene.info.lights)
        lights.push_back({viewer::Light::Kind(int(light.kind)), light.color, light.intensity, light.position,
                          light.towards, light.range, light.inner_cone, light.outer_cone});
    return lights;
}

viewer::CameraPose camera_of(const scene::Scene& scene, std::span<const viewer::Visual> visuals) {
    if (!scene.info.camera) return viewer::fit_camera(scene.world, visuals);
    viewer::CameraPose pose;
    pose.position = scene.info.camera->position;
    pose.target = scene.info.camera->target;
    pose.vertical_fov = glm::radians(scene.info.camera->vertical_fov_degrees);
    pose.is_parallel = scene.info.camera->is_orthographic;
    return pose;
}

std::vector<std::string> viewer_file_types() {
    return {".gltf", ".glb", ".urdf", ".xml", ".sdf", ".world", ".usda", ".obj", ".stl", ".mcap"};
}

namespace {

// A single mesh becomes a static body with its exact triangles, to drop bodies on.
scene::Scene load_any(const std::filesystem::path& path, const ReadOptions& options) {
    if (!scene::is_mesh_file(path)) return options.load(path);
    if (options.fixed_base) {
        throw Error(ErrorCode::unsupported, path.string(), {},
                    "must be a robot in URDF, MJCF or SDF for its base to be fixed");
    }
    scene::MeshImport import;
    import.as_hull = false;
    scene::Scene scene = scene::scene_of_mesh(scene::load_mesh_file(path), import, path.stem().string());
    scene::add_mesh_looks(path, import.scale, scene);
    scene.info.hint = "U I O and J K L M drop bodies on it";
    if (options.floor) scene::add_floor(scene);
    return scene;
}

// An open recording and its reader, kept alive by the command source.
struct OpenRecording {
    explicit OpenRecording(const std::filesystem::path& path) : recording(path), calls(recording) {}
    recording::Recording recording;
    recording::CallReader calls;
};

// Reads lights up to the first malformed one.
void read_lights(std::istringstream words, std::vector<viewer::Light>& lights) {
    viewer::Light light;
    Vec3 &color = light.color, &towards = light.towards;
    Position& place = light.position;
    int kind = 0;
    while (words >> kind >> color.x >> color.y >> color.z >> light.intensity >> place.x >> place.y >> place.z >>
           towards.x >> towards.y >> towards.z >> light.range >> light.inner_cone >> light.outer_cone) {
        if (kind < 0 || kind > int(viewer::Light::Kind::spot) || light.intensity < 0.0f || towards == Vec3(0.0f))
            return;
        light.kind = viewer::Light::Kind(kind);
        lights.push_back(light);
    }
}

// Parses a note of `note_of`. Missing or malformed entries leave the defaults.
void take_looks(viewer::LoadedScene& loaded, const std::map<std::string, std::string>& note) {
    const auto words = [&](const char* name) {
        const auto found = note.find(name);
        return std::istringstream(found == note.end() ? std::string() : found->second);
    };
    viewer::CameraPose camera = loaded.camera;
    Position &eye = camera.position, &target = camera.target;
    auto of_camera = words("camera");
    if (of_camera >> eye.x >> eye.y >> eye.z >> target.x >> target.y >> target.z >> camera.vertical_fov >>
            camera.is_parallel &&
        eye != target && camera.vertical_fov > 0.0f && camera.vertical_fov < 3.1f)
        loaded.camera = camera;
    read_lights(words("lights"), loaded.lights);
    Vec3 sun(0.0f); // older recordings have a sun direction only
    auto of_sun = words("light");
    if (loaded.lights.empty() && of_sun >> sun.x >> sun.y >> sun.z && sun != Vec3(0.0f))
        loaded.lights.push_back({.color = {1.0f, 0.93f, 0.82f}, .towards = sun});
    loaded.visuals = viewer::visuals_of(note, loaded.world);
    std::map<std::uint32_t, ShapeId> shapes;
    for (const BodyId body : loaded.world.bodies())
        for (const ShapeId shape : loaded.world.body(body).shapes()) shapes.emplace(shape.index(), shape);
    auto of_colors = words("colors");
    std::uint32_t slot = 0;
    for (Vec3 color(0.0f); of_colors >> slot >> color.x >> color.y >> color.z;)
        if (const auto found = shapes.find(slot); found != shapes.end())
            loaded.appearances.push_back({found->second, glm::clamp(color, 0.0f, 1.0f)});
}

// Loads a recording: the world at its beginning, built by the commands before the first step, and all later commands.
viewer::LoadedScene load_recording(const std::filesystem::path& path) {
    const auto open = std::make_shared<OpenRecording>(path);
    viewer::LoadedScene loaded;
    loaded.world.set_threads(hardware_threads());
    loaded.run.source = {open, open->calls.source().get()};
    loaded.run.keyframe = [open](std::uint64_t after, std::uint64_t until) {
        return open->calls.keyframe(after, until);
    };
    std::vector<viewer::RecordedStep>& steps = loaded.run.steps;
    steps.emplace_back();
    recording::RecordedCall call;
    while (open->calls.next(call)) {
        if (call.command.empty()) continue; // only the digest of a keyframe's state
        if (call.is_step) {
            steps.back().step = call.command;
            steps.back().digest = call.digest;
            steps.emplace_back();
        } else if (steps.size() == 1) {
            loaded.world.execute(call.command, *loaded.run.source);
        } else {
            steps.back().changes.push_back(call.command);
        }
    }
    const recording::RecordingInfo& info = open->recording.info();
    if (info.steps > 0) loaded.time_step = float(info.seconds / double(info.steps));
    loaded.title = path.filename().string();
    loaded.hint = "a recording" + (info.source.empty() ? std::string() : " of " + info.source) +
                  ": drag on the bar below, or press Space";
    loaded.camera = viewer::fit_camera(loaded.world);
    take_looks(loaded, open->recording.note(looks_note));
    loaded.is_paused = true;
    return loaded;
}

} // namespace

std::map<std::string, std::string> note_of(const viewer::RecordingLooks& looks, const World& world) {
    const viewer::CameraPose& camera = looks.camera;
    std::string colors;
    for (const viewer::Appearance& known : looks.appearances)
        if (world.is_valid(known.shape))
            colors += fmt::format("{} {:.9g} {:.9g} {:.9g}\n", known.shape.index(), known.color.x, known.color.y,
                                  known.color.z);
    std::map<std::string, std::string> note{
        {"camera", fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.9g} {}", camera.position.x,
                               camera.position.y, camera.position.z, camera.target.x, camera.target.y, camera.target.z,
                               camera.vertical_fov, camera.is_parallel ? 1 : 0)},
        {"colors", colors}};
    note.merge(viewer::notes_of(looks.visuals, world));
    for (const viewer::Light& light : looks.lights)
        note["lights"] += fmt::format(
            "{} {:.9g} {:.9g} {:.9g} {:.9g} {:.17g} {:.17g} {:.17g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n",
            int(light.kind), light.color.x, light.color.y, light.color.z, light.intensity, light.position.x,
            light.position.y, light.position.z, light.towards.x, light.towards.y, light.towards.z, light.range,
            light.inner_cone, light.outer_cone);
    return note;
}

void save_recording(const std::filesystem::path& path, const viewer::RecordingLooks& looks, World& world,
                    const std::function<void()>& run) {
    recording::RecorderOptions options;
    options.source = looks.source;
    recording::Recorder recorder(path, options);
    recorder.note(looks_note, note_of(looks, world));
    world.set_command_listener(recorder.listener());
    run();
    recorder.close();
}

void save_scene(const std::filesystem::path& path, viewer::LoadedScene& saved) {
    scene::Scene scene;
    scene.info.title = saved.title;
    scene.info.hint = saved.hint;
    scene.info.time_step = saved.time_step;
    scene.info.camera = scene::Camera{saved.camera.position, saved.camera.target,
                                      glm::degrees(saved.camera.vertical_fov), saved.camera.is_parallel};
    for (const viewer::Light& light : saved.lights)
        scene.info.lights.push_back({scene::Light::Kind(int(light.kind)), light.color, light.intensity, light.position,
                                     light.towards, light.range, light.inner_cone, light.outer_cone});
    for (const viewer::Appearance& appearance : saved.appearances)
        if (saved.world.is_valid(appearance.shape))
            scene.appearances.push_back({saved.world.body_of(appearance.shape), appearance.shape, appearance.color});
    SurfaceMaker made_of;
    for (const viewer::Visual& visual : saved.visuals)
        if (visual.body.is_null() || saved.world.is_valid(visual.body)) scene.visuals.push_back(made_of(visual));
    for (const viewer::JointAppearance& shown : saved.strings)
        scene.joint_appearances.push_back({shown.joint, shown.color});
    for (const ForceFieldId id : saved.world.force_fields()) {
        scene.force_fields.push_back(id);
        scene.info.force_fields.push_back(saved.world.force_field(id));
    }
    scene.groups = saved.groups;
    scene.world = std::move(saved.world);
    scene::save(scene, path);
}

std::string svg_of_chart(const viewer::Chart& chart) {
    validation::Plot plot{chart.title, chart.x_label, chart.y_label, chart.log_x, chart.log_y, {}};
    for (const viewer::Curve& curve : chart.curves) {
        validation::Curve drawn{curve.is_reference ? "expected: " + curve.label : curve.label, curve.x, curve.y,
                                curve.as_points};
        if (chart.top) // values above the top leave a gap
            for (double& y : drawn.y)
                if (y > *chart.top) y = std::numeric_limits<double>::quiet_NaN();
        plot.curves.push_back(std::move(drawn));
    }
    return svg_plot(plot);
}

viewer::LoadedScene load_for_viewer(const std::string& path, const ReadOptions& options) {
    if (std::filesystem::path(path).extension() == ".mcap") return load_recording(path);
    scene::Scene scene = load_any(scene::find_scene(path), options);
    print_warnings(scene.warnings);
    viewer::LoadedScene loaded;
    loaded.appearances = appearances_of(scene);
    loaded.visuals = visuals_of(scene);
    loaded.strings = strings_of(scene);
    loaded.camera = camera_of(scene, loaded.visuals);
    loaded.lights = lights_of(scene);
    loaded.title = scene.info.title;
    loaded.hint = scene.info.hint;
    loaded.time_step = scene.info.time_step;
    loaded.groups = scene.groups;
    scene.world.set_threads(hardware_threads());
    loaded.world = std::move(scene.world);
    return loaded;
}

} // namespace cairn::cli
