// Robots for tests of URDF files.
#pragma once

#include "scene_text.h"

#include <string>

namespace cairn::scene_test {

inline scene::Scene load_robot(const std::string& elements) {
    return load_text("<robot name=\"test\">" + elements + "</robot>", "test.urdf");
}

inline std::string inertial(const std::string& mass = "1", const std::string& more = "") {
    return "<inertial>" + more + "<mass value=\"" + mass +
           R"("/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.25"/></inertial>)";
}
inline std::string link(const std::string& name, const std::string& content = inertial()) {
    return "<link name=\"" + name + "\">" + content + "</link>";
}
inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child, const std::string& more = "") {
    return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" +
           child + "\"/>" + more + "</joint>";
}

} // namespace cairn::scene_test
