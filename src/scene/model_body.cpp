#include "scene/model_body.h"

#include "scene/mass_sum.h"

#include <cmath>
#include <utility>

namespace cairn::scene {

namespace {

constexpr std::size_t max_warnings = 100;
constexpr double heaviest = 1e15; // kg, and kg m2

MassProperties mass_of(const ModelBody& body) {
    MassSum sum;
    double inertia = 0.0;
    for (const ModelMass& part : body.masses) {
        sum.add(part.mass, part.inertia, part.at);
        for (int i = 0; i < 3; ++i) inertia += part.inertia[i][i];
    }
    if (!(sum.mass() > 0.0 && sum.mass() <= heaviest && inertia <= heaviest)) {
        throw Error(ErrorCode::invalid_file, body.place + ": mass", std::to_string(sum.mass()),
                    "must be > 0 for a body that moves, and at most 1e15 kg and 1e15 kg m2");
    }
    return sum.properties();
}

} // namespace

BodyId add_model_body(const ModelBody& body, Scene& scene) {
    BodyDef def;
    def.type = body.type;
    def.position = body.world.position;
    def.rotation = Quat(body.world.rotation);
    def.name = body.name;
    def.gravity_scale = static_cast<float>(body.gravity_scale);
    def.linear_damping = static_cast<float>(body.linear_damping);
    def.angular_damping = static_cast<float>(body.angular_damping);
    def.allow_sleep = body.may_sleep;
    if (body.type == BodyType::dynamic) def.mass_properties = mass_of(body);
    BodyId id;
    try {
        id = scene.world.create_body(def);
    } catch (const Error& error) {
        throw Error(ErrorCode::invalid_file, body.place, {}, error.what());
    }
    for (const ModelShape& shape : body.shapes) {
        ShapeDef shape_def;
        shape_def.position = Vec3(shape.at.position);
        shape_def.rotation = Quat(shape.at.rotation);
        // The density does not affect the body, whose mass properties are given.
        shape_def.density = shape.is_trigger ? 0.0f : 1000.0f;
        shape_def.material = shape.material;
        shape_def.filter = shape.filter;
        shape_def.surface_velocity = shape.surface_velocity;
        shape_def.is_trigger = shape.is_trigger;
        try {
            const auto add = [&](const Shape& one) {
                const ShapeId made = scene.world.add_shape(id, one, shape_def);
                if (shape.color) scene.appearances.push_back({id, made, *shape.color});
            };
            if (shape.parts.empty()) add(shape.shape);
            for (const Hull& part : shape.parts) add(part);
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, shape.place, {}, error.what());
        }
    }
    for (const ModelVisual& look : body.looks) {
        scene.visuals.push_back({id, look.at.transform(), look.surface, look.color, look.texture, {}, look.finish});
    }
    Body made = scene.world.body(id);
    const glm::dvec3& w = body.angular_velocity;
    if (body.velocity != glm::dvec3(0.0) || w != glm::dvec3(0.0)) {
        const glm::dvec3 arm = glm::dvec3(made.center_of_mass()) - body.world.position;
        try {
            made.set_linear_velocity(Vec3(body.velocity + glm::cross(w, arm)));
            made.set_angular_velocity(Vec3(w));
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, body.place, {}, error.what());
        }
    }
    return id;
}

void limit_warnings(std::vector<std::string>& warnings) {
    if (warnings.size() <= max_warnings) return;
    const std::size_t more = warnings.size() - max_warnings;
    warnings.resize(max_warnings);
    warnings.push_back("and " + std::to_string(more) + " more warnings");
}

} // namespace cairn::scene
