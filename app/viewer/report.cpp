#include "viewer/report.h"

#include "viewer/joint_info.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace cairn::viewer {

namespace {

using Json = nlohmann::ordered_json;

template <class Vector> Json triple(const Vector& v) { return Json::array({v.x, v.y, v.z}); }

const char* name_of(BodyType type) {
    switch (type) {
    case BodyType::static_:
        return "static";
    case BodyType::kinematic:
        return "kinematic";
    case BodyType::dynamic:
        return "dynamic";
    }
    return "";
}

Json body_json(const StageState& state, std::size_t i, const OrbitCamera& camera, const WindowFacts& facts) {
    const BodyLayout& body = state.layout->bodies[i];
    const Position& position = state.current->transforms[i].position;
    Json json;
    json["index"] = body.id.index();
    json["name"] = body.name;
    json["type"] = name_of(body.type);
    json["position"] = triple(position);
    json["speed"] = state.current->speeds[i];
    json["awake"] = state.current->awake[i] != 0;
    const float aspect = float(facts.width) / float(std::max(facts.height, 1));
    if (const auto device = camera.project(position, aspect))
        json["screen"] = {float(facts.left) + (0.5f + 0.5f * device->x) * float(facts.width),
                          (0.5f - 0.5f * device->y) * float(facts.height)};
    return json;
}

Json joint_json(const StageState& state, std::size_t i, const OrbitCamera& camera, const WindowFacts& facts) {
    const JointLayout& joint = (*state.current->joints)[i];
    const JointState& now = state.current->joint_states[i];
    Json json;
    json["index"] = joint.id.index();
    json["name"] = joint.def.name;
    json["kind"] = cairn::viewer::name_of(joint.def.joint);
    json["positions"] = std::vector<float>(now.positions.begin(), now.positions.begin() + now.position_count);
    json["force"] = triple(now.force);
    json["torque"] = triple(now.torque);
    json["linear_error"] = now.linear_error;
    json["angular_error"] = now.angular_error;
    const float aspect = float(facts.width) / float(std::max(facts.height, 1));
    if (const auto device = camera.project(frames_of(joint, state.current->transforms).b.position, aspect))
        json["screen"] = {float(facts.left) + (0.5f + 0.5f * device->x) * float(facts.width),
                          (0.5f - 0.5f * device->y) * float(facts.height)};
    return json;
}

Json timeline_json(const TimelineState& timeline, const WindowFacts& facts) {
    Json json{{"first", timeline.first},
              {"last", timeline.last},
              {"now", timeline.now},
              {"backwards", timeline.is_backwards},
              {"recording", timeline.is_recording}};
    json["undoable"] = timeline.undoable ? Json(*timeline.undoable) : Json();
    json["redoable"] = timeline.redoable ? Json(*timeline.redoable) : Json();
    Json marks{{"impact", 0}, {"break", 0}, {"change", 0}};
    for (const Mark& mark : *timeline.marks) {
        Json& count = marks[mark.kind == Mark::Kind::impact   ? "impact"
                            : mark.kind == Mark::Kind::change ? "change"
                                                              : "break"];
        count = count.get<int>() + 1;
    }
    json["marks"] = marks;
    json["compared"] = timeline.verdict.compared;
    json["hashes"] = {timeline.verdict.here, timeline.verdict.there};
    json["first_different"] = timeline.verdict.first_different ? Json(*timeline.verdict.first_different) : Json();
    json["bar"] = {facts.bar_left, facts.bar_right, facts.bar_middle};
    return json;
}

Json other_json(const OtherRun& other) {
    Json json{{"parted_at", other.branched_at},
              {"bodies", other.picture.layout->bodies.size()},
              {"elsewhere", other.difference.elsewhere},
              {"farthest", other.difference.farthest}};
    Json positions = Json::array();
    for (const Transform& pose : other.picture.current->transforms) positions.push_back(triple(pose.position));
    json["positions"] = positions;
    return json;
}

Json gizmo_json(const StageState& state, const Controller& controller, const WindowFacts& facts) {
    Json json{{"mode", cairn::viewer::name_of(controller.gizmo.mode)}, {"handles", Json::array()}};
    if (!state.inspected) return json;
    const float aspect = float(facts.width) / float(std::max(facts.height, 1));
    for (const GizmoHandle handle : controller.gizmo.handles(*state.inspected))
        if (const auto device =
                controller.camera.project(controller.gizmo.grip(*state.inspected, controller.camera, handle), aspect))
            json["handles"].push_back({float(facts.left) + (0.5f + 0.5f * device->x) * float(facts.width),
                                       (0.5f - 0.5f * device->y) * float(facts.height)});
    return json;
}

// Left, top, right and bottom in the window, pixels.
Json frame_json(const Controller& controller, const WindowFacts& facts) {
    const auto frame = controller.selection_frame();
    if (!frame) return {};
    const auto x = [&](float device) { return float(facts.left) + (0.5f + 0.5f * device) * float(facts.width); };
    const auto y = [&](float device) { return (0.5f - 0.5f * device) * float(facts.height); };
    return {x(frame->low.x), y(frame->high.y), x(frame->high.x), y(frame->low.y)};
}

Json panes_json(const StageState& state, const WindowFacts& facts) {
    Json panes = Json::array();
    for (std::size_t i = 0; i < state.panes.size(); ++i) {
        const PaneState& pane = state.panes[i];
        Json json{{"settings", describe(pane.settings)},
                  {"energy", pane.energy},
                  {"bodies", pane.picture.layout->bodies.size()},
                  {"farthest", pane.difference.farthest},
                  {"trouble", pane.trouble}};
        if (i + 1 < facts.panes.size()) {
            const PaneRect& place = facts.panes[i + 1];
            json["place"] = {place.left, place.top, place.width, place.height};
        }
        panes.push_back(json);
    }
    return panes;
}

Json inspected_json(const BodyFacts& facts) {
    return {{"index", facts.id.index()},
            {"name", facts.name},
            {"type", name_of(facts.type)},
            {"rotation", {facts.rotation.w, facts.rotation.x, facts.rotation.y, facts.rotation.z}},
            {"trigger", facts.is_trigger},
            {"mass", facts.mass.mass},
            {"velocity", triple(facts.velocity)},
            {"static_friction", facts.shapes.empty() ? 0.0f : facts.shapes.front().material.static_friction},
            {"touches", facts.touches.size()}};
}

} // namespace

