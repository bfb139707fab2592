#include "viewer/gl_renderer.h"

#include "viewer/culling.h"
#include "viewer/gl_lines.h"
#include "viewer/gl_objects.h"
#include "viewer/gl_target.h"
#include "viewer/gl_textures.h"
#include "viewer/shaders.h"
#include "viewer/shadow_region.h"

#include <cairn/error.h>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cairn::viewer {

namespace {

constexpr int shadow_size = 2048;       // texels along an edge of the shadow map
constexpr float fade_distances = 20.0f; // camera distances over which the ground fades
constexpr float extent_fades = 12.0f;   // in `fade_distances`: distance at which the ground ends
constexpr float ghost_opacity = 0.55f;
// Number of pictures drawn without a mesh before it is freed; one window frame may have several pictures.
constexpr int most_unused = 16;

// Level of detail of round shapes, by the radius in pixels on the screen.
struct Detail {
    float min_pixels;
    int segments, rings; // rings of capsules; spheres use a third of them, cylinders none
};
constexpr std::array<Detail, 5> details{
    {{0.0f, 10, 3}, {6.0f, 16, 5}, {14.0f, 24, 6}, {32.0f, 48, 12}, {140.0f, 96, 18}}};

// A round shape in all levels of detail, and the instances of each level.
class RoundMeshes {
  public:
    template <class Make> explicit RoundMeshes(Make make) {
        for (const Detail& detail : details) meshes_.emplace_back(make(detail));
    }
    // `sort` puts instances in drawing order; `pixels_of` computes the radius on the screen.
    template <class Sort, class Pixels>
    void upload(const std::vector<Instance>& instances, const Sort& sort, const Pixels& pixels_of) {
        for (std::vector<Instance>& list : lists_) list.clear();
        for (const Instance& instance : instances) {
            const float pixels = pixels_of(instance);
            std::size_t level = 0;
            while (level + 1 < details.size() && pixels >= details[level + 1].min_pixels) ++level;
            lists_[level].push_back(instance);
        }
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            sort(lists_[i]);
            meshes_[i].upload(lists_[i].data(), lists_[i].size());
        }
    }
    void draw() const {
        for (const GlMesh& mesh : meshes_) mesh.draw();
    }

  private:
    std::vector<GlMesh> meshes_;
    std::array<std::vector<Instance>, details.size()> lists_;
};

// A mesh of a frame in GPU memory.
struct LoadedMesh {
    std::shared_ptr<const ShapeMesh> source; // kept alive so that its address stays unique
    GlMesh mesh;
    int unused = 0; // pictures drawn since it was last used
};

shaders::BodyKind kind_of(const ShapeMesh& mesh) {
    switch (mesh.look) {
    case MeshVisual::facets:
        return shaders::BodyKind::facets;
    case MeshVisual::surface:
        return shaders::BodyKind::surface;
    case MeshVisual::terrain:
        return shaders::BodyKind::terrain;
    case MeshVisual::visual:
        break;
    }
    if (mesh.finish) return shaders::BodyKind::finished;
    return mesh.texture ? shaders::BodyKind::textured : shaders::BodyKind::visual;
}

std::string with_lighting(const char* fragment) { return std::string(shaders::lighting) + fragment; }

// View matrix of the light. The choice of "up" does not matter, as long as it is not parallel to the light.
glm::mat4 light_view(const Vec3& to_light) {
    const Vec3 up = std::abs(to_light.y) < 0.9f ? Vec3(0.0f, 1.0f, 0.0f) : Vec3(1.0f, 0.0f, 0.0f);
    return glm::lookAt(Vec3(0.0f), -to_light, up);
}

bool is_empty(const ShapeInstances& shapes) {
    const auto has_none = [](const MeshInstances& group) { return group.instances.empty(); };
    return shapes.spheres.empty() && shapes.boxes.empty() && shapes.capsules.empty() && shapes.cylinders.empty() &&
           std::all_of(shapes.meshes.begin(), shapes.meshes.end(), has_none);
}

// Grid spacing as a power of ten, so that about ten of the finer lines cross the view.
float grid_spacing(float camera_distance) {
    return std::clamp(std::pow(10.0f, std::round(std::log10(camera_distance / 14.0f))), 0.01f, 10.0f);
}

