#include "viewer/joint_panel.h"

#include "viewer/joint_drawing.h"
#include "viewer/joint_info.h"
#include "viewer/palette.h"

#include <glm/geometric.hpp>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace cairn::viewer {

namespace {

constexpr float window_width = 290.0f;
constexpr float lines_in_list = 4.5f; // the half line shows that the list continues
constexpr float degree = 0.017453293f;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float max_degrees = 360.0f, max_meters = 5.0f; // range of the sliders; larger values can be typed
constexpr ImGuiSliderFlags at_least_zero = ImGuiSliderFlags_Logarithmic;

// A slider for a length or an angle, displayed in meters or degrees. Values beyond its range can be typed.
bool place_slider(const char* name, float& value, bool is_angle) {
    float shown = is_angle ? value / degree : value;
    const float most = is_angle ? max_degrees : max_meters;
    if (!ImGui::SliderFloat(name, &shown, -most, most, is_angle ? "%.1f deg" : "%.3f m")) return false;
    value = is_angle ? shown * degree : shown;
    return true;
}

bool rate_slider(const char* name, float& value, bool is_angle) {
    float shown = is_angle ? value / degree : value;
    const float most = is_angle ? 10.0f * max_degrees : 4.0f * max_meters;
    if (!ImGui::SliderFloat(name, &shown, -most, most, is_angle ? "%.0f deg/s" : "%.2f m/s")) return false;
    value = is_angle ? shown * degree : shown;
    return true;
}

bool positive_slider(const char* name, float& value, float least, float most, const char* format) {
    float shown = value;
    if (!ImGui::SliderFloat(name, &shown, least, most, format, at_least_zero)) return false;
    value = std::max(shown, 0.0f);
    return true;
}

// A force limit that may be infinite: a check box, and a slider while it is finite.
bool cap_slider(const char* check, const char* name, float& cap, bool is_torque) {
    bool is_bounded = std::isfinite(cap);
    bool changed = ImGui::Checkbox(check, &is_bounded);
    if (changed) cap = is_bounded ? 100.0f : infinity;
    if (is_bounded) changed |= positive_slider(name, cap, 0.1f, 1e6f, is_torque ? "%.4g N m" : "%.4g N");
    cap = std::max(cap, 1e-3f);
    return changed;
}

bool edit_spring(JointSpring& spring, bool is_angle) {
    bool changed = ImGui::Checkbox("as frequency", &spring.is_acceleration);
    if (changed) spring = spring.is_acceleration ? JointSpring::from_frequency(2.0f, 1.0f) : JointSpring{100.0f, 10.0f};
    if (!spring.is_acceleration) {
        changed |= positive_slider("stiffness", spring.stiffness, 0.01f, 1e6f, is_angle ? "%.4g N m/rad" : "%.4g N/m");
        changed |= positive_slider("damping", spring.damping, 0.001f, 1e5f, is_angle ? "%.4g N m s/rad" : "%.4g N s/m");
        return changed;
    }
    Swing swing = swing_of(spring);
    if (!(spring.stiffness > 0.0f)) { // a pure damper has no natural frequency
        changed |= positive_slider("damping", spring.damping, 0.001f, 1e3f, "%.4g 1/s");
        return changed;
    }
    bool moved = positive_slider("frequency", swing.hertz, 0.1f, 60.0f, "%.2f Hz");
    moved |=
        ImGui::SliderFloat("damping ratio", &swing.damping_ratio, 0.0f, 2.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    if (moved) spring = JointSpring::from_frequency(std::max(swing.hertz, 0.01f), std::max(swing.damping_ratio, 0.0f));
    return changed || moved;
}

// A check box for an optional spring, and its parameters.
bool edit_optional_spring(const char* name, std::optional<JointSpring>& spring, bool is_angle) {
    bool is_on = spring.has_value();
    bool changed = ImGui::Checkbox(name, &is_on);
    if (changed) spring = is_on ? std::optional(JointSpring::from_frequency(4.0f, 1.0f)) : std::nullopt;
    ImGui::PushID(name);
    if (spring) changed |= edit_spring(*spring, is_angle);
    ImGui::PopID();
    return changed;
}

bool edit_limits(std::optional<JointRange>& limits, bool is_angle, float now) {
    bool is_on = limits.has_value();
    bool changed = ImGui::Checkbox("limits", &is_on);
    const float room = is_angle ? 45.0f * degree : 0.5f;
    if (changed) limits = is_on ? std::optional(JointRange{now - room, now + room, {}}) : std::nullopt;
    if (!limits) return changed;
    ImGui::PushID("limits");
    // Horizontal position right of a check box with the longer label.
    const float beside = ImGui::GetCursorPosX() + 5.0f * ImGui::GetFontSize();
    for (const auto& [check, name, bound, free] :
         {std::tuple("from", "##from", &limits->lower, -infinity), {"to", "##to", &limits->upper, infinity}}) {
        bool is_bounded = std::isfinite(*bound);
        if (ImGui::Checkbox(check, &is_bounded)) {
            *bound = !is_bounded               ? free
                     : *bound == limits->lower ? std::min(now, limits->upper)
                                               : std::max(now, limits->lower);
            changed = true;
        }
        if (!is_bounded) continue;
        ImGui::SameLine(beside);
        if (!place_slider(name, *bound, is_angle)) continue;
        if (bound == &limits->lower)
            limits->upper = std::max(limits->lower, limits->upper);
        else
            limits->lower = std::min(limits->lower, limits->upper);
        changed = true;
    }
    changed |= edit_optional_spring("soft limits", limits->spring, is_angle);
    ImGui::PopID();
    return changed;
}

bool edit_motor(std::optional<JointMotor>& motor, bool is_angle, float now) {
    bool is_on = motor.has_value();
    bool changed = ImGui::Checkbox("motor", &is_on);
    if (changed) {
        motor.reset();
        if (is_on) motor = JointMotor{0.0f, now, {}, infinity};
    }
    if (!motor) return changed;
    ImGui::PushID("motor");
    changed |= rate_slider("velocity", motor->velocity, is_angle);
    changed |= edit_optional_spring("spring to position", motor->spring, is_angle);
    if (motor->spring) changed |= place_slider("position", motor->position, is_angle);
    changed |= cap_slider("limited force", "max. force", motor->max_force, is_angle);
    ImGui::PopID();
    return changed;
}

bool edit_control(JointControl& control, bool is_angle, float now) {
    bool changed = edit_limits(control.limits, is_angle, now);
    changed |= edit_motor(control.motor, is_angle, now);
    changed |= positive_slider("friction", control.friction, 0.0f, 1e4f, is_angle ? "%.3g N m" : "%.3g N");
    return changed;
}

// Parameters of the joint kinds without `JointControl`.
struct OwnValues {
    const JointState& now;

    bool operator()(BallJoint& joint) const {
        bool is_cone = joint.cone_angle.has_value();
        bool changed = ImGui::Checkbox("cone", &is_cone);
        if (changed) joint.cone_angle = is_cone ? std::optional(45.0f * degree) : std::nullopt;
        if (joint.cone_angle) {
            float shown = *joint.cone_angle / degree;
            if (ImGui::SliderFloat("half angle", &shown, 0.0f, 180.0f, "%.1f deg", ImGuiSliderFlags_AlwaysClamp)) {
                joint.cone_angle = std::min(shown * degree, 3.14159265f);
                changed = true;
            }
        }
        bool is_twist = joint.twist.has_value();
        if (ImGui::Checkbox("twist", &is_twist)) {
            joint.twist = is_twist ? std::optional(JointRange{-45.0f * degree, 45.0f * degree, {}}) : std::nullopt;
            changed = true;
        }
        if (joint.twist) {
            bool moved = place_slider("least", joint.twist->lower, true);
            moved |= place_slider("greatest", joint.twist->upper, true);
            if (joint.twist->lower > joint.twist->upper) std::swap(joint.twist->lower, joint.twist->upper);
            changed |= moved;
        }
        return positive_slider("friction", joint.friction, 0.0f, 1e4f, "%.3g N m") || changed;
    }
    bool operator()(ServoJoint& joint) const {
        bool changed = ImGui::SliderFloat3("position", &joint.position.x, -max_meters, max_meters, "%.2f");
        for (const auto& [name, spring, is_angle] :
             {std::tuple("linear", &joint.linear, false), {"angular", &joint.angular, true}}) {
            ImGui::TextUnformatted(name);
            ImGui::PushID(name);
            changed |= edit_spring(*spring, is_angle);
            changed |=
                cap_slider(is_angle ? "limited torque" : "limited force", is_angle ? "max. torque" : "max. force",
                           is_angle ? joint.max_torque : joint.max_force, is_angle);
            ImGui::PopID();
        }
        return changed;
    }
    bool operator()(GearJoint& joint) const { return factor("ratio", joint.ratio, 10.0f, "%.3f"); }
    bool operator()(RackJoint& joint) const { return factor("radius", joint.radius, 1.0f, "%.3f m"); }
    bool operator()(PulleyJoint& joint) const {
        bool changed = positive_slider("ratio", joint.ratio, 0.1f, 10.0f, "%.3f");
        joint.ratio = std::max(joint.ratio, 0.001f);
        float length = joint.length.value_or(now.position_count > 0 ? now.positions[0] : 1.0f);
        if (positive_slider("length", length, 0.1f, 50.0f, "%.3f m")) {
            joint.length = std::max(length, 0.001f);
            changed = true;
        }
        return changed;
    }
    bool operator()(GeneralJoint& joint) const {
        bool changed = false;
        for (std::size_t i = 0; i < joint.limits.size(); ++i) changed |= limit(joint.limits[i], int(i));
        for (std::size_t i = 0; i < joint.drives.size(); ++i) changed |= drive(joint.drives[i], int(i));
        return changed;
    }
    template <class Other> bool operator()(Other&) const { return false; }

  private:
    // A slider for a number other than 0.
    static bool factor(const char* name, float& value, float most, const char* format) {
        float shown = value;
        if (!ImGui::SliderFloat(name, &shown, -most, most, format) || shown == 0.0f) return false;
        value = shown;
        return true;
    }
    static bool limit(JointLimit& limit, int number) {
        const bool is_angle = limit.kind == JointAxis::angular;
        if (limit.min == 0.0f && limit.max == 0.0f) return false; // a lock
        char text[48];
        std::snprintf(text, sizeof text, "limit %s %s%s%s", is_angle ? "about" : "along", limit.axes[0] ? "x" : "",
                      limit.axes[1] ? "y" : "", limit.axes[2] ? "z" : "");
        ImGui::TextUnformatted(text);
        ImGui::PushID(number);
        bool changed = false;
        if (limit.min) changed |= place_slider("least", *limit.min, is_angle);
        if (limit.max) changed |= place_slider("greatest", *limit.max, is_angle);
        if (limit.min && limit.max && *limit.min > *limit.max) std::swap(*limit.min, *limit.max);
        if (limit.stiffness) {
            changed |= positive_slider("stiffness", *limit.stiffness, 0.01f, 1e6f, "%.4g");
            changed |= positive_slider("damping", limit.damping, 0.001f, 1e5f, "%.4g");
        }
        ImGui::PopID();
        return changed;
    }
    static bool drive(JointDrive& drive, int number) {
        const bool is_angle = drive.kind == JointAxis::angular;
        constexpr const char* axes[] = {"x", "y", "z"};
        ImGui::Text("drive %s %s", is_angle ? "about" : "along", axes[drive.axis]);
        ImGui::PushID(100 + number);
        bool changed = rate_slider("velocity", drive.velocity_target, is_angle);
        if (drive.stiffness > 0.0f) changed |= place_slider("position", drive.position_target, is_angle);
        JointSpring spring{drive.stiffness, drive.damping, drive.is_acceleration};
        if (edit_spring(spring, is_angle)) {
            drive.stiffness = spring.stiffness, drive.damping = spring.damping;
            drive.is_acceleration = spring.is_acceleration;
            changed = true;
        }
        float cap = drive.max_force.value_or(infinity);
        if (cap_slider("limited force", "max. force", cap, is_angle)) {
            drive.max_force = std::isfinite(cap) ? std::optional(cap) : std::nullopt;
            changed = true;
        }
        ImGui::PopID();
        return changed;
    }
};

bool edit_joint(Joint& joint, const JointState& now) {
    bool changed = false;
    const std::vector<JointAxisEdit> axes = joint_axes(joint);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const float place = int(i) < now.position_count ? now.positions[i] : 0.0f;
        if (axes.size() == 1) return edit_control(*axes[i].control, axes[i].is_angle, place);
        if (!ImGui::TreeNodeEx(axes[i].name, ImGuiTreeNodeFlags_DefaultOpen)) continue;
        changed |= edit_control(*axes[i].control, axes[i].is_angle, place);
        ImGui::TreePop();
    }
    return std::visit(OwnValues{now}, joint) || changed;
}

std::string body_label(const StageState& state, const std::optional<std::size_t>& body) {
    if (!body) return "the world";
    const BodyLayout& layout = state.layout->bodies[*body];
    return label_of(layout.id, layout.name);
}

} // namespace

