// Geoms of MJCF models: shapes, visuals and masses.
#include "scene/mjcf_model.h"
#include "scene/tessellation.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr double smallest = 1e-6, largest = 1e6; // m
constexpr long last_seen_group = 2;              // the highest geom group that the viewer of MuJoCo shows by default

struct GeomSolid {
    std::optional<Shape> shape;
    Rigid turn;                             // pose of the shape in the frame of the geom
    std::shared_ptr<const Surface> surface; // of a mesh or an ellipsoid
    bool is_mesh = false;
    std::optional<SolidMass> mass; // in the frame of the geom, at 1 kg/m3; none: computed from the shape
};

// Returns the sizes of a geom, all of which must be > 0.
std::vector<double> sizes(const MjcfElement& element, std::size_t count) {
    const auto text = element.attribute("size");
    if (!text) element.fail("must have the attribute size");
    std::vector<double> values = text->numbers(1, 3);
    if (values.size() < count) text->fail("must have " + std::to_string(count) + " sizes");
    for (std::size_t i = 0; i < count; ++i) {
        if (!(values[i] >= smallest && values[i] <= largest)) text->fail("must have sizes from 0.000001 to 1000000");
    }
    return values;
}

class GeomReader {
  public:
    GeomReader(const MjcfElement& element, MjcfAssets& assets) : element_(element), assets_(assets) {}

    // Returns the shape of the geom. `frame` receives the pose of the geom relative to its parent element.
    GeomSolid read(Rigid& frame, const MjcfSettings& settings) {
        const auto type_text = element_.attribute("type");
        const std::size_t type = type_text ? type_text->choice({"sphere", "plane", "hfield", "capsule", "ellipsoid",
                                                                "cylinder", "box", "mesh", "sdf"})
                                           : 0;
        frame = mjcf_frame(element_, settings);
        const auto ends = element_.attribute("fromto");
        if (ends && type >= 3 && type <= 6) half_length_ = stretch(*ends, frame);
        const auto mesh = element_.attribute("mesh");
        if (mesh && type != 7 && type < 8) return fitted(*mesh);
        switch (type) {
        case 0:
            return {Sphere{static_cast<float>(sizes(element_, 1)[0])}, {}, nullptr, false, std::nullopt};
        case 1:
            return {Plane{.normal = {0.0f, 0.0f, 1.0f}}, {}, nullptr, false, std::nullopt};
        case 2: {
            const auto name = element_.attribute("hfield");
            if (!name) element_.fail("must have the attribute hfield");
            return {assets_.height_field(*name), y_to_z, nullptr, false, std::nullopt};
        }
        case 3:
        case 5: {
            const std::vector<double> size = sizes(element_, half_length_ ? 1 : 2);
            const float radius = static_cast<float>(size[0]),
                        half = static_cast<float>(half_length_ ? *half_length_ : size[1]);
            if (type == 3) return {Capsule{half, radius, std::nullopt}, y_to_z, nullptr, false, std::nullopt};
            return {Cylinder{half, radius, std::nullopt}, y_to_z, nullptr, false, std::nullopt};
        }
        case 4:
            return ellipsoid(three_sizes());
        case 6:
            return {Box{Vec3(three_sizes())}, {}, nullptr, false, std::nullopt};
        case 7:
            if (!mesh) element_.fail("must have the attribute mesh");
            return hull(*mesh);
        default:
            throw Error(ErrorCode::unsupported, element_.place(), "\"sdf\"", "must be of another type than sdf");
        }
    }

  private:
    // Centers the frame between both ends, with its z axis along them. Returns half the length.
    double stretch(const XmlText& text, Rigid& frame) const {
        const std::vector<double> v = text.numbers(6, 6);
        const glm::dvec3 from(v[0], v[1], v[2]), to(v[3], v[4], v[5]);
        const double length = std::sqrt(glm::dot(to - from, to - from));
        if (!(length >= smallest && length <= largest)) text.fail("must have two different points");
        const glm::dvec3 z = (from - to) / length;
        frame.position = 0.5 * (from + to);
        frame.rotation =
            z.z < -0.999999 ? glm::dquat(0.0, 1.0, 0.0, 0.0) : glm::normalize(glm::dquat(1.0 + z.z, -z.y, z.x, 0.0));
        return 0.5 * length;
    }

    glm::dvec3 three_sizes() const {
        if (!half_length_) {
            const std::vector<double> size = sizes(element_, 3);
            return {size[0], size[1], size[2]};
        }
        const std::vector<double> size = sizes(element_, 1);
        const bool has_second = size.size() > 1 && size[1] >= smallest && size[1] <= largest;
        return {size[0], has_second ? size[1] : size[0], *half_length_};
    }

