#include "world/validate.h"

#include "shapes/surface_materials.h"
#include "state/substeps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cairn {

namespace {

constexpr float greatest_speed = 1e15f; // greatest linear and angular speed, m/s and rad/s
// Greatest coordinate of a position, m: beyond this the spacing of doubles exceeds the size of a bolt.
constexpr double farthest = 1e15;
constexpr float smallest_size = 1e-6f, largest_size = 1e9f; // The range of a shape's size, m.

template <class V> std::string list_text(const V& v, int n) {
    std::string text = "(";
    for (int i = 0; i < n; ++i) text += (i ? ", " : "") + to_text(double(v[i]));
    return text + ")";
}

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

[[noreturn]] void refuse_size(std::string_view field, float value) {
    refuse(field, to_text(value), "must be a size in meters from 1e-6 to 1e9");
}
inline void require_size(std::string_view field, float value) {
    if (!(value >= smallest_size && value <= largest_size)) refuse_size(field, value);
}

void require_mass(std::string_view field, float mass) {
    if (std::isinf(mass) && mass > 0) return;
    if (!(mass >= smallest_mass && mass <= largest_mass))
        refuse(field, to_text(mass), "must be a mass in kg from 1e-32 to 1e32, or infinite");
}

} // namespace

void refuse(std::string_view field, const std::string& value, const std::string& expected) {
    throw Error(ErrorCode::invalid_value, std::string(field), value, expected);
}

std::string to_text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    return buffer;
}
std::string to_text(const Vec3& v) { return list_text(v, 3); }
std::string to_text(const Position& v) { return list_text(v, 3); }
std::string to_text(const Quat& q) {
    return "(w " + to_text(q.w) + ", x " + to_text(q.x) + ", y " + to_text(q.y) + ", z " + to_text(q.z) + ")";
}

void require_finite(std::string_view field, double value) {
    if (!std::isfinite(value)) refuse(field, to_text(value), "must be finite");
}
void require_finite(std::string_view field, const Vec3& value) {
    if (!finite(value)) refuse(field, to_text(value), "must be finite");
}
void require_position(std::string_view field, const Position& value) {
    for (int i = 0; i < 3; ++i)
        if (!(std::fabs(value[i]) <= farthest))
            refuse(field, to_text(value), "must be finite and within 1e15 m of the origin");
}
void require_at_least(std::string_view field, double value, double least) {
    if (!(std::isfinite(value) && value >= least))
        refuse(field, to_text(value), "must be finite and >= " + to_text(least));
}
void require_above(std::string_view field, double value, double limit) {
    if (!(std::isfinite(value) && value > limit))
        refuse(field, to_text(value), "must be finite and > " + to_text(limit));
}

Quat checked_rotation(std::string_view field, const Quat& q) {
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    const double square = x * x + y * y + z * z + w * w;
    if (std::fabs(square - 1) < 4e-7) return q; // the quaternion is normalized to float precision: keep its bits
    if (!std::isfinite(square)) refuse(field, to_text(q), "must be finite");
    if (!(square > 1e-24)) refuse(field, to_text(q), "must not be zero");
    const double scale = 1 / std::sqrt(square);
    return Quat(float(w * scale), float(x * scale), float(y * scale), float(z * scale));
}

void validate(const WorldDef& def) {
    require_finite("WorldDef.gravity", def.gravity);
    if (def.substeps < 0 || def.substeps > max_substeps)
        refuse("WorldDef.substeps", std::to_string(def.substeps),
               "must be from 1 to " + std::to_string(max_substeps) + ", or 0 to choose by the length of the step");
    if (def.integrator > Integrator::rk4)
        refuse("WorldDef.integrator", std::to_string(int(def.integrator)), "must be one of the enumerators");
    require_at_least("WorldDef.sleep_speed", def.sleep_speed, 0);
    require_at_least("WorldDef.sleep_time", def.sleep_time, 0);
    require_at_least("WorldDef.restitution_speed", def.restitution_speed, 0);
    require_at_least("WorldDef.hit_speed", def.hit_speed, 0);
    require_above("WorldDef.recovery_speed", def.recovery_speed, 0);
    require_above("WorldDef.max_linear_speed", def.max_linear_speed, 0);
    require_above("WorldDef.max_angular_speed", def.max_angular_speed, 0);
    if (def.max_linear_speed > greatest_speed) // so that its square does not overflow a float
        refuse("WorldDef.max_linear_speed", to_text(def.max_linear_speed), "must be at most 1e15");
    if (def.max_angular_speed > greatest_speed)
        refuse("WorldDef.max_angular_speed", to_text(def.max_angular_speed), "must be at most 1e15");
}

void validate(std::string_view field, const MassProperties& p) {
    require_mass(std::string(field) + ".mass", p.mass);
    require_finite(std::string(field) + ".center_of_mass", p.center_of_mass);
    require_position(std::string(field) + ".center_of_mass", Position(p.center_of_mass));
    checked_rotation(std::string(field) + ".inertia_orientation", p.inertia_orientation);
    const Vec3& i = p.inertia_diagonal;
    const std::string name = std::string(field) + ".inertia_diagonal";
    for (int k = 0; k < 3; ++k)
        if (!(i[k] >= 0) || !std::isfinite(i[k]))
            refuse(name, to_text(i), "must be finite and >= 0 (0: does not turn about that axis)");
    // Moments of inertia of a real body satisfy the triangle inequality; it does not apply if one of them is zero
    // (immovable).
    const float largest = std::max({i.x, i.y, i.z});
    const bool all_positive = i.x > 0 && i.y > 0 && i.z > 0;
    if (all_positive && double(i.x) + i.y + i.z - largest < double(largest) * (1 - 1e-4))
        refuse(name, to_text(i), "must satisfy the triangle inequality: no moment may exceed the sum of the other two");
}

