#include "viewer/joint_layout.h"

#include "viewer/world_state.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <unordered_map>

namespace cairn::viewer {

std::vector<JointLayout> read_joints(const World& world, const WorldLayout& layout, JointId hidden,
                                     std::span<const JointAppearance> strings) {
    std::vector<JointLayout> joints;
    const std::vector<JointId> ids = world.joints();
    if (ids.empty()) return joints;
    std::unordered_map<BodyId, std::size_t> places;
    for (std::size_t i = 0; i < layout.bodies.size(); ++i) places.emplace(layout.bodies[i].id, i);
    std::unordered_map<JointId, Vec3> colors;
    for (const JointAppearance& shown : strings) colors.emplace(shown.joint, shown.color);
    std::vector<float> reaches(layout.bodies.size());
    for (const ShapeLayout& shape : layout.shapes)
        reaches[shape.body] = std::max(reaches[shape.body], glm::length(shape.position) +
                                                                glm::length(shape.bound_center) + shape.bound_radius);
    for (const JointId id : ids) {
        if (id == hidden) continue;
        JointLayout joint;
        joint.id = id;
        joint.def = world.joint_def(id);
        if (const auto color = colors.find(id); color != colors.end()) joint.color = color->second;
        float reach = 0.0f; // bodies without shapes are ignored
        const auto place_of = [&](BodyId body) -> std::optional<std::size_t> {
            if (!body) return std::nullopt;
            const std::size_t place = places.at(body);
            const bool counts = layout.bodies[place].type == BodyType::dynamic && reaches[place] > 0.0f;
            if (counts) reach = reach > 0.0f ? std::min(reach, reaches[place]) : reaches[place];
            return place;
        };
        joint.body_a = place_of(joint.def.body_a);
        joint.body_b = place_of(joint.def.body_b);
        if (reach > 0.0f) joint.reach = reach;
        joints.push_back(std::move(joint));
    }
    return joints;
}

JointFrames frames_of(const JointLayout& joint, std::span<const Transform> bodies) {
    const auto place = [&](const std::optional<std::size_t>& body, const Transform& frame) {
        if (!body) return frame;
        const Transform& pose = bodies[*body];
        return Transform{pose.position + Position(pose.rotation * Vec3(frame.position)),
                         glm::normalize(pose.rotation * frame.rotation)};
    };
    return {place(joint.body_a, joint.def.frame_a), place(joint.body_b, joint.def.frame_b)};
}

} // namespace cairn::viewer