    static GeomSolid ellipsoid(const glm::dvec3& a) {
        GeomSolid solid;
        if (a.x == a.y && a.y == a.z) {
            solid.shape = Sphere{static_cast<float>(a.x)};
            return solid;
        }
        solid.surface = std::make_shared<const Surface>(ellipsoid_surface(a));
        solid.shape = Hull(solid.surface->vertices);
        const double mass = 4.0 / 3.0 * 3.14159265358979323846 * a.x * a.y * a.z;
        const glm::dvec3 s = a * a;
        solid.mass = SolidMass{mass, 0.2 * mass * glm::dmat3(s.y + s.z, 0, 0, 0, s.x + s.z, 0, 0, 0, s.x + s.y), {}};
        return solid;
    }

    // A mesh collides as its convex hull, as in MuJoCo.
    GeomSolid hull(const XmlText& name) const {
        GeomSolid solid;
        solid.surface = assets_.mesh(name);
        solid.is_mesh = true;
        try {
            solid.shape = Hull(used_vertices(*solid.surface));
        } catch (const Error&) { // a flat mesh is a visual only
            return solid;
        }
        solid.mass = surface_mass(*solid.surface, 1.0);
        return solid;
    }

    // MuJoCo would fit a primitive to the mesh; the hull of the mesh itself is used instead.
    GeomSolid fitted(const XmlText& name) const {
        GeomSolid solid = hull(name);
        was_fitted = true;
        return solid;
    }

    const MjcfElement& element_;
    MjcfAssets& assets_;
    std::optional<double> half_length_;

  public:
    mutable bool was_fitted = false;
};

Material geom_material(const MjcfElement& element) {
    Material material;
    std::vector<double> friction{1.0};
    if (const auto text = element.attribute("friction")) {
        friction = text->numbers(1, 3);
        for (const double f : friction) {
            if (!(f >= 0.0 && f <= 1e6)) text->fail("must have coefficients from 0 to 1000000");
        }
    }
    if (friction.size() < 2) friction.push_back(0.005);
    if (friction.size() < 3) friction.push_back(0.0001);
    const auto dimension = element.attribute("condim");
    const long directions = dimension ? dimension->whole(1, 6) : 3;
    const bool slides = directions == 1;
    material.static_friction = material.dynamic_friction = slides ? 0.0f : static_cast<float>(friction[0]);
    // The engine's value is the radius of a patch on which friction acts; MJCF's is that radius times the friction.
    material.torsional_friction =
        directions >= 4 && friction[0] > 0.0 ? static_cast<float>(friction[1] / friction[0]) : 0.0f;
    material.rolling_friction = directions >= 6 ? static_cast<float>(friction[2]) : 0.0f;
    material.friction_combine = CombineRule::maximum;
    return material;
}

// Returns the geom's own color, if it is not the default one; else that of its material, which is white by default.
std::vector<double> geom_rgba(const MjcfElement& element, const std::optional<MjcfMaterial>& material) {
    const std::vector<double> gray{0.5, 0.5, 0.5, 1.0}, white(4, 1.0);
    const auto text = element.attribute("rgba");
    const std::vector<double> own = text ? text->numbers(4, 4) : gray;
    if (!material || own != gray) return own;
    return material->color ? material->color->numbers(4, 4) : white;
}

Vec3 geom_color(const std::vector<double>& rgba) {
    const auto part = [&](std::size_t i) { return static_cast<float>(std::clamp(rgba[i], 0.0, 1.0)); };
    return {part(0), part(1), part(2)};
}

// Returns whether the geom adds to the mass of its body.
bool weighs(const MjcfElement& element) {
    const auto given = element.attribute("mass");
    return (given ? given->number(0.0, 1e12) : element.number("density", 1000.0, 0.0, 1e12)) > 0.0;
}

void add_mass(const MjcfElement& element, const GeomSolid& solid, const Rigid& frame, MjcfPart& part) {
    const auto given = element.attribute("mass");
    const double density = element.number("density", 1000.0, 0.0, 1e12);
    if (!solid.shape) return;
    SolidMass unit = solid.mass ? *solid.mass : shape_mass(*solid.shape, 1.0);
    Rigid at = solid.mass ? frame : frame * solid.turn;
    const double scale = given ? given->number(0.0, 1e12) / std::max(unit.mass, 1e-30) : density;
    if (!(unit.mass > 0.0) || scale == 0.0) return;
    part.body.masses.push_back(
        {unit.mass * scale, unit.inertia * scale, at * Rigid{unit.center, {1.0, 0.0, 0.0, 0.0}}});
    part.own_mass += unit.mass * scale;
}

// Returns the mesh for visuals, with texture coordinates; else the surface of the geom, if any.
std::shared_ptr<const Surface> look_surface(const MjcfElement& element, const GeomSolid& solid, MjcfAssets& assets) {
    const auto mesh = element.attribute("mesh");
    return solid.is_mesh && mesh ? assets.look(*mesh) : solid.surface;
}