void JointPanel::draw(const StageState& state, Controller& controller) {
    if (!state.current->joints || state.current->joints->empty()) return;
    const auto& joints = *state.current->joints;
    char title[48];
    std::snprintf(title, sizeof title, "Joints (%zu)###joints", joints.size());
    if (!ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (ImGui::BeginCombo("shown (T)", name_of(controller.joints))) {
        for (int i = 0; i < joints_shown_count; ++i)
            if (ImGui::Selectable(name_of(JointsShown(i)), int(controller.joints) == i))
                controller.joints = JointsShown(i);
        ImGui::EndCombo();
    }
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("blue: low load; yellow: about to break; red: has a gap; gray: disabled; white: selected");
    const float lines = std::min(float(joints.size()), lines_in_list);
    ImGui::BeginChild("joint list", ImVec2(0.0f, lines * ImGui::GetTextLineHeightWithSpacing()));
    ImGuiListClipper clipper; // draws only visible lines of a list that may have thousands
    clipper.Begin(int(joints.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const JointLayout& joint = joints[std::size_t(i)];
            const Vec3 color = srgb(joint_color(joint, state.current->joint_states[std::size_t(i)]));
            ImGui::PushID(i);
            ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(color.x, color.y, color.z, 1.0f));
            ImGui::Bullet();
            ImGui::PopStyleColor();
            ImGui::SameLine();
            const bool is_selected = joint.id == state.selected_joint;
            if (ImGui::Selectable(joint_label(joint.id, joint.def).c_str(), is_selected))
                controller.post(command::SelectJoint{joint.id});
            if (!joint.def.name.empty()) {
                ImGui::SameLine(0.62f * ImGui::GetWindowWidth());
                ImGui::TextDisabled("%s", name_of(joint.def.joint));
            }
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

void JointPanel::draw_facts(const StageState& state, const JointLayout& joint, const JointState& now) {
    ImGui::TextWrapped("%s joint of %s and %s", name_of(joint.def.joint), body_label(state, joint.body_a).c_str(),
                       body_label(state, joint.body_b).c_str());
    const std::vector<JointPosition> positions = joint_positions(joint.def.joint);
    for (std::size_t i = 0; i < positions.size() && int(i) < now.position_count; ++i) {
        const JointPosition& position = positions[i];
        const double factor = position.is_angle ? 1.0 / double(degree) : 1.0;
        ImGui::Text("%s  %.*f %s", position.name.c_str(), position.is_angle ? 1 : 3, factor * double(now.positions[i]),
                    position.is_angle ? "deg" : "m");
    }
    ImGui::Text("force %.4g N   torque %.4g N m", double(glm::length(now.force)), double(glm::length(now.torque)));
    ImGui::Text("error %.2f mm, %.2f deg", 1e3 * double(now.linear_error), double(now.angular_error / degree));
    if (const float load = joint_load(joint.def, now); load > 0.0f)
        ImGui::ProgressBar(std::min(load, 1.0f), ImVec2(-1.0f, 0.0f), "load / breaking load");
}

void JointPanel::draw_strength(Controller& controller) {
    bool enabled = edited_.enabled;
    if (ImGui::Checkbox("enabled", &enabled)) controller.post(command::SetJointEnabled{edited_id_, enabled});
    bool changed = cap_slider("breaks by force", "##force", edited_.break_force, false);
    changed |= cap_slider("breaks by torque", "##torque", edited_.break_torque, true);
    if (changed) controller.post(command::SetJointStrength{edited_id_, edited_.break_force, edited_.break_torque});
    int solver = int(edited_.solver);
    std::array<const char*, joint_solver_count> names{};
    for (int i = 0; i < joint_solver_count; ++i) names[std::size_t(i)] = name_of(JointSolver(i));
    if (ImGui::Combo("solver", &solver, names.data(), joint_solver_count))
        controller.post(command::SetJointSolver{edited_id_, JointSolver(solver)});
}

void JointPanel::draw_selected(const StageState& state, Controller& controller, float scale, float top, float bottom,
                               float room) {
    if (!state.selected_joint || !state.current->joints) return;
    const auto& joints = *state.current->joints;
    const auto selected = std::find_if(joints.begin(), joints.end(),
                                       [&](const JointLayout& joint) { return joint.id == state.selected_joint; });
    if (selected == joints.end()) return;
    const JointState& now = state.current->joint_states[std::size_t(selected - joints.begin())];
    if (edited_id_ != selected->id || !ImGui::IsAnyItemActive()) {
        edited_id_ = selected->id;
        edited_ = selected->def;
    }
    const ImGuiIO& io = ImGui::GetIO();
    const float width = window_width * scale, margin = 12.0f * scale;
    const bool fits = state.panes.empty() && room > 2.0f * (width + 2.0f * margin);
    const float height = fits ? io.DisplaySize.y - top - bottom - margin : 0.5f * io.DisplaySize.y;
    ImGui::SetNextWindowPos(fits ? ImVec2(io.DisplaySize.x - margin, top) : ImVec2(0.0f, io.DisplaySize.y),
                            fits ? ImGuiCond_Appearing : ImGuiCond_Always,
                            fits ? ImVec2(1.0f, 0.0f) : ImVec2(0.0f, 1.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, std::max(height, 64.0f)));
    const std::string title = joint_label(selected->id, selected->def) + "###joint";
    bool is_open = true;
    ImGui::Begin(title.c_str(), &is_open, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushItemWidth(0.52f * width);
    draw_facts(state, *selected, now);
    ImGui::Separator();
    if (edit_joint(edited_.joint, now)) controller.post(command::SetJoint{edited_id_, edited_.joint});
    ImGui::Separator();
    draw_strength(controller);
    if (ImGui::Button("Remove joint (D)")) controller.post(command::RemoveJoint{edited_id_});
    ImGui::PopItemWidth();
    ImGui::End();
    if (!is_open) controller.post(command::SelectJoint{});
}

} // namespace cairn::viewer
