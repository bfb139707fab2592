// Properties of the world, of bodies and of shapes.
#include "sweep/properties.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cairn::sweep {

namespace {

template <class V> void put(double* out, const V& v) {
    out[0] = static_cast<double>(v.x), out[1] = static_cast<double>(v.y), out[2] = static_cast<double>(v.z);
}
float single(double value) { return static_cast<float>(value); }
Vec3 vector_of(const double* v) { return {single(v[0]), single(v[1]), single(v[2])}; }
double length_of(const Vec3& v) {
    const glm::dvec3 d(v);
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

// --- the world

template <class F> void change_settings(Trial& trial, const F& change) {
    WorldDef settings = trial.world.settings();
    change(settings);
    trial.world.set_settings(settings);
}

template <float WorldDef::*member> constexpr Property setting(std::string_view name) {
    return {name, "",
            [](const Trial& t, const Subject&, double* out) { *out = static_cast<double>(t.world.settings().*member); },
            [](Changes& c, const Subject&, const double* v) {
                change_settings(c.trial, [&](WorldDef& settings) { settings.*member = single(*v); });
            }};
}

void set_substeps(Changes& changes, const Subject&, const double* v) {
    if (!(*v >= 0.0 && *v <= 256.0)) {
        throw Error(ErrorCode::invalid_value, "world.substeps", std::to_string(*v), "must be 0 to 256");
    }
    change_settings(changes.trial, [&](WorldDef& settings) { settings.substeps = static_cast<int>(*v); });
}

void set_time_step(Changes& changes, const Subject&, const double* v) {
    if (!(*v >= 1e-4 && *v <= 1.0)) {
        throw Error(ErrorCode::invalid_value, "world.time_step", std::to_string(*v), "must be 0.0001 to 1 s");
    }
    changes.trial.time_step = static_cast<double>(single(*v)); // rounded to float, as the world does
}

constexpr std::array of_world{
    Property{"gravity", "xyz",
             [](const Trial& t, const Subject&, double* out) { put(out, t.world.settings().gravity); },
             [](Changes& c, const Subject&, const double* v) {
                 change_settings(c.trial, [&](WorldDef& settings) { settings.gravity = vector_of(v); });
             }},
    Property{
        "substeps", "",
        [](const Trial& t, const Subject&, double* out) { *out = static_cast<double>(t.world.settings().substeps); },
        set_substeps},
    Property{"time_step", "", [](const Trial& t, const Subject&, double* out) { *out = t.time_step; }, set_time_step},
    setting<&WorldDef::restitution_speed>("restitution_speed"),
    setting<&WorldDef::recovery_speed>("recovery_speed"),
    setting<&WorldDef::sleep_speed>("sleep_speed"),
    setting<&WorldDef::sleep_time>("sleep_time"),
    Property{"time", "", [](const Trial& t, const Subject&, double* out) { *out = t.world.time(); }},
    Property{"kinetic_energy", "",
             [](const Trial& t, const Subject&, double* out) { *out = t.world.kinetic_energy(); }},
    Property{"potential_energy", "",
             [](const Trial& t, const Subject&, double* out) { *out = t.world.potential_energy(); }},
    Property{"energy", "",
             [](const Trial& t, const Subject&, double* out) {
                 *out = t.world.kinetic_energy() + t.world.potential_energy();
             }},
    Property{"momentum", "xyz",
             [](const Trial& t, const Subject&, double* out) { put(out, t.world.linear_momentum()); }},
    Property{"angular_momentum", "xyz",
             [](const Trial& t, const Subject&, double* out) { put(out, t.world.angular_momentum()); }},
    Property{
        "contacts", "",
        [](const Trial& t, const Subject&, double* out) { *out = static_cast<double>(t.world.statistics().contacts); }},
    Property{"awake_bodies", "",
             [](const Trial& t, const Subject&, double* out) {
                 *out = static_cast<double>(t.world.statistics().awake_bodies);
             }},
    Property{"max_penetration", "",
             [](const Trial& t, const Subject&, double* out) { *out = t.world.statistics().max_penetration; }},
};

// --- bodies

template <double (*value)(const Body&)> constexpr auto read_body() {
    return [](const Trial& t, const Subject& s, double* out) { *out = value(t.world.body(s.body)); };
}

void read_touch(const Trial& trial, const Subject& subject, double* out) {
    const std::vector<Contact> contacts = trial.world.contacts(subject.body);
    *out = std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
        return contact.body_a == subject.other || contact.body_b == subject.other;
    });
}

