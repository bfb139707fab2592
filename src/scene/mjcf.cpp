// Builds a world from an MJCF model.
#include "scene/mjcf.h"

#include "scene/loaded_world.h"
#include "scene/mass_sum.h"
#include "scene/mjcf_model.h"
#include "scene/tessellation.h"

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

// Applies the total mass, the lower bounds of mass and inertia, and the rotor inertias of joints.
void settle_masses(MjcfModel& model) {
    double total = 0.0;
    for (const MjcfPart& part : model.parts) total += part.kind == MjcfPart::Kind::moving ? part.own_mass : 0.0;
    const MjcfSettings& settings = model.settings;
    const double scale = settings.total_mass && total > 0.0 ? *settings.total_mass / total : 1.0;
    for (MjcfPart& part : model.parts) {
        if (part.kind != MjcfPart::Kind::moving) continue;
        std::vector<ModelMass>& masses = part.body.masses;
        for (ModelMass& mass : masses) mass.mass *= scale, mass.inertia *= scale;
        if (part.own_mass * scale < settings.least_mass) {
            masses.push_back({settings.least_mass - part.own_mass * scale, glm::dmat3(0.0), {}});
        }
        for (const std::size_t index : part.joints) {
            const MjcfJoint& joint = model.joints[index];
            if (joint.armature == 0.0 || joint.kind == MjcfJoint::Kind::free) continue;
            if (joint.kind == MjcfJoint::Kind::slide) {
                model.warnings.push_back(joint.place + ": armature is left out, as of every slide");
                continue;
            }
            // The rotor inertia of a joint, carried by the body: a flat disk about the axis; a ball for a ball joint.
            const double across = joint.kind == MjcfJoint::Kind::ball ? 1.0 : 0.5;
            const glm::dmat3 disk = glm::dmat3(across * joint.armature) +
                                    (1.0 - across) * joint.armature * glm::outerProduct(joint.axis, joint.axis);
            masses.push_back({0.0, disk, {joint.anchor, {1.0, 0.0, 0.0, 0.0}}});
        }
        double mass = 0.0;
        MassSum sum;
        for (const ModelMass& each : masses) sum.add(each.mass, each.inertia, each.at), mass += each.mass;
        if (!(mass > 0.0)) {
            throw Error(ErrorCode::invalid_file, part.body.place, {},
                        "must have a mass, by an inertial or by geoms, as every body with joints");
        }
        const MassProperties properties = sum.properties();
        const glm::dvec3 moments(properties.inertia_diagonal), center(properties.center_of_mass);
        const double least = std::min({moments.x, moments.y, moments.z});
        if (least < settings.least_inertia) {
            masses.push_back({0.0, glm::dmat3(settings.least_inertia - least), {center, {1.0, 0.0, 0.0, 0.0}}});
        } else if (!(least > 0.0)) {
            model.warnings.push_back(part.body.place +
                                     " has no inertia about some axis; the inertia of a ball of 0.1 m radius is added");
            masses.push_back({0.0, fallback_inertia(mass), {center, {1, 0, 0, 0}}});
        }
    }
}

// Moves shapes and visuals to the body. If any geom is a visual only or has a texture, all visible geoms become
// visuals; else the body is shown by its shapes.
void dress(MjcfPart& part) {
    bool has_looks = false;
    for (const MjcfGeom& geom : part.geoms) has_looks = has_looks || (geom.look && (!geom.shape || geom.look->texture));
    if (part.lacks_looks) has_looks = false;
    for (MjcfGeom& geom : part.geoms) {
        if (has_looks && geom.look) {
            ModelVisual look = *geom.look;
            if (!look.surface) look.surface = std::make_shared<const Surface>(tessellate(geom.shape->shape));
            part.body.looks.push_back(std::move(look));
        }
        if (geom.shape) part.body.shapes.push_back(*geom.shape);
    }
}

} // namespace

Scene load_mjcf(std::span<const std::byte> bytes, const std::string& name,
                const std::optional<std::filesystem::path>& folder, const LoadOptions& options) {
    XmlFile file(bytes, name, "an MJCF file");
    file.resolve_includes(folder);
    const XmlElement root = file.root();
    const MjcfSettings settings = read_mjcf_settings(root);
    const MjcfDefaults defaults(root);
    MjcfAssets assets(root, settings, defaults, folder);
    MjcfModel model{settings, defaults, {}, {}, {}, {}, {}, true, {}, options.decompose};
    read_mjcf_bodies(root, options.fixed_base, assets, model);
    const std::vector<double> control = place_mjcf_parts(root, model);
    read_mjcf_actuators(root, control, model);
    settle_masses(model);

    WorldDef world;
    world.gravity = Vec3(upright.rotation * settings.gravity);
    Scene scene{loaded_world(world, options), {}, {}, {}, {}};
    scene.info.title = root.text_of("model");
    if (scene.info.title.empty()) scene.info.title = std::filesystem::path(name).stem().generic_string();
    scene.info.time_step = static_cast<float>(settings.time_step);
    set_mjcf_filters(root, model, scene);
    for (MjcfPart& part : model.parts) {
        dress(part);
        const bool is_empty = part.body.shapes.empty() && part.body.looks.empty();
        if (&part == &model.parts[0] && is_empty) continue;
        part.id = add_model_body(part.body, scene);
    }
    add_mjcf_joints(model, scene);
    add_mjcf_constraints(root, model, scene);
    scene.warnings = std::move(model.warnings);
    if (auto line = file.unused()) scene.warnings.push_back(std::move(*line));
    limit_warnings(scene.warnings);
    return scene;
}

} // namespace cairn::scene
