// Making and editing joints by hand.
#include "viewer/joint_info.h"
#include "viewer/stage.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr double join_distance = 1.0e8; // m; rays of an orthographic camera begin far away

Joint joint_of(command::JoinKind kind) {
    switch (kind) {
    case command::JoinKind::ball:
        return BallJoint{};
    case command::JoinKind::hinge:
        return HingeJoint{};
    case command::JoinKind::fixed:
        return FixedJoint{};
    }
    return FixedJoint{};
}

} // namespace

void Stage::operator()(const command::MakeJoint& make) {
    World& world = scene_.world;
    const auto hit = world.cast_ray(make.ray.origin, make.ray.direction, join_distance);
    if (!hit) return say("Point at a body to join it to the selected one, or to the world if none is selected.");
    BodyId body = hit->body;
    BodyId other = selected_ && selected_ != body && world.is_valid(selected_) ? selected_ : BodyId{};
    if (world.body(body).type() != BodyType::dynamic) {
        if (!other)
            return say("This body does not move: to join a body to it, select that body first, by clicking it.");
        std::swap(body, other);
    }
    selected_joint_ = world.create_joint(world.joint_at(other, body, hit->point, hit->normal, joint_of(make.kind)));
    refresh_joints();
    refresh_motion();
    say(std::string("Made a ") + name_of(world.joint_def(selected_joint_).joint) + " joint with " +
        (other ? "the selected body." : "the world."));
}

void Stage::operator()(const command::SelectJoint& select) {
    selected_joint_ = scene_.world.is_valid(select.joint) ? select.joint : JointId{};
}

void Stage::operator()(const command::SetJoint& joint) {
    scene_.world.set_joint(joint.joint, joint.values);
    refresh_joints();
    refresh_motion();
}

void Stage::operator()(const command::SetJointStrength& strength) {
    scene_.world.set_joint_strength(strength.joint, strength.break_force, strength.break_torque);
    refresh_joints();
    refresh_motion();
}

void Stage::operator()(const command::SetJointEnabled& change) {
    scene_.world.set_joint_enabled(change.joint, change.enabled);
    refresh_joints();
    refresh_motion();
}

// The solver of a joint is fixed at creation, so the joint is made anew.
void Stage::operator()(const command::SetJointSolver& solver) {
    JointDef def = scene_.world.joint_def(solver.joint);
    if (def.solver == solver.solver) return;
    def.solver = solver.solver;
    const JointId remade = scene_.world.create_joint(def);
    scene_.world.destroy_joint(solver.joint);
    if (selected_joint_ == solver.joint) selected_joint_ = remade;
    // The entry of the old joint is kept, because the old joint may return by time travel.
    for (std::size_t i = 0; i < scene_.strings.size(); ++i)
        if (scene_.strings[i].joint == solver.joint) scene_.strings.push_back({remade, scene_.strings[i].color});
    refresh_joints();
    refresh_motion();
}

void Stage::operator()(const command::RemoveJoint& joint) {
    if (!scene_.world.is_valid(joint.joint))
        return say("Select a joint first, by clicking one of its anchors or its line in the panel.");
    scene_.world.destroy_joint(joint.joint);
    refresh_joints();
    refresh_motion();
}

void Stage::report_broken() {
    bool any = false;
    for (const JointEvent& event : scene_.world.joint_events()) {
        any = true;
        if (!event.broke) continue;
        const auto joint = std::find_if(joints_->begin(), joints_->end(),
                                        [&](const JointLayout& known) { return known.id == event.joint; });
        const std::string label = joint == joints_->end() ? "A joint" : joint_label(joint->id, joint->def);
        char load[64];
        std::snprintf(load, sizeof load, " broke at %.4g N, %.4g N m.", double(event.force), double(event.torque));
        say(label + load);
    }
    if (any) refresh_joints();
}

void Stage::refresh_joints() {
    joints_ = std::make_shared<const std::vector<JointLayout>>(
        read_joints(scene_.world, *layout_, drag_joint_, scene_.strings));
    if (!scene_.world.is_valid(selected_joint_)) selected_joint_ = {};
}

} // namespace cairn::viewer
