#include "viewer/pane_window.h"

#include "viewer/integrators.h"
#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace cairn::viewer {

namespace {

constexpr std::array rates{15.0f, 30.0f, 60.0f, 120.0f, 240.0f, 480.0f}; // steps per second
constexpr std::array integrators{Integrator::semi_implicit_euler, Integrator::explicit_euler, Integrator::rk4};

std::string short_energy(double joules) {
    char text[32];
    if (std::abs(joules) >= 1e4)
        std::snprintf(text, sizeof text, "%.4g kJ", joules / 1e3);
    else
        std::snprintf(text, sizeof text, "%.4g J", joules);
    return text;
}

} // namespace

void PaneWindow::open(const StageState& state, Controller& controller) {
    scene_serial_ = state.scene_serial;
    const bool is_first_time = settings_.empty();
    first_ = {float(state.time_step), state.usual_substeps, state.settings.integrator, {}};
    if (is_first_time)
        for (const float factor : {0.5f, 0.25f, 2.0f}) {
            settings_.push_back(first_);
            settings_.back().step_length *= factor;
        }
    controller.post(command::SetPanes{settings_});
}

// Buttons for the most common comparisons.
bool PaneWindow::draw_varied(Controller& controller) {
    const auto vary = [&](const char* what, const char* place, auto&& change) {
        const bool is_chosen = ImGui::Button(what);
        note_place(controller, place);
        ImGui::SameLine();
        if (!is_chosen) return false;
        settings_.assign(most_panes - 1, first_);
        for (std::size_t i = 0; i < settings_.size(); ++i) change(settings_[i], i);
        return true;
    };
    bool changed = vary("step", "panes.step", [&](PaneSettings& pane, std::size_t i) {
        pane.step_length *= std::array{0.5f, 0.25f, 2.0f}[i];
    });
    changed |= vary("substeps", "panes.substeps", [](PaneSettings& pane, std::size_t i) {
        pane.substeps = std::array{1, 2, 16}[i];
    });
    changed |= vary("friction", "panes.friction", [](PaneSettings& pane, std::size_t i) {
        pane.friction = std::array{0.0f, 0.2f, 0.8f}[i];
    });
    if (vary("integrator", "panes.integrator", [](PaneSettings&, std::size_t) {})) {
        std::size_t next = 0;
        settings_.resize(integrators.size() - 1);
        for (const Integrator integrator : integrators)
            if (integrator != first_.integrator) settings_[next++].integrator = integrator;
        changed = true;
    }
    ImGui::NewLine();
    return changed;
}

bool PaneWindow::draw_settings(Controller& controller) {
    bool changed = false;
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < settings_.size(); ++i) {
        PaneSettings& pane = settings_[i];
        ImGui::PushID(int(i));
        ImGui::Separator();
        ImGui::SetNextItemWidth(5.5f * ImGui::GetFontSize());
        char label[32];
        std::snprintf(label, sizeof label, "1/%g s", double(std::round(1.0f / pane.step_length)));
        if (ImGui::BeginCombo("step", label)) {
            for (const float rate : rates) {
                std::snprintf(label, sizeof label, "1/%g s", double(rate));
                if (ImGui::Selectable(label, std::abs(pane.step_length * rate - 1.0f) < 1e-3f)) {
                    pane.step_length = 1.0f / rate;
                    changed = true;
                }
            }
            ImGui::EndCombo();
        }
        ImGui::SameLine();
        ImGui::SetNextItemWidth(3.5f * ImGui::GetFontSize());
        changed |= ImGui::SliderInt("substeps", &pane.substeps, 1, 32, "%d", ImGuiSliderFlags_AlwaysClamp);
        ImGui::SetNextItemWidth(11.5f * ImGui::GetFontSize());
        if (ImGui::BeginCombo("##integrator", name_of(pane.integrator))) {
            for (const Integrator integrator : integrators)
                if (ImGui::Selectable(name_of(integrator), pane.integrator == integrator)) {
                    pane.integrator = integrator;
                    changed = true;
                }
            ImGui::EndCombo();
        }
        ImGui::SameLine();
        if (ImGui::Button("Remove")) removed = i;
        if (i == 0) note_place(controller, "panes.remove");
        bool has_friction = pane.friction.has_value();
        if (ImGui::Checkbox("friction", &has_friction)) {
            pane.friction = has_friction ? std::optional(0.5f) : std::nullopt;
            changed = true;
        }
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("one value for all surfaces; otherwise those of the scene");
        if (pane.friction) {
            ImGui::SameLine();
            ImGui::SetNextItemWidth(5.0f * ImGui::GetFontSize());
            changed |=
                ImGui::SliderFloat("##friction", &*pane.friction, 0.0f, 1.5f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
        }
        ImGui::PopID();
    }
    if (removed && settings_.size() > 1) {
        settings_.erase(settings_.begin() + std::ptrdiff_t(*removed));
        changed = true;
    }
    if (settings_.size() + 1 < most_panes) {
        if (ImGui::Button("Add pane")) {
            settings_.push_back(first_);
            changed = true;
        }
        note_place(controller, "panes.add");
    }
    return changed;
}

