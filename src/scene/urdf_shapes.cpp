#include "scene/urdf_shapes.h"

#include "scene/model_meshes.h"
#include "scene/tessellation.h"
#include "scene/urdf_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cairn::scene {

namespace {

std::string text_of(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (!text.empty() && text.back() == '.') text.pop_back();
    return text;
}

float size(double value, const std::string& place, const char* attribute) {
    if (!(value > 0.0 && value <= 1e6)) {
        throw Error(ErrorCode::invalid_file, place + ": " + attribute, text_of(value),
                    "must be > 0, and at most 1000000");
    }
    return static_cast<float>(value);
}

std::optional<Vec3> color_of(const urdf::Visual& visual) {
    if (!visual.material) return std::nullopt;
    const urdf::Color& c = visual.material->color;
    const bool has_none = c.r == 0.0f && c.g == 0.0f && c.b == 0.0f && !visual.material->texture_filename.empty();
    // Black would hide the texture, and is not meant to multiply it.
    if (has_none) return Vec3(1.0f);
    const auto part = [](float v) { return v > 0.0f ? std::min(v, 1.0f) : 0.0f; };
    return Vec3(part(c.r), part(c.g), part(c.b));
}

glm::dvec3 scale_of(const urdf::Mesh& mesh, const std::string& place) {
    const glm::dvec3 scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
    for (int i = 0; i < 3; ++i) {
        if (!(std::fabs(scale[i]) <= 1e6) || scale[i] == 0.0) {
            throw Error(ErrorCode::invalid_file, place + ": mesh scale", text_of(scale[i]),
                        "must not be 0, and finite");
        }
    }
    return scale;
}

} // namespace

Rigid rigid(const urdf::Pose& pose, const std::string& place) {
    const Rigid result{{pose.position.x, pose.position.y, pose.position.z},
                       {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z}};
    for (int i = 0; i < 3; ++i) {
        if (!(std::fabs(result.position[i]) <= 1e6)) {
            throw Error(ErrorCode::invalid_file, place + ": origin xyz", text_of(result.position[i]),
                        "must be within 1000000 m");
        }
    }
    const double length = glm::dot(result.rotation, result.rotation);
    if (!(length > 0.5 && length < 2.0)) {
        throw Error(ErrorCode::invalid_file, place + ": origin rpy", {}, "must be three angles");
    }
    return result;
}

RobotShapes::Turned RobotShapes::shape(const urdf::Geometry& geometry, const std::string& place, bool is_static) {
    switch (geometry.type) {
    case urdf::Geometry::SPHERE:
        return {Sphere{size(static_cast<const urdf::Sphere&>(geometry).radius, place, "sphere radius")}};
    case urdf::Geometry::BOX: {
        const urdf::Vector3& dim = static_cast<const urdf::Box&>(geometry).dim;
        return {Box{0.5f * Vec3(size(dim.x, place, "box size"), size(dim.y, place, "box size"),
                                size(dim.z, place, "box size"))}};
    }
    case urdf::Geometry::CYLINDER: { // URDF cylinders are along z, the engine's along y
        const auto& column = static_cast<const urdf::Cylinder&>(geometry);
        return {Cylinder{0.5f * size(column.length, place, "cylinder length"),
                         size(column.radius, place, "cylinder radius"), std::nullopt},
                y_to_z.rotation};
    }
    case urdf::Geometry::MESH: {
        const std::shared_ptr<const Surface> surface = triangles(static_cast<const urdf::Mesh&>(geometry), place);
        try {
            if (is_static) return {Mesh(surface->vertices, surface->indices)};
            Turned made{Hull(used_vertices(*surface))};
            if (decomposes_) made.parts = surface_parts_.of(surface);
            return made;
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, place, {}, error.what());
        }
    }
    }
    throw Error(ErrorCode::unsupported, place, {}, "must be a box, a cylinder, a sphere or a mesh");
}

NamedFile RobotShapes::file_of(const std::string& filename, const std::string& place) {
    const std::string name = without_spare_slashes(filename);
    if (name != filename && !has_warned_of_slashes_) {
        scene_.warnings.push_back(place + ": \"" + filename.substr(0, 200) +
                                  "\" has slashes in place of the name of its package; it is read as \"" +
                                  name.substr(0, 200) + "\", and so are all other file names");
        has_warned_of_slashes_ = true;
    }
    return find_robot_file(name, folder_, place);
}

std::shared_ptr<const Surface> RobotShapes::triangles(const urdf::Mesh& mesh, const std::string& place) {
    return meshes_.surface(file_of(mesh.filename, place + ": mesh filename"), scale_of(mesh, place));
}