std::string report_json(const StageState& state, const Controller& controller, const WindowFacts& facts) {
    Json json;
    json["scene"] = {{"path", state.path}, {"title", state.title}, {"loads", state.scene_serial}};
    json["body_count"] = state.layout->bodies.size();
    std::size_t dynamic_count = 0;
    Json bodies = Json::array();
    for (std::size_t i = 0; i < state.layout->bodies.size(); ++i) {
        if (state.layout->bodies[i].type == BodyType::dynamic) ++dynamic_count;
        bodies.push_back(body_json(state, i, controller.camera, facts));
    }
    json["dynamic_count"] = dynamic_count;
    json["selected"] = state.selected ? Json(state.selected.index()) : Json();
    json["selection"] = Json::array();
    for (const BodyId body : state.selection) json["selection"].push_back(body.index());
    json["is_group"] = state.is_group;
    json["dragging"] = controller.dragging();
    json["frame"] = frame_json(controller, facts);
    json["paused"] = state.paused;
    json["frozen"] = state.frozen;
    json["pulled"] = state.pulled;
    json["force"] = triple(state.force);
    json["speed"] = state.speed;
    json["real_time_factor"] = state.real_time_factor;
    json["steps"] = state.statistics.steps;
    json["time"] = state.statistics.time;
    json["contacts"] = state.statistics.contacts;
    json["gravity"] = triple(state.settings.gravity);
    json["fields"] = state.fields.size();
    json["camera"] = {{"position", triple(controller.camera.position())},
                      {"target", triple(controller.camera.target())}};
    json["colors"] = cairn::viewer::name_of(controller.colors);
    json["grid"] = controller.grid;
    json["shadows"] = controller.shadows;
    json["visuals"] = controller.visuals;
    json["help"] = controller.help;
    json["panel"] = controller.panel;
    json["palette"] = controller.palette;
    json["light_theme"] = controller.light_theme;
    json["parallel"] = controller.camera.is_parallel();
    json["plots"] = {{"open", controller.plots}, {"samples", state.samples.size()}, {"shown", controller.plotted}};
    json["solver_shown"] = Json::array();
    for (const SolverPart& part : solver_parts())
        if (controller.solver.*part.shown) json["solver_shown"].push_back(part.name);
    if (state.current->solver && state.current->solver->difference)
        json["difference"] = {{"other", state.current->solver->difference->other.index()},
                              {"distance", state.current->solver->difference->gjk.distance}};
    if (state.current->solver && controller.solver.tree)
        json["tree"] = {{"depth", controller.solver.tree_depth}, {"boxes", state.current->solver->nodes.size()}};
    if (state.inspected) json["inspected"] = inspected_json(*state.inspected);
    json["integrators"] = controller.integrators;
    if (state.impact)
        json["impact"] = {{"step", state.impact->step},
                          {"with", state.impact->second.name},
                          {"impulse", state.impact->impulse},
                          {"given", state.impact->given}};
    json["gizmo"] = gizmo_json(state, controller, facts);
    json["panes"] = panes_json(state, facts);
    json["frames"] = facts.frames;
    json["frames_per_second"] = facts.frames_per_second;
    json["left"] = facts.left;
    json["scene_list"] = {{"lines", facts.scene_lines}, {"present_in_view", facts.scene_is_listed}};
    json["size"] = {facts.width, facts.height};
    json["notice"] = facts.notice;
    for (const auto& [name, place] : controller.places) json["places"][name] = {place.x, place.y};
    json["timeline"] = timeline_json(state.timeline, facts);
    if (state.other) json["other"] = other_json(*state.other);
    json["bodies"] = std::move(bodies);
    json["joints_shown"] = cairn::viewer::name_of(controller.joints);
    json["selected_joint"] = state.selected_joint ? Json(state.selected_joint.index()) : Json();
    json["joints"] = Json::array();
    for (std::size_t i = 0; i < state.current->joint_states.size(); ++i)
        json["joints"].push_back(joint_json(state, i, controller.camera, facts));
    return json.dump(1) + "\n";
}

} // namespace cairn::viewer