constexpr std::array of_body{
    Property{"position", "xyz",
             [](const Trial& t, const Subject& s, double* out) { put(out, t.world.body(s.body).position()); },
             [](Changes& c, const Subject& s, const double* v) {
                 c.trial.world.body(s.body).set_position({v[0], v[1], v[2]});
             }},
    Property{"rotation", "xyzw",
             [](const Trial& t, const Subject& s, double* out) {
                 const Quat q = t.world.body(s.body).rotation();
                 put(out, q);
                 out[3] = static_cast<double>(q.w);
             },
             [](Changes& c, const Subject& s, const double* v) {
                 c.trial.world.body(s.body).set_rotation(Quat(single(v[3]), single(v[0]), single(v[1]), single(v[2])));
             }},
    Property{"velocity", "xyz",
             [](const Trial& t, const Subject& s, double* out) { put(out, t.world.body(s.body).linear_velocity()); },
             [](Changes& c, const Subject& s, const double* v) {
                 c.trial.world.body(s.body).set_linear_velocity(vector_of(v));
             }},
    Property{"angular_velocity", "xyz",
             [](const Trial& t, const Subject& s, double* out) { put(out, t.world.body(s.body).angular_velocity()); },
             [](Changes& c, const Subject& s, const double* v) {
                 c.trial.world.body(s.body).set_angular_velocity(vector_of(v));
             }},
    Property{"mass", "", read_body<[](const Body& b) { return static_cast<double>(b.mass()); }>(),
             [](Changes& c, const Subject& s, const double* v) {
                 c.trial.world.body(s.body).set_mass_from_shapes(single(*v));
             }},
    Property{"gravity_scale", "", read_body<[](const Body& b) { return static_cast<double>(b.gravity_scale()); }>(),
             [](Changes& c, const Subject& s, const double* v) {
                 c.trial.world.body(s.body).set_gravity_scale(single(*v));
             }},
    Property{"linear_damping", "", read_body<[](const Body& b) { return static_cast<double>(b.linear_damping()); }>(),
             [](Changes& c, const Subject& s, const double* v) {
                 Body body = c.trial.world.body(s.body);
                 body.set_damping(single(*v), body.angular_damping());
             }},
    Property{"angular_damping", "", read_body<[](const Body& b) { return static_cast<double>(b.angular_damping()); }>(),
             [](Changes& c, const Subject& s, const double* v) {
                 Body body = c.trial.world.body(s.body);
                 body.set_damping(body.linear_damping(), single(*v));
             }},
    Property{"enabled", "", read_body<[](const Body& b) { return b.enabled() ? 1.0 : 0.0; }>(),
             [](Changes& c, const Subject& s, const double* v) {
                 if (*v != 0.0 && *v != 1.0)
                     throw Error(ErrorCode::invalid_value, "enabled", std::to_string(*v), "must be 0 or 1");
                 c.trial.world.body(s.body).set_enabled(*v != 0.0);
             }},
    Property{"center_of_mass", "xyz",
             [](const Trial& t, const Subject& s, double* out) { put(out, t.world.body(s.body).center_of_mass()); }},
    Property{"speed", "", read_body<[](const Body& b) { return length_of(b.linear_velocity()); }>()},
    Property{"angular_speed", "", read_body<[](const Body& b) { return length_of(b.angular_velocity()); }>()},
    Property{"kinetic_energy", "", read_body<[](const Body& b) { return b.kinetic_energy(); }>()},
    Property{"awake", "", read_body<[](const Body& b) { return b.is_awake() ? 1.0 : 0.0; }>()},
    Property{"contacts", "",
             [](const Trial& t, const Subject& s, double* out) {
                 *out = static_cast<double>(t.world.contacts(s.body).size());
             }},
    Property{"touches", "", read_touch},
};

// --- shapes

std::vector<ShapeId> shapes_of(const World& world, const Subject& subject) {
    if (!subject.shape.is_null()) return {subject.shape};
    return world.body(subject.body).shapes();
}

template <class F> void change_materials(Trial& trial, const Subject& subject, const F& change) {
    for (const ShapeId shape : shapes_of(trial.world, subject)) {
        Material material = trial.world.shape_def(shape).material;
        change(material);
        trial.world.set_material(shape, material);
    }
}

// Reading a property of several shapes gives that of the first shape.
template <float Material::*member> void read_material(const Trial& trial, const Subject& subject, double* out) {
    const std::vector<ShapeId> shapes = shapes_of(trial.world, subject);
    *out = shapes.empty() ? std::nan("") : static_cast<double>(trial.world.shape_def(shapes[0]).material.*member);
}

template <float Material::*member> constexpr Property material(std::string_view name) {
    return {name, "", read_material<member>, [](Changes& c, const Subject& s, const double* v) {
                change_materials(c.trial, s, [&](Material& material) { material.*member = single(*v); });
            }};
}

constexpr std::array of_shape{
    Property{"friction", "", read_material<&Material::dynamic_friction>,
             [](Changes& c, const Subject& s, const double* v) {
                 change_materials(c.trial, s, [&](Material& material) {
                     material.static_friction = material.dynamic_friction = single(*v);
                 });
             }},
    material<&Material::static_friction>("static_friction"),
    material<&Material::dynamic_friction>("dynamic_friction"),
    material<&Material::restitution>("restitution"),
    material<&Material::rolling_friction>("rolling_friction"),
    material<&Material::torsional_friction>("torsional_friction"),
};

} // namespace

std::span<const Property> world_properties() { return of_world; }
std::span<const Property> body_properties() { return of_body; }
std::span<const Property> shape_properties() { return of_shape; }

} // namespace cairn::sweep
