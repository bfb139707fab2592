// Links of SDF files: collisions, visuals and masses.
#include "scene/mass_sum.h"
#include "scene/sdf_model.h"
#include "scene/tessellation.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

struct LinkSolid {
    std::optional<Shape> shape;
    Rigid turn;                             // pose of the shape in the frame of its geometry
    std::shared_ptr<const Surface> surface; // of a mesh
    bool is_cut = false;                    // decomposed into convex parts
};

// The format's default for a missing size, m.
constexpr double left_out_length = 1.0;

class LinkReader {
  public:
    LinkReader(std::size_t link, const std::optional<std::filesystem::path>& root, ModelMeshes& meshes, SdfModel& model)
        : link_(model.links[link]), root_(root), meshes_(meshes), model_(model) {}

    void read(const XmlElement& element) {
        const auto inertial = element.child("inertial");
        const auto automatic = inertial ? inertial->attribute("auto") : std::nullopt;
        const bool from_shapes = automatic && automatic->boolean();
        if (!from_shapes) read_inertial(element, inertial);
        for (const XmlElement& collision : element.children("collision")) add_collision(collision, from_shapes);
        if (from_shapes && link_.body.masses.empty() && !link_.is_static) {
            inertial->fail("must have collisions with a volume, where auto is true");
        }
        bool all_shown = true;
        for (const XmlElement& visual : element.children("visual")) all_shown = add_visual(visual) && all_shown;
        // An incomplete set of visuals would hide the shapes of the others.
        if (!all_shown && !link_.body.shapes.empty()) link_.body.looks.clear();
        if (const auto gravity = element.child_text("gravity"))
            link_.body.gravity_scale = gravity->boolean() ? 1.0 : 0.0;
        if (const auto kinematic = element.child_text("kinematic")) link_.is_kinematic = kinematic->boolean();
        if (const auto decay = element.child("velocity_decay")) {
            if (const auto text = decay->child_text("linear")) link_.body.linear_damping = text->number(0.0, 1e6);
            if (const auto text = decay->child_text("angular")) link_.body.angular_damping = text->number(0.0, 1e6);
        }
    }

  private:
    // Returns the pose of an element in the frame of the link; the element's pose may be relative to another frame.
    Rigid place_of(const XmlElement& element) const {
        const SdfPose pose = read_sdf_pose(element);
        if (!pose.relative_to) return pose.pose;
        const Rigid base = model_.world(model_.find(link_.scope, *pose.relative_to));
        return inverse(model_.world(link_.frame)) * base * pose.pose;
    }