// The shader programs of the body kinds, each compiled on first use.
class BodyPrograms {
  public:
    explicit BodyPrograms(std::string fragment) : fragment_(std::move(fragment)) {}
    const GlProgram& of(shaders::BodyKind kind) {
        std::optional<GlProgram>& program = programs_[std::size_t(kind)];
        const std::string constant = shaders::body_kind(kind);
        if (!program) program.emplace(shaders::desktop_header, constant + shaders::body_vertex, constant + fragment_);
        return *program;
    }

  private:
    std::string fragment_;
    std::array<std::optional<GlProgram>, shaders::body_kind_count> programs_;
};

} // namespace

struct GlRenderer::Impl {
    BodyPrograms body, shadow;
    GlProgram ground, sky;
    GlLines lines;
    RoundMeshes spheres, capsules, cylinders;
    std::unordered_map<const ShapeMesh*, LoadedMesh> meshes;
    GlTextures textures;
    std::vector<Instance> sorted;
    GlMesh boxes, rectangles, square;
    GlObject shadow_texture, shadow_framebuffer;
    GlTarget target;

    // State shared by the passes of one frame.
    glm::mat4 clip_from_world, shadow_from_world, shadow_clip_from_world;
    Vec3 eye{0.0f}, to_light{0.0f, 1.0f, 0.0f};
    float shadow_texel = 0.0f;
    OrbitCamera camera;

    Impl();
    void make_shadow_map();
    void prepare(const RenderFrame& frame, float aspect);
    void upload_instances(const ShapeInstances& shapes, int height, float aspect);
    void upload_meshes(const ShapeInstances& shapes);
    void upload_sorted(GlMesh& mesh, const std::vector<Instance>& instances);
    void sort_by_distance(std::vector<Instance>& instances) const;
    template <class Use> void draw_meshes(const ShapeInstances& shapes, const glm::mat4& clip, const Use& use);
    template <class Use> void draw_shapes(const ShapeInstances& shapes, const glm::mat4& clip, const Use& use);
    void draw_shadow_map(const RenderFrame& frame);
    void set_lighting(const GlProgram& program, const RenderFrame& frame) const;
    static void set_lamps(const GlProgram& program, const RenderFrame& frame);
    void draw_sky(const RenderFrame& frame, float aspect);
    void draw_bodies(const RenderFrame& frame);
    void draw_ghosts(const RenderFrame& frame, int height, float aspect);
    const GlProgram& use_body(shaders::BodyKind kind, const RenderFrame& frame, float opacity);
    void draw_grounds(const RenderFrame& frame);
};

GlRenderer::Impl::Impl()
    : body(with_lighting(shaders::body_fragment)), shadow(shaders::shadow_fragment),
      ground(shaders::desktop_header, shaders::ground_vertex, with_lighting(shaders::ground_fragment)),
      sky(shaders::desktop_header, shaders::sky_vertex, with_lighting(shaders::sky_fragment)),
      spheres([](const Detail& detail) { return GlMesh(cap_mesh(detail.segments, detail.rings / 3)); }),
      capsules([](const Detail& detail) { return GlMesh(capsule_mesh(detail.segments, detail.rings)); }),
      cylinders([](const Detail& detail) { return GlMesh(cylinder_mesh(detail.segments)); }), boxes(box_mesh()),
      rectangles(rectangle_mesh()), square(rectangle_mesh()) {
    make_shadow_map();
}

void GlRenderer::Impl::make_shadow_map() {
    shadow_texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, shadow_texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, shadow_size, shadow_size, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    shadow_framebuffer = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, shadow_texture.name(), 0);
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    glReadBuffer(GL_NONE);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorCode::unsupported, "shadow map", "", "must be supported by this graphics driver");
}

