#include "viewer/impact_window.h"

#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace cairn::viewer {

namespace {

std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string triple_text(const Vec3& vector) {
    const Vec3 v = vector + 0.0f; // removes negative zeros
    char text[64];
    std::snprintf(text, sizeof text, "(%.3g, %.3g, %.3g)", double(v.x), double(v.y), double(v.z));
    return text;
}

// Draws "before = numerator / denominator after" as a fraction.
void draw_fraction(const char* before, const std::string& numerator, const std::string& denominator,
                   const char* after) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight(), gap = 0.25f * line, pad = 0.4f * line;
    const float first = ImGui::CalcTextSize(before).x, upper = ImGui::CalcTextSize(numerator.c_str()).x;
    const float lower = ImGui::CalcTextSize(denominator.c_str()).x, width = std::max(upper, lower);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    const float left = corner.x + first + pad, middle = corner.y + line + gap;
    list->AddText(ImVec2(corner.x, middle - 0.5f * line), color, before);
    list->AddText(ImVec2(left + 0.5f * (width - upper), corner.y), color, numerator.c_str());
    list->AddLine(ImVec2(left, middle), ImVec2(left + width, middle), color, 1.0f);
    list->AddText(ImVec2(left + 0.5f * (width - lower), middle + gap), color, denominator.c_str());
    list->AddText(ImVec2(left + width + pad, middle - 0.5f * line), color, after);
    ImGui::Dummy(ImVec2(first + width + 2.0f * pad + ImGui::CalcTextSize(after).x, 2.0f * (line + gap)));
}

void add_row(const char* what, const std::string& first, const std::string& second) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(what);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(first.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(second.c_str());
}

void draw_sides(const Impact& impact) {
    if (!ImGui::BeginTable("sides", 3, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) return;
    const ImpactSide &a = impact.first, &b = impact.second;
    const auto mass = [](const ImpactSide& side) {
        return side.inverse_mass > 0.0 ? number_text(1.0 / side.inverse_mass) + " kg"
                                       : std::string("infinite: 1/m = 0");
    };
    add_row("", "1: " + a.name, "2: " + b.name);
    add_row("m", mass(a), mass(b));
    add_row("r, m", triple_text(a.arm), triple_text(b.arm));
    add_row("v before, m/s", triple_text(a.velocity), triple_text(b.velocity));
    add_row("w before, rad/s", triple_text(a.angular_velocity), triple_text(b.angular_velocity));
    add_row("pv = v + w x r  (4.16)", triple_text(a.at_point), triple_text(b.at_point));
    add_row("sN ((I^-1 (r x sN)) x r), 1/kg", number_text(a.turn_term), number_text(b.turn_term));
    add_row("v after  (4.12, 4.13)", triple_text(a.velocity_then), triple_text(b.velocity_then));
    add_row("v after, in this run", triple_text(a.velocity_after), triple_text(b.velocity_after));
    add_row("w after  (4.12, 4.13)", triple_text(a.turning_then), triple_text(b.turning_then));
    add_row("w after, in this run", triple_text(a.turning_after), triple_text(b.turning_after));
    ImGui::EndTable();
}

void draw_formula(const Impact& impact) {
    draw_fraction("j  =", "-(1 + e) vr", "1/m1 + 1/m2 + sN ((I1^-1 (r1 x sN)) x r1) + sN ((I2^-1 (r2 x sN)) x r2)",
                  "(4.14)");
    const std::string upper =
        "-(1 + " + number_text(impact.restitution) + ") (" + number_text(impact.relative_speed) + " m/s)";
    const std::string lower = "(" + number_text(impact.first.inverse_mass) + " + " +
                              number_text(impact.second.inverse_mass) + " + " + number_text(impact.first.turn_term) +
                              " + " + number_text(impact.second.turn_term) + ") 1/kg";
    draw_fraction("    =", upper, lower, ("=  " + number_text(impact.impulse) + " N s").c_str());
    ImGui::Text("vr = sN (pv1 - pv2) = %s m/s  (4.15),   sN = %s", number_text(impact.relative_speed).c_str(),
                triple_text(impact.normal).c_str());
    ImGui::Text("In this run, body 1 received %s N s along sN, excluding gravity.", number_text(impact.given).c_str());
}

} // namespace

void ImpactWindow::ask(const StageState& state, Controller& controller) {
    body_ = state.selected;
    now_ = state.timeline.now;
    controller.post(command::ExplainImpact{body_, partner_});
}

void ImpactWindow::draw_partner(const StageState& state, Controller& controller) {
    const auto name_of_body = [&](BodyId id) {
        for (const BodyLayout& body : state.layout->bodies)
            if (body.id == id) return label_of(id, body.name);
        return std::string("any body");
    };
    ImGui::SetNextItemWidth(11.0f * ImGui::GetFontSize());
    if (ImGui::BeginCombo("with", name_of_body(partner_).c_str())) {
        bool changed = false;
        if (ImGui::Selectable("any body", !partner_)) changed = true, partner_ = {};
        for (const BodyId partner : state.impact_partners)
            if (ImGui::Selectable(name_of_body(partner).c_str(), partner == partner_))
                changed = true, partner_ = partner;
        ImGui::EndCombo();
        if (changed) ask(state, controller);
    }
    ImGui::SameLine();
    if (ImGui::Button("Previous impact")) ask(state, controller);
    note_place(controller, "impact.last");
}

void ImpactWindow::draw(const StageState& state, Controller& controller, float scale, float column, float bottom) {
    if (!controller.impacts) {
        if (was_open_) controller.post(command::ExplainImpact{});
        was_open_ = false;
        return;
    }
    if (!was_open_ || body_ != state.selected) {
        if (body_ != state.selected) partner_ = {};
        was_open_ = true;
        ask(state, controller);
    }
    const float margin = 12.0f * scale;
    const float below_other = state.other ? 116.0f * scale : 0.0f; // the window of the second run is above
    ImGui::SetNextWindowPos(ImVec2(column + margin, margin + below_other), ImGuiCond_FirstUseEver);
    const bool is_open = ImGui::Begin("Impact (F7)", &controller.impacts, ImGuiWindowFlags_AlwaysAutoResize);
    keep_in_picture(column, bottom);
    if (is_open) {
        if (!state.selected) {
            ImGui::TextUnformatted("Click a body to see its last impact and how its impulse is computed.");
        } else {
            draw_partner(state, controller);
            if (!state.impact) ImGui::TextUnformatted("It has had no impact yet at 1 m/s or more.");
        }
        if (state.impact) {
            const Impact& impact = *state.impact;
            const double ago = (double(state.timeline.now) - double(impact.step) + 1.0) * state.time_step - impact.time;
            if (ImGui::Button("Play in slow motion")) controller.post(command::WatchImpact{});
            note_place(controller, "impact.watch");
            ImGui::SameLine();
            ago >= 0.0 ? ImGui::Text("%.3f s ago", ago) : ImGui::Text("in %.3f s", -ago);
            ImGui::SameLine();
            ImGui::TextDisabled("%.2f ms after the start of its step of %.2f ms", 1e3 * impact.time,
                                1e3 * state.time_step);
            draw_formula(impact);
            draw_sides(impact);
            explain("The formula is for two rigid bodies that touch in one point without friction. The run also has "
                    "friction, other contacts, and gravity during the step.");
        }
    }
    ImGui::End();
}

} // namespace cairn::viewer