void PaneWindow::draw_captions(const StageState& state, const WindowFacts& facts, float scale) const {
    if (state.panes.empty() || facts.panes.size() != state.panes.size() + 1) return;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const float margin = 8.0f * scale;
    for (std::size_t i = 0; i < facts.panes.size(); ++i) {
        std::string text;
        char line[96];
        if (i == 0) {
            text =
                "this run: " + describe({float(state.time_step), state.usual_substeps, state.settings.integrator, {}},
                                        state.settings.adaptive_substeps);
            text += "\nenergy " + short_energy(state.energy);
        } else {
            const PaneState& pane = state.panes[i - 1];
            text = describe(pane.settings) + "\nenergy " + short_energy(pane.energy);
            std::snprintf(line, sizeof line, ", farthest from this run %.3g m", pane.difference.farthest);
            text += line;
            if (!pane.trouble.empty()) text += "\nnot repeated: " + pane.trouble;
        }
        const PaneRect& place = facts.panes[i];
        const ImVec2 corner(place.left + margin, place.top + margin);
        const float wrap = place.width - 4.0f * margin;
        const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
        list->AddRectFilled(ImVec2(corner.x - 4.0f * scale, corner.y - 3.0f * scale),
                            ImVec2(corner.x + size.x + 4.0f * scale, corner.y + size.y + 3.0f * scale),
                            IM_COL32(18, 22, 26, 190), 4.0f * scale);
        list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner, IM_COL32(240, 243, 246, 255), text.c_str(),
                      nullptr, wrap);
    }
}

void PaneWindow::draw_section(const StageState& state, Controller& controller) {
    if (!controller.panes) return;
    bool is_open = true;
    if (ImGui::CollapsingHeader("Panes (F6)", &is_open, ImGuiTreeNodeFlags_DefaultOpen)) {
        const double began = double(state.panes_began) - double(state.timeline.first);
        ImGui::Text("From %.2f s on; Reset restarts them.", std::max(began, 0.0) * state.time_step);
        bool changed = draw_varied(controller);
        changed |= draw_settings(controller);
        if (changed) controller.post(command::SetPanes{settings_});
    }
    controller.panes = is_open;
}

void PaneWindow::draw(const StageState& state, Controller& controller, const WindowFacts& facts, float scale) {
    if (was_open_ != controller.panes) {
        was_open_ = controller.panes;
        was_open_ ? open(state, controller) : controller.post(command::SetPanes{});
    }
    if (!controller.panes) return;
    if (scene_serial_ != state.scene_serial) open(state, controller); // the step length may differ
    draw_captions(state, facts, scale);
}

} // namespace cairn::viewer