void GlRenderer::Impl::prepare(const RenderFrame& frame, float aspect) {
    camera.set_pose(frame.camera);
    eye = Vec3(camera.position() - frame.origin);
    to_light = glm::normalize(frame.lighting.to_sun);
    clip_from_world = camera.projection(aspect) * camera.view(frame.origin);

    const ShadowRegion region = shadow_region(frame);
    shadow_texel = 2.0f * region.radius / float(shadow_size);
    const glm::mat4 view = light_view(to_light);
    // Snaps the center to whole texels relative to the world origin, in double precision: the shadow map is stationary
    // in the world while the camera moves.
    const glm::dvec3 center(frame.origin + Position(region.center));
    const glm::dvec3 from_light = glm::dmat3(view) * center;
    const double texel = shadow_texel;
    const glm::dvec3 snapped(std::round(from_light.x / texel) * texel, std::round(from_light.y / texel) * texel,
                             from_light.z);
    const Vec3 middle(snapped - glm::dmat3(view) * frame.origin);
    const float r = region.radius, depth = 4.0f * region.radius;
    shadow_clip_from_world =
        glm::ortho(middle.x - r, middle.x + r, middle.y - r, middle.y + r, -middle.z - depth, -middle.z + depth) * view;
    const glm::mat4 half = glm::scale(glm::translate(glm::mat4(1.0f), Vec3(0.5f)), Vec3(0.5f));
    shadow_from_world = half * shadow_clip_from_world;
}

// Front to back, so that hidden fragments fail the depth test before they are shaded.
void GlRenderer::Impl::sort_by_distance(std::vector<Instance>& instances) const {
    const auto distance = [this](const Instance& instance) {
        const Vec3 offset = instance.position - eye;
        return camera.is_parallel() ? glm::dot(offset, camera.forward()) : glm::dot(offset, offset);
    };
    std::sort(instances.begin(), instances.end(),
              [&](const Instance& a, const Instance& b) { return distance(a) < distance(b); });
}

void GlRenderer::Impl::upload_sorted(GlMesh& mesh, const std::vector<Instance>& instances) {
    sorted = instances;
    sort_by_distance(sorted);
    mesh.upload(sorted.data(), sorted.size());
}

void GlRenderer::Impl::upload_instances(const ShapeInstances& shapes, int height, float aspect) {
    const float pixels_per_slope = 0.5f * float(height) / camera.half_height(aspect);
    const auto pixels_of = [&](const Instance& instance) {
        const float distance =
            camera.is_parallel() ? camera.distance() : std::max(glm::length(instance.position - eye), 1e-3f);
        return std::max(instance.half_size.x, instance.half_size.z) / distance * pixels_per_slope;
    };
    const auto sort = [this](std::vector<Instance>& instances) { sort_by_distance(instances); };
    spheres.upload(shapes.spheres, sort, pixels_of);
    capsules.upload(shapes.capsules, sort, pixels_of);
    cylinders.upload(shapes.cylinders, sort, pixels_of);
    upload_sorted(boxes, shapes.boxes);
    rectangles.upload(shapes.rectangles.data(), shapes.rectangles.size());
    upload_meshes(shapes);
}

// Uploads meshes that are not in GPU memory yet, and the instances of all.
void GlRenderer::Impl::upload_meshes(const ShapeInstances& shapes) {
    for (const MeshInstances& group : shapes.meshes) {
        if (group.instances.empty()) continue;
        auto place = meshes.find(group.mesh.get());
        if (place == meshes.end())
            place = meshes.emplace(group.mesh.get(), LoadedMesh{group.mesh, GlMesh(group.mesh->triangles)}).first;
        place->second.unused = 0;
        upload_sorted(place->second.mesh, group.instances);
    }
}

// `use(kind)` binds the program of a body kind, and returns it.
template <class Use>
void GlRenderer::Impl::draw_meshes(const ShapeInstances& shapes, const glm::mat4& clip, const Use& use) {
    const SidePlanes planes = side_planes(clip);
    for (const MeshInstances& group : shapes.meshes) {
        if (group.instances.empty()) continue;
        const shaders::BodyKind kind = kind_of(*group.mesh);
        const bool two_sided = kind != shaders::BodyKind::facets;
        textures.use(*group.mesh, use(kind));
        if (two_sided) glDisable(GL_CULL_FACE);
        const GlMesh& mesh = meshes.at(group.mesh.get()).mesh;
        if (group.mesh->parts.size() == 1)
            mesh.draw();
        else
            for (const IndexRange& range : visible_ranges(*group.mesh, group.instances, planes))
                mesh.draw(range.first, range.count);
        if (two_sided) glEnable(GL_CULL_FACE);
    }
}

template <class Use>
void GlRenderer::Impl::draw_shapes(const ShapeInstances& shapes, const glm::mat4& clip, const Use& use) {
    const auto draw = [&](shaders::BodyKind kind, bool any, const auto& mesh) {
        if (!any) return;
        use(kind);
        mesh.draw();
    };
    draw(shaders::BodyKind::sphere, !shapes.spheres.empty(), spheres);
    draw(shaders::BodyKind::capsule, !shapes.capsules.empty(), capsules);
    draw(shaders::BodyKind::cylinder, !shapes.cylinders.empty(), cylinders);
    draw(shaders::BodyKind::box, !shapes.boxes.empty(), boxes);
    draw_meshes(shapes, clip, use);
}