    // Reads the inertial; the format's defaults are 1 kg, and 1 kg m2 about every axis.
    void read_inertial(const XmlElement& element, const std::optional<XmlElement>& inertial) {
        double mass = 1.0;
        glm::dmat3 inertia(1.0);
        Rigid at;
        if (inertial) {
            at = place_of(*inertial);
            if (const auto text = inertial->child_text("mass")) mass = text->number(0.0, 1e12);
            if (const auto tensor = inertial->child("inertia")) {
                const auto entry = [&](const char* name, double otherwise) {
                    const auto text = tensor->child_text(name);
                    return text ? text->number(-1e15, 1e15) : otherwise;
                };
                const double xx = entry("ixx", 1), yy = entry("iyy", 1), zz = entry("izz", 1), xy = entry("ixy", 0),
                             xz = entry("ixz", 0), yz = entry("iyz", 0);
                inertia = glm::dmat3(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            }
        }
        if (link_.is_static) return;
        const std::string place = inertial ? inertial->place() : element.place();
        if (mass == 0.0) inertial->fail("must have a mass > 0");
        inertia = valid_inertia(inertia, link_.place + ": inertial", model_.warnings);
        link_.body.masses.push_back({mass, inertia, at});
    }

    void add_collision(const XmlElement& collision, bool has_mass) {
        const Rigid at = place_of(collision);
        const std::string place = collision.place();
        const auto geometry = collision.child("geometry");
        if (!geometry) collision.fail("must have the element geometry");
        LinkSolid solid;
        try {
            solid = read_geometry(*geometry, link_.is_static);
        } catch (const Error& error) {
            const bool is_missing = error.code() == ErrorCode::io || error.code() == ErrorCode::unsupported;
            if (!is_missing || has_mass) throw;
            model_.warnings.push_back(std::string(error.what()) + " (the collision is left out)");
            return;
        }
        if (!solid.shape) return; // an empty geometry
        ModelShape shape{*solid.shape, at * solid.turn, {}, material_of(collision), {}, {}, std::nullopt, place};
        if (solid.is_cut) shape.parts = model_.surface_parts.of(solid.surface);
        unsigned bitmask = 0xFFFF;
        if (const auto surface = collision.child("surface")) {
            if (const auto contact = surface->child("contact")) bitmask = bitmask_of(*contact);
        }
        if (has_mass) {
            const auto density = collision.child_text("density");
            const double unit = density ? density->number(1e-9, 1e12) : 1000.0;
            const std::optional<SolidMass> enclosed = solid.surface ? surface_mass(*solid.surface, unit) : std::nullopt;
            const SolidMass mass = enclosed ? *enclosed : shape_mass(*solid.shape, unit);
            const Rigid frame = enclosed ? at : shape.at;
            if (mass.mass > 0.0) {
                link_.body.masses.push_back({mass.mass, mass.inertia, frame * Rigid{mass.center, {1, 0, 0, 0}}});
            }
        }
        link_.body.shapes.push_back(std::move(shape));
        link_.bitmasks.push_back(bitmask);
    }

    static unsigned bitmask_of(const XmlElement& contact) {
        const auto text = contact.child_text("collide_bitmask");
        if (!text) return 0xFFFF;
        if (text->text.substr(0, 2) != "0x") return static_cast<unsigned>(text->whole(0, 0xFFFF));
        unsigned value = 0;
        for (const char c : text->text.substr(2)) {
            const std::size_t digit =
                std::string_view("0123456789abcdef").find(c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c);
            if (digit == std::string_view::npos || value > 0xFFF) text->fail("must be a number of 16 bits");
            value = value * 16 + static_cast<unsigned>(digit);
        }
        return value;
    }

    double length_of(const XmlElement& element, const char* name) {
        const auto text = element.child_text(name);
        if (text) return text->number(1e-6, 1e6);
        model_.warnings.push_back(element.place() + ": has no " + name + ", for which the format says 1");
        return left_out_length;
    }

    glm::dvec3 sizes_of(const XmlElement& element, const char* name) {
        const auto text = element.child_text(name);
        if (!text) return glm::dvec3(length_of(element, name));
        const glm::dvec3 size = text->vector3();
        for (int i = 0; i < 3; ++i) {
            if (!(size[i] >= 1e-6 && size[i] <= 1e6)) text->fail("must have sizes from 0.000001 to 1000000");
        }
        return size;
    }

    static Material material_of(const XmlElement& collision) {
        Material material;
        material.static_friction = material.dynamic_friction = 1.0f;
        material.friction_combine = material.restitution_combine = CombineRule::minimum; // as ODE does in Gazebo
        const auto surface = collision.child("surface");
        if (!surface) return material;
        if (const auto friction = surface->child("friction")) {
            std::optional<double> first, second;
            const auto note = [](const std::optional<XmlText>& text, std::optional<double>& value) {
                if (text) value = text->number(0.0, 1e30);
            };
            for (const char* engine : {"ode", "bullet"}) {
                const auto own = friction->child(engine);
                if (!own || first) continue;
                note(own->child_text(engine[0] == 'o' ? "mu" : "friction"), first);
                note(own->child_text(engine[0] == 'o' ? "mu2" : "friction2"), second);
            }
            if (first) {
                const double mean = second ? std::min(*first, *second) : *first;
                material.static_friction = material.dynamic_friction = static_cast<float>(std::min(mean, 1e6));
            }
            if (const auto twist = friction->child("torsional")) {
                if (const auto radius = twist->child_text("patch_radius")) {
                    material.torsional_friction = static_cast<float>(radius->number(0.0, 1e6));
                }
            }
        }
        if (const auto bounce = surface->child("bounce")) {
            if (const auto text = bounce->child_text("restitution_coefficient")) {
                material.restitution = static_cast<float>(text->number(0.0, 1.0));
            }
        }
        return material;
    }

    bool add_visual(const XmlElement& visual) {
        const auto geometry = visual.child("geometry");
        if (!geometry) return true;
        try {
            const LinkSolid solid = read_geometry(*geometry, true);
            if (!solid.shape && !solid.surface) return true;
            const Rigid at = place_of(visual) * (solid.surface ? Rigid() : solid.turn);
            std::vector<MeshVisual> parts;
            if (const auto mesh = geometry->child("mesh")) {
                const MeshRequest asked = request(*mesh);
                parts = meshes_.looks(asked.uri, asked.path, "", asked.scale, model_.warnings);
            } else {
                const auto own =
                    solid.surface ? solid.surface : std::make_shared<const Surface>(tessellate(*solid.shape));
                parts.push_back({own, std::nullopt, nullptr});
            }
            const auto material = visual.child("material");
            const std::shared_ptr<const Texture> texture = material ? texture_of(*material) : nullptr;
            for (const MeshVisual& part : parts) {
                ModelVisual look{part.surface, at, part.color.value_or(Vec3(1.0f)), part.texture};
                if (material) { // it overrides the materials of the file
                    look.texture = part.surface->coordinates.empty() ? nullptr : texture;
                    look.color = color_of(*material, look.texture != nullptr);
                }
                link_.body.looks.push_back(std::move(look));
            }
            return true;
        } catch (const Error& error) { // visuals do not affect the simulation
            model_.warnings.push_back(std::string(error.what()) + " (it is not shown)");
            return false;
        }
    }

    // Returns the texture of the base color; null if there is none, or if it cannot be shown, with a warning.
    std::shared_ptr<const Texture> texture_of(const XmlElement& material) {
        const auto pbr = material.child("pbr");
        const auto metal = pbr ? pbr->child("metal") : std::nullopt;
        const auto specular = pbr && !metal ? pbr->child("specular") : std::nullopt;
        const auto& workflow = metal ? metal : specular;
        const auto map = workflow ? workflow->child_text("albedo_map") : std::nullopt;
        if (!map || map->text.empty()) return nullptr;
        try {
            Texture made;
            made.file = meshes_.picture(*map, path_of(*map), "");
            return std::make_shared<const Texture>(std::move(made));
        } catch (const Error& error) { // visuals do not affect the simulation
            model_.warnings.push_back(std::string(error.what()) + " (the texture is left out)");
            return nullptr;
        }
    }

    static Vec3 color_of(const XmlElement& material, bool is_covered) {
        auto text = material.child_text("diffuse");
        if (!text) text = material.child_text("ambient");
        if (!text) return Vec3(is_covered ? 1.0f : 0.7f);
        const std::vector<double> rgb = text->numbers(3, 4);
        const auto part = [&](std::size_t i) { return static_cast<float>(std::clamp(rgb[i], 0.0, 1.0)); };
        return {part(0), part(1), part(2)};
    }

    LinkSolid read_geometry(const XmlElement& geometry, bool as_surface) {
        for (const char* kind :
             {"box", "sphere", "cylinder", "capsule", "cone", "ellipsoid", "plane", "mesh", "empty"}) {
            const auto found = geometry.child(kind);
            if (!found) continue;
            try {
                return read_kind(*found, kind, as_surface);
            } catch (const Error& error) {
                if (error.code() != ErrorCode::invalid_value) throw; // not an error of a shape
                throw Error(ErrorCode::invalid_file, found->place(), {}, error.what());
            }
        }
        const std::vector<XmlElement> children = geometry.children();
        if (children.empty()) return {};
        throw Error(ErrorCode::unsupported, children[0].place(), {},
                    "must be a box, sphere, cylinder, capsule, cone, ellipsoid, plane or mesh");
    }

    LinkSolid read_kind(const XmlElement& element, std::string_view kind, bool as_surface) {
        const auto f = [](double value) { return static_cast<float>(value); };
        if (kind == "empty") return {};
        if (kind == "box") return {Box{0.5f * Vec3(sizes_of(element, "size"))}, {}, nullptr, false};
        if (kind == "sphere") return {Sphere{f(length_of(element, "radius"))}, {}, nullptr, false};
        if (kind == "ellipsoid") {
            LinkSolid solid;
            solid.surface = std::make_shared<const Surface>(ellipsoid_surface(sizes_of(element, "radii")));
            solid.shape = Hull(solid.surface->vertices);
            return solid;
        }
        if (kind == "plane") return plane(element);
        if (kind == "mesh") return mesh(element, as_surface);
        const float radius = f(length_of(element, "radius")), half = f(0.5 * length_of(element, "length"));
        if (kind == "capsule") return {Capsule{half, radius, std::nullopt}, y_to_z, nullptr, false};
        if (kind == "cone") return {cone(radius, half), y_to_z, nullptr, false};
        return {Cylinder{half, radius, std::nullopt}, y_to_z, nullptr, false};
    }

    // Planes are infinite for collision; only their visuals have a size.
    static LinkSolid plane(const XmlElement& element) {
        Plane plane;
        plane.normal = {0.0f, 0.0f, 1.0f};
        if (const auto text = element.child_text("normal")) {
            const glm::dvec3 normal = text->vector3();
            if (!(glm::dot(normal, normal) > 1e-12)) text->fail("must not be zero");
            plane.normal = Vec3(glm::normalize(normal));
        }
        element.child("size");
        return {plane, {}, nullptr, false};
    }

    // Returns the path that a URI refers to, relative to the model's folder.
    std::string path_of(const XmlText& uri) const {
        if (!root_) {
            throw Error(ErrorCode::unsupported, uri.place, "\"" + printable(uri.text, 200) + "\"",
                        "other files cannot be read by a model that comes from memory");
        }
        const std::string path = sdf_path(uri.text, model_.scopes[link_.scope].folder, *root_);
        if (path.empty()) {
            throw Error(ErrorCode::unsupported, uri.place, "\"" + printable(uri.text, 200) + "\"",
                        "must name a file on this disk");
        }
        return path;
    }

    // The attributes of a `mesh` element.
    struct MeshRequest {
        XmlText uri;
        std::string path;
        glm::dvec3 scale;
    };
    MeshRequest request(const XmlElement& mesh) const {
        const auto uri = mesh.child_text("uri");
        if (!uri) mesh.fail("must have the element uri");
        const auto scale = mesh.child_text("scale");
        return {*uri, path_of(*uri), scale ? scale->vector3() : glm::dvec3(1.0)};
    }

    LinkSolid mesh(const XmlElement& element, bool as_surface) {
        const MeshRequest asked = request(element);
        LinkSolid solid;
        solid.surface = meshes_.load(asked.uri, asked.path, "", asked.scale);
        const std::string way = element.text_of("optimization");
        solid.is_cut = !as_surface && (way == "convex_decomposition" || (way.empty() && model_.decomposes));
        try {
            if (as_surface) {
                solid.shape = Mesh(solid.surface->vertices, solid.surface->indices);
            } else {
                solid.shape = Hull(used_vertices(*solid.surface));
            }
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, element.place(), {}, error.what());
        }
        return solid;
    }

    SdfLink& link_;
    const std::optional<std::filesystem::path>& root_;
    ModelMeshes& meshes_;
    SdfModel& model_;
};

} // namespace

void read_sdf_link(const XmlElement& element, std::size_t link, const std::optional<std::filesystem::path>& root,
                   ModelMeshes& meshes, SdfModel& model) {
    LinkReader(link, root, meshes, model).read(element);
}

} // namespace cairn::scene
