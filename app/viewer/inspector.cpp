#include "viewer/inspector.h"

#include "viewer/items.h"

#include <glm/geometric.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace cairn::viewer {

namespace {

constexpr float inspector_width = 300.0f;
constexpr std::array type_names{"static", "kinematic", "dynamic"};

void fact(const char* name, const char* format, double value) {
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(0.44f * ImGui::GetWindowWidth());
    ImGui::Text(format, value);
}

// Drag widgets for the components of a vector. A value that would display as negative zero is shown as zero, and stays
// unchanged unless that component is edited.
template <class Vector> bool drag_axes(const char* name, Vector& value, float speed) {
    float shown[3], before[3];
    for (int axis = 0; axis < 3; ++axis) {
        shown[axis] = float(value[axis]);
        if (std::abs(shown[axis]) < 5e-4f) shown[axis] = 0.0f;
        before[axis] = shown[axis];
    }
    if (!ImGui::DragFloat3(name, shown, speed, 0.0f, 0.0f, "%.3f")) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (shown[axis] != before[axis]) value[axis] = shown[axis];
    return true;
}

} // namespace

void Inspector::draw_identity(const BodyFacts& facts, Controller& controller) {
    if (ImGui::InputText("name", name_.data(), name_.size(), ImGuiInputTextFlags_EnterReturnsTrue))
        controller.post(command::EditBody{facts.id, edit::Name{name_.data()}});
    note_place(controller, "inspector.name");
    int type = int(facts.type);
    if (ImGui::Combo("type", &type, type_names.data(), int(type_names.size())))
        controller.post(command::EditBody{facts.id, edit::Type{BodyType(type)}});
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "static: never moves; kinematic: moves as prescribed, regardless of forces; dynamic: moves by forces");
    bool is_trigger = facts.is_trigger;
    if (ImGui::Checkbox("trigger", &is_trigger))
        controller.post(command::EditBody{facts.id, edit::Trigger{is_trigger}});
    note_place(controller, "inspector.trigger");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("collides with nothing, and reports bodies that enter and leave");
    ImGui::SameLine();
    bool is_enabled = facts.is_enabled;
    if (ImGui::Checkbox("enabled", &is_enabled))
        controller.post(command::EditBody{facts.id, edit::Enabled{is_enabled}});
    note_place(controller, "inspector.enabled");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("a disabled body takes no part in the simulation: it is drawn as an outline, and its joints "
                          "have no effect");
    if (facts.type != BodyType::dynamic) return;
    if (ImGui::SliderFloat("mass", &edited_.mass.mass, 0.01f, 1e5f, "%.4g kg", ImGuiSliderFlags_Logarithmic) &&
        edited_.mass.mass > 0.0f)
        controller.post(command::EditBody{facts.id, edit::Mass{edited_.mass.mass}});
    note_place(controller, "inspector.mass");
    const Vec3 moments = facts.mass.inertia_diagonal;
    ImGui::TextDisabled("moments of inertia");
    ImGui::Text("   %.4g  %.4g  %.4g kg m2", double(moments.x), double(moments.y), double(moments.z));
}

void Inspector::draw_motion(const BodyFacts& facts, Controller& controller) {
    if (drag_axes("position", edited_.position, 0.01f))
        controller.post(command::EditBody{facts.id, edit::Place{edited_.position}});
    note_place(controller, "inspector.position");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("m, of the body's origin; drag to change, double-click to type");
    if (facts.type == BodyType::static_) return;
    if (drag_axes("velocity", edited_.velocity, 0.02f))
        controller.post(command::EditBody{facts.id, edit::Velocity{edited_.velocity}});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("m/s; drag to change, double-click to type");
    if (drag_axes("angular velocity", edited_.angular_velocity, 0.02f))
        controller.post(command::EditBody{facts.id, edit::Turning{edited_.angular_velocity}});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("rad/s, about the axes of the world");
    fact("speed", "%.4g m/s", double(glm::length(facts.velocity)));
    if (facts.type != BodyType::dynamic) return;
    fact("kinetic, linear", "%.4g J", facts.linear_energy);
    fact("kinetic, rotational", "%.4g J", facts.angular_energy);
    fact("potential energy", "%.4g J", facts.potential_energy);
    fact("state", !facts.is_enabled ? "disabled" : facts.is_awake ? "awake" : "asleep", 0.0);
}

