#include "viewer/group_edit.h"

#include <glm/gtc/quaternion.hpp>

namespace cairn::viewer {

BodyFacts facts_of_several(const World& world, std::span<const BodyId> bodies) {
    BodyFacts facts;
    glm::dvec3 by_mass(0.0), places(0.0);
    double mass = 0.0;
    for (const BodyId id : bodies) {
        const Body body = world.body(id);
        places += body.center_of_mass() / double(bodies.size());
        if (!can_be_pushed(body)) continue;
        mass += double(body.mass());
        by_mass += body.center_of_mass() * double(body.mass());
    }
    facts.mass.mass = float(mass);
    facts.position = facts.center = mass > 0.0 ? by_mass / mass : places;
    return facts;
}

std::vector<std::pair<BodyId, BodyEdit>> spread(const BodyEdit& edit, const Position& center, float scaled,
                                                std::span<const HeldBody> held) {
    std::vector<std::pair<BodyId, BodyEdit>> edits;
    for (const HeldBody& body : held) {
        const Vec3 arm(body.pose.position - center);
        if (const auto* pose = std::get_if<edit::Pose>(&edit)) {
            edits.emplace_back(body.id, edit::Pose{pose->position + Position(pose->rotation * arm),
                                                   glm::normalize(pose->rotation * body.pose.rotation)});
        } else if (std::holds_alternative<edit::Scale>(edit)) {
            edits.emplace_back(body.id, edit);
            edits.emplace_back(body.id, edit::Pose{center + Position(arm * scaled), body.pose.rotation});
        } else {
            edits.emplace_back(body.id, edit);
        }
    }
    return edits;
}

} // namespace cairn::viewer