std::optional<RobotShapes::Turned> RobotShapes::collision_shape(const urdf::Collision& collision,
                                                                const std::string& place, bool is_static,
                                                                bool may_lack) {
    try {
        return shape(*collision.geometry, place, is_static);
    } catch (const Error& error) {
        if (!may_lack || (error.code() != ErrorCode::io && error.code() != ErrorCode::unsupported)) throw;
        scene_.warnings.push_back(std::string(error.what()) + " (the shape is left out)");
        return std::nullopt;
    }
}

void RobotShapes::add_shapes(const urdf::Link& link, BodyId body, const Rigid& at, bool may_lack) {
    const bool is_static = scene_.world.body(body).type() == BodyType::static_;
    std::optional<Vec3> color;
    for (const auto& visual : link.visual_array) {
        if (!color) color = color_of(*visual);
    }
    for (std::size_t i = 0; i < link.collision_array.size(); ++i) {
        const urdf::Collision& collision = *link.collision_array[i];
        const std::string place = name_ + ": link \"" + link.name + "\": collision " + std::to_string(i + 1);
        const std::optional<Turned> made = collision_shape(collision, place, is_static, may_lack);
        if (!made) continue;
        Rigid local = at * rigid(collision.origin, place);
        local.rotation = local.rotation * made->rotation;
        ShapeDef def;
        def.position = Vec3(local.position);
        def.rotation = Quat(glm::normalize(local.rotation));
        try {
            const auto add = [&](const Shape& shape) {
                const ShapeId id = scene_.world.add_shape(body, shape, def);
                if (color) scene_.appearances.push_back({body, id, *color});
            };
            if (made->parts.empty()) add(made->shape);
            for (const Hull& part : made->parts) add(part);
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, place, {}, error.what());
        }
    }
}

std::vector<MeshVisual> RobotShapes::looks(const urdf::Geometry& geometry, const std::string& place, Rigid& local) {
    if (geometry.type != urdf::Geometry::MESH) {
        const Turned made = shape(geometry, place, true);
        local.rotation = glm::normalize(local.rotation * made.rotation);
        return {{std::make_shared<const Surface>(tessellate(made.shape)), std::nullopt, nullptr}};
    }
    const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
    return meshes_.looks(file_of(mesh.filename, place + ": mesh filename"), scale_of(mesh, place), scene_.warnings);
}

std::shared_ptr<const Texture> RobotShapes::texture_of(const urdf::Visual& visual, const std::string& place) {
    if (!visual.material || visual.material->texture_filename.empty()) return nullptr;
    const std::string where = place + ": material \"" + visual.material->name.substr(0, 100) + "\": texture filename";
    try {
        const NamedFile file = file_of(visual.material->texture_filename, where);
        Texture made;
        made.file = meshes_.pictures().read(file.path, where, file.shown);
        return std::make_shared<const Texture>(std::move(made));
    } catch (const Error& error) { // visuals do not affect the simulation
        const std::string line = std::string(error.what()) + " (the texture is left out)";
        scene_.warnings.push_back(line);
        return nullptr;
    }
}

bool RobotShapes::add_visuals(const urdf::Link& link, BodyId body, const Rigid& at) {
    bool all_shown = true;
    for (std::size_t i = 0; i < link.visual_array.size(); ++i) {
        const urdf::Visual& visual = *link.visual_array[i];
        const std::string place = name_ + ": link \"" + link.name + "\": visual " + std::to_string(i + 1);
        try {
            Rigid local = at * rigid(visual.origin, place);
            const std::vector<MeshVisual> parts = looks(*visual.geometry, place, local);
            const std::optional<Vec3> color = color_of(visual);
            const std::shared_ptr<const Texture> texture = texture_of(visual, place);
            for (const MeshVisual& part : parts) {
                VisualMesh made;
                made.body = body;
                made.surface = part.surface;
                made.local = local.transform();
                if (color || part.color) made.color = color ? *color : *part.color;
                if (visual.material) // it overrides the materials of the file
                    made.texture = part.surface->coordinates.empty() ? nullptr : texture;
                else
                    made.texture = part.texture;
                scene_.visuals.push_back(std::move(made));
            }
        } catch (const Error& error) { // visuals do not affect the simulation
            scene_.warnings.push_back(std::string(error.what()) + " (it is not shown)");
            all_shown = false;
        }
    }
    return all_shown;
}

} // namespace cairn::scene
