#include "scene/mjcf_settings.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>

namespace cairn::scene {

namespace {

constexpr double farthest_element = 1e6; // m

void read_compiler(const XmlElement& compiler, MjcfSettings& settings) {
    const auto flag = [&](const char* name, bool& value) {
        if (const auto text = compiler.attribute(name)) value = text->boolean();
    };
    if (const auto text = compiler.attribute("angle")) settings.degrees = text->choice({"radian", "degree"}) == 1;
    if (const auto text = compiler.attribute("coordinate"); text && text->text != "local") {
        throw Error(ErrorCode::unsupported, text->place, "\"" + printable(text->text) + "\"", "must be local");
    }
    if (const auto text = compiler.attribute("eulerseq")) {
        if (text->text.size() != 3 || text->text.find_first_not_of("xyzXYZ") != std::string::npos) {
            text->fail("must be three of the letters x, y, z, X, Y and Z");
        }
        settings.euler = text->text;
    }
    if (const auto text = compiler.attribute("assetdir")) settings.mesh_folder = settings.texture_folder = text->text;
    if (const auto text = compiler.attribute("meshdir")) settings.mesh_folder = text->text;
    if (const auto text = compiler.attribute("texturedir")) settings.texture_folder = text->text;
    flag("autolimits", settings.autolimits);
    flag("strippath", settings.strips_paths);
    flag("balanceinertia", settings.balances_inertia);
    if (const auto text = compiler.attribute("inertiafromgeom")) {
        settings.inertia_from_geoms =
            static_cast<MjcfSettings::InertiaFromGeoms>(text->choice({"false", "true", "auto"}));
    }
    if (const auto text = compiler.attribute("inertiagrouprange")) {
        const std::vector<double> range = text->numbers(2, 2);
        if (!(range[0] <= range[1]) || std::fabs(range[0]) > 1000 || std::fabs(range[1]) > 1000) {
            text->fail("must be two groups, the lower first");
        }
        settings.first_inertia_group = static_cast<long>(range[0]);
        settings.last_inertia_group = static_cast<long>(range[1]);
    }
    if (const auto text = compiler.attribute("boundmass")) settings.least_mass = text->number(0.0, 1e12);
    if (const auto text = compiler.attribute("boundinertia")) settings.least_inertia = text->number(0.0, 1e12);
    if (const auto text = compiler.attribute("settotalmass")) {
        const double total = text->number(-1e12, 1e12);
        if (total > 0.0) settings.total_mass = total;
    }
    // These attributes affect how a model is stored, not how it behaves.
    for (const char* name : {"discardvisual", "usethread", "fusestatic", "fitaabb", "saveinertial"}) {
        compiler.attribute(name);
    }
}

void read_option(const XmlElement& option, MjcfSettings& settings) {
    if (const auto text = option.attribute("timestep")) settings.time_step = text->number(0.0001, 1.0);
    if (const auto text = option.attribute("gravity")) {
        settings.gravity = text->vector3();
        for (int i = 0; i < 3; ++i) {
            if (!(std::fabs(settings.gravity[i]) <= 1e6)) text->fail("must be within 1000000 m/s2");
        }
    }
    for (const XmlElement& flags : option.children("flag")) {
        const auto flag = [&](const char* name, bool& value) {
            if (const auto text = flags.attribute(name)) value = text->choice({"disable", "enable"}) == 1;
        };
        bool gravity = true, constraint = true, passive = true;
        flag("gravity", gravity);
        flag("constraint", constraint);
        flag("passive", passive);
        flag("contact", settings.contacts);
        flag("limit", settings.limits);
        flag("equality", settings.equalities);
        flag("actuation", settings.actuators);
        flag("spring", settings.springs);
        flag("damper", settings.dampers);
        flag("frictionloss", settings.friction);
        flag("filterparent", settings.filters_parents);
        if (!gravity) settings.gravity = glm::dvec3(0.0);
        if (!constraint) settings.contacts = settings.limits = settings.equalities = settings.friction = false;
        if (!passive) settings.springs = settings.dampers = false;
    }
}

// All kinds of actuators share their defaults.
std::string shelf_of(const std::string& tag) {
    for (const char* kind : {"motor", "position", "velocity", "intvelocity", "damper"}) {
        if (tag == kind) return "general";
    }
    return tag;
}

} // namespace

double MjcfSettings::angle(double value) const { return degrees ? value * degree : value; }

MjcfSettings read_mjcf_settings(const XmlElement& root) {
    MjcfSettings settings;
    for (const XmlElement& compiler : root.children("compiler")) read_compiler(compiler, settings);
    for (const XmlElement& option : root.children("option")) read_option(option, settings);
    return settings;
}

MjcfDefaults::MjcfDefaults(const XmlElement& root) {
    for (const XmlElement& section : root.children("default")) {
        if (const auto name = section.attribute("class")) names_[name->text] = 0;
        read(section, 0);
    }
}

void MjcfDefaults::read(const XmlElement& element, std::size_t index) {
    for (const char* tag : {"geom", "joint", "mesh", "material", "equality", "general", "motor", "position", "velocity",
                            "intvelocity", "damper", "pair", "tendon", "default"}) {
        element.mark_read(tag);
    }
    for (const XmlElement& child : element.children()) {
        if (child.tag() == "default") {
            const XmlText name = child.require("class");
            if (!names_.insert({name.text, classes_.size()}).second) name.fail("must not be the name of two classes");
            classes_.push_back({index, {}});
            read(child, classes_.size() - 1);
            continue;
        }
        auto& values = classes_[index].values[shelf_of(std::string(child.tag()))];
        for (auto& [name, text] : child.attributes()) values[name] = std::move(text);
    }
}

std::size_t MjcfDefaults::find(const XmlText& name) const {
    const auto found = names_.find(name.text);
    if (found == names_.end()) name.fail("must be the class of a default element");
    return found->second;
}

const XmlText* MjcfDefaults::value(std::size_t index, const std::string& tag, const char* attribute) const {
    const std::string shelf = shelf_of(tag);
    for (;; index = classes_[index].parent) {
        const auto values = classes_[index].values.find(shelf);
        if (values != classes_[index].values.end()) {
            const auto found = values->second.find(attribute);
            if (found != values->second.end()) return &found->second;
        }
        if (index == 0) return nullptr;
    }
}

MjcfElement::MjcfElement(XmlElement element, const MjcfDefaults& defaults, std::size_t fallback_class)
    : element_(element), defaults_(&defaults), class_(fallback_class) {
    if (const auto name = element_.attribute("class")) class_ = defaults.find(*name);
}

std::optional<XmlText> MjcfElement::attribute(const char* name) const {
    if (auto own = element_.attribute(name)) return own;
    const XmlText* inherited = defaults_->value(class_, std::string(element_.tag()), name);
    return inherited ? std::optional(*inherited) : std::nullopt;
}

double MjcfElement::number(const char* name, double otherwise, double least, double most) const {
    const auto text = attribute(name);
    return text ? text->number(least, most) : otherwise;
}

glm::dvec3 MjcfElement::vector3(const char* name, const glm::dvec3& otherwise) const {
    const auto text = attribute(name);
    return text ? text->vector3() : otherwise;
}

std::string MjcfElement::word(const char* name, const std::string& otherwise) const {
    const auto text = attribute(name);
    return text ? text->text : otherwise;
}

bool MjcfElement::is_on(const char* name, const char* other, bool autolimits) const {
    const auto text = attribute(name);
    const std::size_t choice = text ? text->choice({"false", "true", "auto"}) : 2;
    const bool is_there = attribute(other).has_value();
    return choice == 2 ? autolimits && is_there : choice == 1;
}

glm::dvec3 unit_vector(const glm::dvec3& vector, const XmlText& text) {
    const double length = std::sqrt(glm::dot(vector, vector));
    if (!(length > 1e-12 && length < 1e15)) text.fail("must have a direction that is not zero");
    return vector / length;
}

// Lowercase letters are intrinsic rotations, about the rotated axes; capitals are extrinsic, about the axes of the
// parent.
glm::dquat mjcf_euler(const glm::dvec3& angles, const std::string& sequence) {
    glm::dquat result(1.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 3; ++i) {
        const char letter = sequence[static_cast<std::size_t>(i)];
        const bool turns_with = letter >= 'a';
        glm::dvec3 axis(0.0);
        axis[(turns_with ? letter - 'x' : letter - 'X')] = 1.0;
        const glm::dquat turn = turn_about(axis, angles[i]);
        result = turns_with ? result * turn : turn * result;
    }
    return glm::normalize(result);
}

Rigid mjcf_frame(const MjcfElement& element, const MjcfSettings& settings) {
    Rigid frame;
    if (const auto text = element.attribute("pos")) {
        frame.position = text->vector3();
        for (int i = 0; i < 3; ++i) {
            if (!(std::fabs(frame.position[i]) <= farthest_element)) text->fail("must be within 1000000 m");
        }
    }
    const auto quat = element.attribute("quat"), axis_angle = element.attribute("axisangle"),
               axes = element.attribute("xyaxes"), z_axis = element.attribute("zaxis"),
               euler = element.attribute("euler");
    if (quat.has_value() + axis_angle.has_value() + axes.has_value() + z_axis.has_value() + euler.has_value() > 1) {
        element.fail("must have at most one of quat, axisangle, xyaxes, zaxis and euler");
    }
    if (quat) {
        const std::vector<double> q = quat->numbers(4, 4);
        const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(length > 1e-12 && length < 1e15)) quat->fail("must not be zero");
        frame.rotation = glm::dquat(q[0], q[1], q[2], q[3]) / length;
    } else if (axis_angle) {
        const std::vector<double> v = axis_angle->numbers(4, 4);
        frame.rotation = turn_about(unit_vector({v[0], v[1], v[2]}, *axis_angle), settings.angle(v[3]));
    } else if (axes) {
        const std::vector<double> v = axes->numbers(6, 6);
        const glm::dvec3 x = unit_vector({v[0], v[1], v[2]}, *axes), given(v[3], v[4], v[5]);
        const glm::dvec3 y = unit_vector(given - glm::dot(given, x) * x, *axes);
        frame.rotation = glm::normalize(glm::quat_cast(glm::dmat3(x, y, glm::cross(x, y))));
    } else if (z_axis) {
        const glm::dvec3 z = unit_vector(z_axis->vector3(), *z_axis);
        frame.rotation =
            z.z < -0.999999 ? glm::dquat(0.0, 1.0, 0.0, 0.0) : glm::normalize(glm::dquat(1.0 + z.z, -z.y, z.x, 0.0));
    } else if (euler) {
        glm::dvec3 angles = euler->vector3();
        for (int i = 0; i < 3; ++i) {
            if (!(std::fabs(angles[i]) <= 1e6)) euler->fail("must be within 1000000");
            angles[i] = settings.angle(angles[i]);
        }
        frame.rotation = mjcf_euler(angles, settings.euler);
    }
    return frame;
}

} // namespace cairn::scene