void Inspector::draw_surface(const BodyFacts& facts, Controller& controller) {
    if (facts.shapes.empty() || !ImGui::CollapsingHeader("Material", ImGuiTreeNodeFlags_DefaultOpen)) return;
    Material& material = edited_.shapes.front().material;
    bool also_touched = false, changed = false;
    if (ImGui::BeginCombo("preset", "choose ...")) {
        for (const MaterialPreset& preset : material_presets()) {
            char line[96];
            std::snprintf(line, sizeof line, "%s   %.3g / %.3g", preset.name, double(preset.static_friction),
                          double(preset.dynamic_friction));
            if (!ImGui::Selectable(line)) continue;
            material = with_preset(material, preset);
            also_touched = changed = true;
        }
        ImGui::EndCombo();
    }
    note_place(controller, "inspector.presets");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Static / dynamic coefficients between two surfaces; they are set for this body and the "
                          "bodies it touches.\nSource: %s",
                          material_source());
    constexpr ImGuiSliderFlags clamped = ImGuiSliderFlags_AlwaysClamp;
    changed |= ImGui::SliderFloat("static friction", &material.static_friction, 0.0f, 1.5f, "%.2f", clamped);
    changed |= ImGui::SliderFloat("sliding friction", &material.dynamic_friction, 0.0f, 1.5f, "%.2f", clamped);
    changed |= ImGui::SliderFloat("restitution", &material.restitution, 0.0f, 1.0f, "%.2f", clamped);
    changed |= ImGui::SliderFloat("rolling friction", &material.rolling_friction, 0.0f, 0.1f, "%.4f m", clamped);
    if (changed) controller.post(command::EditBody{facts.id, edit::Surface{material, also_touched}});
    std::string shapes;
    for (const ShapeFacts& shape : facts.shapes)
        if (shapes.size() < 80) shapes += (shapes.empty() ? "" : ", ") + std::string(shape.kind);
    ImGui::TextDisabled("%zu %s", facts.shapes.size(), facts.shapes.size() == 1 ? "shape" : "shapes");
    ImGui::SameLine();
    ImGui::Text("%s", shapes.c_str());
}

void Inspector::draw_touches(const BodyFacts& facts, Controller& controller) {
    char title[48];
    std::snprintf(title, sizeof title, "Contacts (%zu)###touches", facts.touches.size());
    if (!ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (facts.touches.empty()) return ImGui::TextDisabled("no contacts");
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(facts.touches.size(), most); ++i) {
        const BodyFacts::Touch& touch = facts.touches[i];
        ImGui::PushID(int(i));
        if (ImGui::Selectable(touch.name.c_str())) controller.post(command::SelectBody{touch.other});
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("select this body");
        ImGui::PopID();
        ImGui::TextDisabled("   %d points, %.4g N, friction %.3g N", touch.points, double(touch.normal_force),
                            double(touch.friction_force));
    }
    if (facts.touches.size() > most) ImGui::TextDisabled("   and %zu more", facts.touches.size() - most);
}