void validate(const BodyDef& def) {
    if (def.type > BodyType::dynamic)
        refuse("BodyDef.type", std::to_string(int(def.type)), "must be one of the enumerators");
    require_position("BodyDef.position", def.position);
    checked_rotation("BodyDef.rotation", def.rotation);
    require_finite("BodyDef.linear_velocity", def.linear_velocity);
    require_finite("BodyDef.angular_velocity", def.angular_velocity);
    require_at_least("BodyDef.linear_damping", def.linear_damping, 0);
    require_at_least("BodyDef.angular_damping", def.angular_damping, 0);
    require_finite("BodyDef.gravity_scale", def.gravity_scale);
    if (def.mass) require_mass("BodyDef.mass", *def.mass);
    if (def.mass_properties) validate("BodyDef.mass_properties", *def.mass_properties);
}

namespace {

void require_direction(std::string_view field, const Vec3& v) {
    require_finite(field, v);
    if (!(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}) > 1e-30f))
        refuse(field, to_text(v), "must not be zero");
}

struct ShapeValidator {
    void operator()(const Sphere& sphere) const { require_size("Sphere.radius", sphere.radius); }
    void operator()(const Box& box) const {
        const char* names[] = {"Box.half_extents.x", "Box.half_extents.y", "Box.half_extents.z"};
        for (int i = 0; i < 3; ++i) require_size(names[i], box.half_extents[i]);
        require_rounding("Box.rounding", box.rounding);
    }
    void operator()(const Plane& plane) const {
        require_direction("Plane.normal", plane.normal);
        if (!plane.half_extents) return;
        require_direction("Plane.tangent", plane.tangent);
        const glm::vec2& half = *plane.half_extents;
        if (std::isinf(half.x) && std::isinf(half.y))
            refuse("Plane.half_extents", list_text(half, 2), "must be finite along one axis, or absent");
        if (!(std::isinf(half.x) && half.x > 0)) require_size("Plane.half_extents.x", half.x);
        if (!(std::isinf(half.y) && half.y > 0)) require_size("Plane.half_extents.y", half.y);
    }
    void operator()(const Capsule& capsule) const {
        require_size("Capsule.half_height", capsule.half_height);
        require_size("Capsule.radius", capsule.radius);
        if (capsule.radius_top) require_tip("Capsule.radius_top", *capsule.radius_top);
    }
    void operator()(const Cylinder& cylinder) const {
        require_size("Cylinder.half_height", cylinder.half_height);
        require_size("Cylinder.radius", cylinder.radius);
        if (cylinder.radius_top) require_tip("Cylinder.radius_top", *cylinder.radius_top);
        require_rounding("Cylinder.rounding", cylinder.rounding);
    }
    // The data was validated at construction, but is null after a move.
    void operator()(const Hull& hull) const {
        require_data("Hull", hull.data() != nullptr);
        require_rounding("Hull.rounding", hull.rounding);
    }
    void operator()(const Mesh& mesh) const { require_data("Mesh", mesh.data() != nullptr); }
    void operator()(const HeightField& field) const { require_data("HeightField", field.data() != nullptr); }

  private:
    static void require_rounding(std::string_view field, float radius) {
        if (!(radius >= 0 && radius <= largest_size))
            refuse(field, to_text(radius), "must be a radius in meters from 0 (sharp) to 1e9");
    }
    static void require_tip(std::string_view field, float radius) {
        if (radius != 0) require_size(field, radius);
    }
    static void require_data(std::string_view field, bool has_data) {
        if (!has_data) refuse(field, "", "was moved from");
    }
};

} // namespace

void validate(const Shape& shape) { std::visit(ShapeValidator{}, shape); }

const char* shape_name(const Shape& shape) {
    constexpr const char* names[] = {"Sphere", "Box", "Plane", "Capsule", "Cylinder", "Hull", "Mesh", "HeightField"};
    static_assert(std::size(names) == std::variant_size_v<Shape>);
    return names[shape.index()];
}

void validate(const ShapeDef& def) {
    require_finite("ShapeDef.position", def.position);
    require_position("ShapeDef.position", Position(def.position));
    checked_rotation("ShapeDef.rotation", def.rotation);
    require_at_least("ShapeDef.density", def.density, 0);
    require_finite("ShapeDef.surface_velocity", def.surface_velocity);
    if (def.one_way != Vec3(0.0f)) require_direction("ShapeDef.one_way", def.one_way);
    check_material("ShapeDef.material", def.material);
}

void validate(const ForceField& field) {
    require_finite("ForceField.direction", field.direction);
    require_position("ForceField.center", field.center);
    require_finite("ForceField.strength", field.strength);
    if (field.kind > ForceField::Kind::fluid)
        refuse("ForceField.kind", std::to_string(int(field.kind)), "must be one of the enumerators");
    if (field.exponent != -2 && field.exponent != -1 && field.exponent != 0 && field.exponent != 1)
        refuse("ForceField.exponent", to_text(field.exponent), "must be -2, -1, 0 or 1");
    for (int i = 0; i < 3; ++i)
        if (!(field.half_extents[i] > 0))
            refuse("ForceField.half_extents", to_text(field.half_extents[i]), "must be > 0");
    require_at_least("ForceField.density", field.density, 0);
    require_at_least("ForceField.drag", field.drag, 0);
    require_at_least("ForceField.skin_friction", field.skin_friction, 0);
    require_at_least("ForceField.added_mass", field.added_mass, 0);
    require_at_least("ForceField.wave_damping", field.wave_damping, 0);
}

} // namespace cairn
