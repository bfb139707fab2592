// Settings of a whole MJCF model: the elements compiler and option, and the default classes.
#pragma once

#include "scene/rigid.h"
#include "scene/xml_file.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

struct MjcfSettings {
    // compiler
    bool degrees = true, autolimits = true, strips_paths = false, balances_inertia = false;
    std::string euler = "xyz", mesh_folder, texture_folder;
    enum class InertiaFromGeoms { never, always, where_absent } inertia_from_geoms = InertiaFromGeoms::where_absent;
    long first_inertia_group = 0, last_inertia_group = 5;
    double least_mass = 0.0, least_inertia = 0.0;
    std::optional<double> total_mass;
    // option
    double time_step = 0.002;
    glm::dvec3 gravity{0.0, 0.0, -9.81};
    bool contacts = true, limits = true, equalities = true, actuators = true, springs = true, dampers = true,
         friction = true, filters_parents = true;

    double angle(double value) const;
};
MjcfSettings read_mjcf_settings(const XmlElement& root);

class MjcfDefaults {
  public:
    explicit MjcfDefaults(const XmlElement& root);

    // Returns the index of the class of that name. Throws through `name` if there is none.
    std::size_t find(const XmlText& name) const;
    // Returns the default of an attribute of elements with that tag, from the class or the classes it is derived from.
    const XmlText* value(std::size_t index, const std::string& tag, const char* attribute) const;

  private:
    struct Class {
        std::size_t parent = 0;                                       // the first class is its own parent
        std::map<std::string, std::map<std::string, XmlText>> values; // by tag and attribute
    };
    void read(const XmlElement& element, std::size_t index);
    std::vector<Class> classes_{Class{}};
    std::map<std::string, std::size_t> names_{{"main", 0}};
};

// An element whose missing attributes take the defaults of its class.
class MjcfElement {
  public:
    // `fallback_class` applies if the element names no class.
    MjcfElement(XmlElement element, const MjcfDefaults& defaults, std::size_t fallback_class);

    const XmlElement& xml() const { return element_; }
    std::string place() const { return element_.place(); }
    std::string name() const { return element_.text_of("name"); }
    [[noreturn]] void fail(const std::string& expected) const { element_.fail(expected); }

    std::optional<XmlText> attribute(const char* name) const;
    double number(const char* name, double otherwise, double least = -1e30, double most = 1e30) const;
    glm::dvec3 vector3(const char* name, const glm::dvec3& otherwise) const;
    std::string word(const char* name, const std::string& otherwise = "") const;
    // For an attribute with the values true, false and auto, where auto means on if the attribute `other` is present.
    bool is_on(const char* name, const char* other, bool autolimits) const;

  private:
    XmlElement element_;
    const MjcfDefaults* defaults_;
    std::size_t class_;
};

// The pose that the attributes pos, quat, axisangle, xyaxes, zaxis and euler give an element.
Rigid mjcf_frame(const MjcfElement& element, const MjcfSettings& settings);
// The rotation of three Euler angles (rad) in the order of the model's euler sequence.
glm::dquat mjcf_euler(const glm::dvec3& angles, const std::string& sequence);
// Throws through `text` if the vector has no direction.
glm::dvec3 unit_vector(const glm::dvec3& vector, const XmlText& text);

} // namespace cairn::scene
