#include "viewer/field_panel.h"

#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

namespace cairn::viewer {

namespace {

// The exponents that `ForceField` allows, in the order of their names.
constexpr std::array exponents{-2.0f, -1.0f, 0.0f, 1.0f};
constexpr std::array exponent_names{"~ 1 / distance^2", "~ 1 / distance", "constant", "~ distance"};

bool draw_radial(ForceField& field) {
    float center[] = {float(field.center.x), float(field.center.y), float(field.center.z)};
    bool changed = ImGui::DragFloat3("center", center, 0.02f, 0.0f, 0.0f, "%.2f");
    if (changed) field.center = Position(center[0], center[1], center[2]);
    changed |= ImGui::DragFloat("pull", &field.strength, 0.05f, 0.0f, 0.0f, field.is_force ? "%.2f N" : "%.2f m/s2");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("at a distance of 1 m; negative values repel");
    int exponent = int(std::find(exponents.begin(), exponents.end(), field.exponent) - exponents.begin());
    if (ImGui::Combo("strength", &exponent, exponent_names.data(), int(exponent_names.size()))) {
        field.exponent = exponents[std::size_t(exponent)];
        changed = true;
    }
    return changed;
}

bool draw_fluid(ForceField& field) {
    float center[] = {float(field.center.x), float(field.center.y), float(field.center.z)};
    bool changed = ImGui::DragFloat3("surface", center, 0.02f, 0.0f, 0.0f, "%.2f");
    if (changed) field.center = Position(center[0], center[1], center[2]);
    changed |= ImGui::DragFloat3("reach", &field.half_extents.x, 0.02f, 0.01f, 1000.0f, "%.2f");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("half sizes along the world axes from there, m; vertically: the depth");
    changed |= ImGui::DragFloat3("flow", &field.direction.x, 0.02f, 0.0f, 0.0f, "%.2f");
    changed |= ImGui::DragFloat("kg/m3", &field.density, 5.0f, 0.0f, 20000.0f, "%.0f");
    changed |= ImGui::DragFloat("drag", &field.drag, 0.01f, 0.0f, 100.0f, "%.2f");
    changed |= ImGui::DragFloat("skin", &field.skin_friction, 0.001f, 0.0f, 10.0f, "%.3f");
    changed |= ImGui::DragFloat("added mass", &field.added_mass, 0.01f, 0.0f, 10.0f, "%.2f");
    changed |= ImGui::DragFloat("waves", &field.wave_damping, 0.01f, 0.0f, 10.0f, "%.2f");
    return changed;
}

} // namespace

// Returns whether the field was changed.
bool FieldPanel::draw_field(Controller& controller, std::size_t index, bool& is_removed) {
    ForceField& field = fields_[index].second;
    const std::string place = "field." + std::to_string(index);
    bool changed = false;
    int kind = int(field.kind);
    constexpr std::array kinds{"uniform", "radial", "fluid"};
    if (ImGui::Combo("##kind", &kind, kinds.data(), int(kinds.size()))) {
        field.kind = ForceField::Kind(kind);
        changed = true;
    }
    ImGui::SameLine();
    is_removed = ImGui::Button("Remove");
    note_place(controller, (place + ".remove").c_str());
    if (field.kind == ForceField::Kind::uniform)
        changed |= ImGui::DragFloat3(field.is_force ? "N" : "m/s2", &field.direction.x, 0.05f, 0.0f, 0.0f, "%.2f");
    else if (field.kind == ForceField::Kind::radial)
        changed |= draw_radial(field);
    else
        changed |= draw_fluid(field);
    note_place(controller, (place + ".value").c_str());
    if (field.kind == ForceField::Kind::fluid) return changed;
    changed |= ImGui::Checkbox("force, independent of mass", &field.is_force);
    return changed;
}

void FieldPanel::draw(const StageState& state, Controller& controller) {
    const bool is_open = ImGui::CollapsingHeader("Force fields");
    note_place(controller, "panel.fields");
    if (!is_open) return;
    if (!ImGui::IsAnyItemActive()) fields_ = state.fields;
    if (fields_.empty()) explain("Force fields act on all dynamic bodies: wind, a magnet, a planet, water.");
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        ImGui::PushID(int(i));
        bool is_removed = false;
        const bool is_changed = draw_field(controller, i, is_removed);
        if (is_removed)
            controller.post(command::RemoveField{fields_[i].first});
        else if (is_changed)
            controller.post(command::SetField{fields_[i].first, fields_[i].second});
        ImGui::Separator();
        ImGui::PopID();
    }
    ForceField field;
    const bool wants_wind = ImGui::Button("Add wind");
    note_place(controller, "fields.wind");
    ImGui::SameLine();
    const bool wants_center = ImGui::Button("Add attraction");
    note_place(controller, "fields.attraction");
    ImGui::SameLine();
    const bool wants_water = ImGui::Button("Add water");
    note_place(controller, "fields.water");
    if (wants_water) {
        field.kind = ForceField::Kind::fluid;
        field.center = controller.camera.target();
    }
    if (wants_wind) field.direction = Vec3(2.0f, 0.0f, 0.0f);
    if (wants_center) {
        field.kind = ForceField::Kind::radial;
        field.center = controller.camera.target();
        field.strength = 5.0f;
    }
    if (wants_wind || wants_center || wants_water) controller.post(command::AddField{field});
}

} // namespace cairn::viewer