// Returns the triangles of a shape; a plane has the size that the model gives.
Surface seen_surface(const MjcfElement& element, const Shape& shape) {
    if (const Plane* plane = std::get_if<Plane>(&shape)) {
        const auto size = element.attribute("size");
        const std::vector<double> given = size ? size->numbers(1, 3) : std::vector<double>();
        if (given.size() > 1 && given[0] > 0.0 && given[1] > 0.0) {
            Plane part = *plane;
            part.tangent = {1.0f, 0.0f, 0.0f};
            part.half_extents = glm::vec2(std::min(given[0], largest), std::min(given[1], largest));
            return tessellate(part);
        }
    }
    return tessellate(shape);
}

// Returns the half sizes along x and y by which a texture is stretched; 0 where the geom is infinite.
glm::dvec2 half_sizes(const MjcfElement& element, const GeomSolid& solid, const Surface& surface) {
    const bool is_plane = solid.shape && std::holds_alternative<Plane>(*solid.shape);
    const auto size = element.attribute("size");
    const std::vector<double> given = is_plane && size ? size->numbers(1, 3) : std::vector<double>();
    if (is_plane) return given.size() > 1 ? glm::dvec2(given[0], given[1]) : glm::dvec2(0.0);
    glm::dvec3 most(0.0);
    for (const Vec3& vertex : surface.vertices)
        most = glm::max(most, glm::abs(solid.turn.rotation * glm::dvec3(vertex) + solid.turn.position));
    return {most.x, most.y};
}

} // namespace

void add_mjcf_geom(const MjcfElement& element, const Rigid& in_part, bool has_mass, const std::string& suffix,
                   MjcfPart& part, MjcfAssets& assets, MjcfModel& model) {
    MjcfGeom geom;
    geom.name = element.name() + suffix;
    geom.place = element.place();
    const auto bits = [&](const char* name) {
        const auto text = element.attribute(name);
        return text ? static_cast<unsigned>(text->whole(0, 2147483647)) : 1u;
    };
    geom.contype = bits("contype");
    geom.conaffinity = bits("conaffinity");
    const auto group_text = element.attribute("group");
    const long group = group_text ? group_text->whole(-1000, 1000) : 0;
    std::optional<MjcfMaterial> material;
    if (const auto name = element.attribute("material")) material = assets.material(*name, model.warnings);
    const std::vector<double> rgba = geom_rgba(element, material);
    const Vec3 tint = material ? material->tint : Vec3(1.0f);
    has_mass = has_mass && group >= model.settings.first_inertia_group && group <= model.settings.last_inertia_group;
    const bool touches = geom.contype != 0 || geom.conaffinity != 0;
    Rigid frame;
    GeomSolid solid;
    GeomReader reader(element, assets);
    try {
        solid = reader.read(frame, model.settings);
    } catch (const Error& error) {
        const bool is_weighed = has_mass && part.kind == MjcfPart::Kind::moving && weighs(element);
        const bool is_look = !touches && !is_weighed;               // visuals do not affect the simulation
        if (error.code() == ErrorCode::invalid_value && !is_look) { // a shape that the engine refuses
            throw Error(ErrorCode::invalid_file, element.place(), {}, error.what());
        }
        const bool is_missing = error.code() == ErrorCode::io || error.code() == ErrorCode::unsupported;
        if (!is_look && (!is_missing || is_weighed)) throw;
        model.warnings.push_back(std::string(error.what()) + " (the geom is left out)");
        part.lacks_looks = true;
        return;
    }
    if (reader.was_fitted) {
        model.warnings.push_back(element.place() + ": is the mesh itself instead of a primitive fitted to it");
    }
    frame = in_part * frame;
    if (has_mass) add_mass(element, solid, frame, part);
    if (touches && !solid.shape) {
        model.warnings.push_back(element.place() + ": is flat, and touches nothing");
    }
    if (touches && solid.shape && model.settings.contacts) {
        ModelShape shape{*solid.shape, frame * solid.turn,      {},        geom_material(element), {},
                         {},           geom_color(rgba) * tint, geom.place};
        if (model.decomposes && solid.is_mesh && part.kind == MjcfPart::Kind::moving) {
            shape.parts = model.surface_parts.of(solid.surface);
            shape.at = frame;
        }
        geom.shape = std::move(shape);
    }
    if (group <= last_seen_group && rgba[3] > 0.0) {
        ModelVisual look;
        look.at = frame * solid.turn;
        look.color = geom_color(rgba) * tint;
        look.surface = look_surface(element, solid, assets);
        if (material && material->texture) {
            const Surface plain = look.surface ? *look.surface : seen_surface(element, *solid.shape);
            look.surface = std::make_shared<const Surface>(
                mjcf_covered(plain, solid.turn, *material, half_sizes(element, solid, plain)));
            look.texture = material->texture;
        } else if (!geom.shape && !look.surface) {
            look.surface = std::make_shared<const Surface>(tessellate(*solid.shape));
        }
        geom.look = std::move(look);
    }
    part.geoms.push_back(std::move(geom));
}

} // namespace cairn::scene