void GlRenderer::Impl::draw_shadow_map(const RenderFrame& frame) {
    glBindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer.name());
    glViewport(0, 0, shadow_size, shadow_size);
    glClear(GL_DEPTH_BUFFER_BIT);
    if (!frame.shadows) return;
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2.0f);
    glEnable(GL_DEPTH_CLAMP); // objects between the region and the light cast shadows too
    draw_shapes(frame, shadow_clip_from_world, [this](shaders::BodyKind kind) -> const GlProgram& {
        const GlProgram& program = shadow.of(kind);
        program.use();
        program.set("u_clip_from_world", shadow_clip_from_world);
        program.set("u_viewer", glm::vec4(to_light, 0.0f));
        return program;
    });
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void GlRenderer::Impl::set_lighting(const GlProgram& program, const RenderFrame& frame) const {
    program.use();
    program.set("u_clip_from_world", clip_from_world);
    program.set("u_eye", eye);
    program.set("u_viewer", camera.is_parallel() ? glm::vec4(-camera.forward(), 0.0f) : glm::vec4(eye, 1.0f));
    program.set("u_to_light", to_light);
    program.set("u_sun", frame.lighting.sun);
    set_lamps(program, frame);
    program.set("u_shadow_from_world", shadow_from_world);
    program.set("u_shadow_texel", shadow_texel);
    program.set("u_shadow_step", 1.0f / float(shadow_size));
    program.set("u_shadow_strength", frame.shadows ? 1.0f : 0.0f);
    program.set("u_shadow_rings", 2);
    program.set("u_shadow_map", 0);
    program.set("u_grid", frame.grid ? 1.0f : 0.0f);
}

void GlRenderer::Impl::set_lamps(const GlProgram& program, const RenderFrame& frame) {
    const std::vector<Lamp>& lamps = frame.lighting.lamps;
    const std::size_t count = std::min(lamps.size(), max_lamps);
    program.set("u_lamp_count", int(count));
    for (std::size_t i = 0; i < count; ++i) {
        const Light& light = lamps[i].light;
        const bool has_place = light.kind != Light::Kind::directional;
        const Vec3 place = has_place ? Vec3(light.position - frame.origin) : light.towards;
        float scale = 0.0f, offset = 1.0f; // linear map of the cosine of the angle to the spot's axis
        if (light.kind == Light::Kind::spot) {
            const float outer = std::cos(light.outer_cone);
            scale = 1.0f / std::max(std::cos(light.inner_cone) - outer, 1e-3f);
            offset = -outer * scale;
        }
        const auto set = [&](const char* name, const glm::vec4& value) {
            program.set((name + ("[" + std::to_string(i) + "]")).c_str(), value);
        };
        set("u_lamp_place", glm::vec4(place, has_place ? 1.0f : 0.0f));
        set("u_lamp_color", glm::vec4(lamps[i].color, light.range > 0.0f ? 1.0f / (light.range * light.range) : 0.0f));
        set("u_lamp_axis", glm::vec4(light.towards * scale, offset));
    }
}

void GlRenderer::Impl::draw_sky(const RenderFrame& frame, float aspect) {
    set_lighting(sky, frame);
    // Parallel rays all show one sky color.
    const float half_height = camera.is_parallel() ? 0.0f : camera.half_height(aspect);
    sky.set("u_ray_forward", camera.forward());
    sky.set("u_ray_right", camera.right() * (half_height * aspect));
    sky.set("u_ray_up", camera.up() * half_height);
    glDepthFunc(GL_LEQUAL); // the sky is drawn exactly at the far plane
    glDisable(GL_CULL_FACE);
    square.draw_once();
    glEnable(GL_CULL_FACE);
    glDepthFunc(GL_LESS);
}

const GlProgram& GlRenderer::Impl::use_body(shaders::BodyKind kind, const RenderFrame& frame, float opacity) {
    const GlProgram& program = body.of(kind);
    set_lighting(program, frame);
    program.set("u_spacing", grid_spacing(lens_of(camera.pose()) * camera.distance()));
    program.set("u_fade", fade_distances * camera.distance());
    program.set("u_opacity", opacity);
    return program;
}