// Buttons for a selection of one or several bodies.
void Inspector::draw_selection_buttons(Controller& controller) {
    if (ImGui::Button("Duplicate")) controller.post(command::DuplicateSelected{});
    note_place(controller, "inspector.duplicate");
    ImGui::SameLine();
    if (ImGui::Button("Delete (R)")) controller.post(command::RemoveSelected{});
    note_place(controller, "inspector.delete");
    for (int i = 1; i < gizmo_mode_count; ++i) {
        const bool is_on = controller.gizmo.mode == GizmoMode(i);
        constexpr std::array names{"", "Move", "Turn", "Scale"};
        if (is_on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        if (ImGui::Button(names[std::size_t(i)])) controller.gizmo.mode = is_on ? GizmoMode::none : GizmoMode(i);
        if (is_on) ImGui::PopStyleColor();
        note_place(controller, (std::string("inspector.") + name_of(GizmoMode(i))).c_str());
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("handles in the 3D view (Q)");
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

void Inspector::draw_buttons(Controller& controller) {
    draw_selection_buttons(controller);
    if (ImGui::Button("Plot (F3)")) controller.plots = true;
    ImGui::SameLine();
    if (ImGui::Button("Impact (F7)")) controller.impacts = true;
    note_place(controller, "inspector.impact");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("the last impact of this body, with the formula of its impulse (F7)");
}

// Data and edits of several selected bodies.
void Inspector::draw_several(const StageState& state, Controller& controller) {
    const std::vector<BodyId>& all = state.selection;
    fact("total mass", "%.4g kg", double(state.handled->mass.mass));
    if (ImGui::Button(state.is_group ? "Ungroup" : "Group")) {
        if (state.is_group)
            controller.post(command::UngroupSelected{});
        else
            controller.post(command::GroupSelected{});
    }
    note_place(controller, "inspector.group");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(state.is_group ? "End the group: a click selects one body again (Ctrl+Shift+G)"
                                         : "Group: a click on one body selects all (Ctrl+G)");
    draw_selection_buttons(controller);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("make all");
    for (std::size_t type = 0; type < type_names.size(); ++type) {
        ImGui::SameLine();
        if (ImGui::Button(type_names[type])) {
            command::EditBodies change;
            for (const BodyId body : all) change.edits.emplace_back(body, edit::Type{BodyType(type)});
            controller.post(std::move(change));
        }
        note_place(controller, (std::string("inspector.") + type_names[type]).c_str());
    }
    if (!ImGui::CollapsingHeader("Bodies", ImGuiTreeNodeFlags_DefaultOpen)) return;
    constexpr std::size_t most = 12;
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i) {
        const auto body = std::find_if(state.layout->bodies.begin(), state.layout->bodies.end(),
                                       [id = all[i]](const BodyLayout& known) { return known.id == id; });
        if (body == state.layout->bodies.end()) continue;
        ImGui::TextUnformatted(label_of(body->id, body->name).c_str());
        ImGui::SameLine(0.6f * ImGui::GetWindowWidth());
        ImGui::TextDisabled("%s", type_names[std::size_t(body->type)]);
    }
    if (all.size() > most) ImGui::TextDisabled("and %zu more", all.size() - most);
    explain("Shift+click adds or removes a body; Shift+drag beside bodies adds all bodies in a frame.");
}

// Synchronizes the fields with the body, unless a widget is active. Returns the window title.
std::string Inspector::follow(const StageState& state, Controller& controller) {
    controller.places.erase("inspector.name");
    const BodyFacts& facts = *state.inspected;
    if (edited_.id != facts.id || !ImGui::IsAnyItemActive()) {
        edited_ = facts;
        std::snprintf(name_.data(), name_.size(), "%s", facts.name.c_str());
    }
    if (state.selection.size() < 2) return label_of(facts.id, facts.name);
    const std::string count = std::to_string(state.selection.size()) + " bodies";
    return state.is_group ? "a group of " + count : count;
}

void Inspector::draw_content(const StageState& state, Controller& controller, float width) {
    const BodyFacts& facts = *state.inspected;
    ImGui::PushItemWidth(0.52f * width);
    if (state.selection.size() < 2) {
        draw_identity(facts, controller);
        draw_buttons(controller);
        draw_motion(facts, controller);
        draw_surface(facts, controller);
        draw_touches(facts, controller);
    } else {
        draw_several(state, controller);
    }
    ImGui::PopItemWidth();
}

void Inspector::draw(const StageState& state, Controller& controller, float scale, float top, float bottom,
                     float room) {
    controller.places.erase("inspector.name");
    if (!state.inspected || state.selected_joint || controller.dragging()) return;
    const std::string title = follow(state, controller) + "###body";
    const float width = inspector_width * scale, margin = 12.0f * scale;
    if (room < 1.3f * width) return; // the window is too small for both
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(display.x - margin, top), ImGuiCond_FirstUseEver, ImVec2(1.0f, 0.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f),
                                        ImVec2(width, std::max(display.y - top - bottom - 52.0f * scale, 64.0f)));
    bool is_open = true;
    ImGui::Begin(title.c_str(), &is_open, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    keep_in_picture(display.x - room, bottom);
    draw_content(state, controller, width);
    ImGui::End();
    if (!is_open) controller.post(command::SelectNothing{});
}

void Inspector::draw_in_column(const StageState& state, Controller& controller, float width, float height) {
    controller.places.erase("inspector.name");
    if (!state.inspected || state.selected_joint) return;
    const std::string title = follow(state, controller) + "###body in the column";
    ImGui::SetNextWindowPos(ImVec2(0.0f, ImGui::GetIO().DisplaySize.y - height));
    ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    bool is_open = true;
    ImGui::Begin(title.c_str(), &is_open,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar();
    draw_content(state, controller, width);
    ImGui::End();
    if (!is_open) controller.post(command::SelectNothing{});
}

} // namespace cairn::viewer