void GlRenderer::Impl::draw_bodies(const RenderFrame& frame) {
    draw_shapes(frame, clip_from_world,
                [&](shaders::BodyKind kind) -> const GlProgram& { return use_body(kind, frame, 1.0f); });
    if (frame.rectangles.empty()) return;
    use_body(shaders::BodyKind::rectangle, frame, 1.0f);
    rectangles.draw();
}

// Draws ghosts after everything opaque, because they are blended with it. A depth-only pass comes first, so that only
// the front faces of the nearest ghost are blended.
void GlRenderer::Impl::draw_ghosts(const RenderFrame& frame, int height, float aspect) {
    upload_instances(frame.ghosts, height, aspect);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    const auto draw = [&] {
        draw_shapes(frame.ghosts, clip_from_world,
                    [&](shaders::BodyKind kind) -> const GlProgram& { return use_body(kind, frame, ghost_opacity); });
    };
    draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    // A constant, because the alpha channel holds brightness for the edge smoothing.
    glBlendColor(0.0f, 0.0f, 0.0f, ghost_opacity);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    draw();
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
}

void GlRenderer::Impl::draw_grounds(const RenderFrame& frame) {
    if (frame.grounds.empty()) return;
    set_lighting(ground, frame);
    const float distance = camera.distance();
    const float fade = fade_distances * distance;
    ground.set("u_spacing", grid_spacing(lens_of(camera.pose()) * distance));
    ground.set("u_fade", fade);
    ground.set("u_extent", extent_fades * fade);
    for (const GroundPlane& plane : frame.grounds) {
        const Vec3 normal = plane.rotation * Vec3(0.0f, 1.0f, 0.0f);
        ground.set("u_center", eye - normal * glm::dot(eye - plane.position, normal));
        ground.set("u_normal", normal);
        ground.set("u_axis_x", plane.rotation * Vec3(1.0f, 0.0f, 0.0f));
        ground.set("u_axis_z", plane.rotation * Vec3(0.0f, 0.0f, 1.0f));
        ground.set("u_point", plane.position);
        ground.set("u_grid_offset", plane.grid_offset);
        ground.set("u_ground_color", plane.color);
        square.draw_once();
    }
}

GlRenderer::GlRenderer() {
    if (epoxy_gl_version() < 33 || !epoxy_is_desktop_gl())
        throw Error(ErrorCode::unsupported, "OpenGL version", std::to_string(epoxy_gl_version()),
                    "must be at least 33 (OpenGL 3.3)");
    impl_ = std::make_unique<Impl>();
}

GlRenderer::~GlRenderer() = default;

bool GlRenderer::is_software() const {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view name = text != nullptr ? text : "";
    for (const char* drawer : {"llvmpipe", "softpipe", "SWR", "SwiftShader"})
        if (name.find(drawer) != std::string_view::npos) return true;
    return false;
}

void GlRenderer::draw(const RenderFrame& frame, const PicturePlace& place, Smoothing smoothing, float scale) {
    Impl& impl = *impl_;
    const float aspect = float(place.width) / float(place.height);
    if (smoothing == Smoothing::samples) scale = 1.0f;
    const int width = std::max(int(std::round(scale * float(place.width))), 1);
    const int height = std::max(int(std::round(scale * float(place.height))), 1);
    impl.prepare(frame, aspect);
    for (auto& [source, loaded] : impl.meshes) ++loaded.unused;
    std::erase_if(impl.meshes, [](const auto& item) { return item.second.unused > most_unused; });
    impl.textures.give_up_unused(most_unused);
    impl.upload_instances(frame, height, aspect);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    impl.draw_shadow_map(frame);

    impl.target.begin(width, height, smoothing);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, impl.shadow_texture.name());
    impl.draw_bodies(frame);
    impl.draw_grounds(frame);
    impl.draw_sky(frame, aspect); // last, where the depth buffer is still empty
    if (!is_empty(frame.ghosts)) impl.draw_ghosts(frame, height, aspect);
    impl.lines.draw(frame, impl.clip_from_world);
    impl.lines.draw_marks(frame, impl.clip_from_world, impl.camera, width, height);

    impl.target.finish(place);
    glBindVertexArray(0);
}

} // namespace cairn::viewer
