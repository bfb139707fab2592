#include "viewer/integrator_window.h"

#include "viewer/chart_view.h"
#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace cairn::viewer {

namespace {

constexpr double seconds = 10.0; // simulated and shown time span
constexpr double tail = 1.0;     // s, length of the trail behind a body
// Half the width of the picture of the motion, in units of the system's size; trajectories beyond it are clipped.
constexpr double picture_half = 1.9;

} // namespace

void IntegratorWindow::compute() {
    if (computed_system_ == system_ && computed_rate_ == rate_) return;
    const double h = 1.0 / double(rate_);
    for (std::size_t i = 0; i < lab_integrators.size(); ++i)
        paths_[i] = trajectory(system_, lab_integrators[i], h, seconds);
    energies_ = energy_chart(system_, h, seconds);
    if (computed_system_ != system_) errors_ = error_chart(system_);
    computed_system_ = system_;
    computed_rate_ = rate_;
}

void IntegratorWindow::draw_controls(Controller& controller) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("system");
    for (const LabSystem system : lab_systems) {
        ImGui::SameLine();
        if (ImGui::RadioButton(name_of(system), system_ == system)) system_ = system, time_ = 0.0;
        note_place(controller, (std::string("integrators.") + name_of(system)).c_str());
    }
    ImGui::SameLine(0.0f, 2.0f * ImGui::GetFontSize());
    if (ImGui::Button(is_running_ ? "Pause##lab" : "Run##lab")) is_running_ = !is_running_;
    ImGui::SameLine();
    if (ImGui::Button("Restart")) time_ = 0.0, is_running_ = true;
    ImGui::SameLine(0.0f, 2.0f * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(9.0f * ImGui::GetFontSize());
    char text[32];
    std::snprintf(text, sizeof text, "1/%.0f s", double(rate_));
    ImGui::SliderFloat("step", &rate_, 15.0f, 960.0f, text,
                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    rate_ = std::round(rate_);
    ImGui::TextDisabled("%s", explanation_of(system_));
}

// The bodies as disks with their trails; the exact solution as a ring. A spring is horizontal, a pendulum hangs.
void IntegratorWindow::draw_motion(float width, float height) const {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(ImVec2(width, height));
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(corner, ImVec2(corner.x + width, corner.y + height),
                        ImGui::GetColorU32(ImGuiCol_FrameBg, 0.35f));
    list->PushClipRect(corner, ImVec2(corner.x + width, corner.y + height), true);
    const float unit = 0.5f * std::min(width, height) / float(picture_half), dot = 0.45f * ImGui::GetFontSize();
    const ImVec2 middle(corner.x + 0.5f * width, corner.y + 0.5f * height);
    const std::size_t lanes = system_ == LabSystem::spring ? lab_integrators.size() : 1;
    // Springs are drawn on separate lines, because on one line they would cover each other.
    const auto on_screen = [&](const LabState& state, std::size_t lane) {
        const auto place = drawn_place(system_, state);
        const float shift = lanes > 1 ? (float(lane) - 1.0f) * 0.24f * height : 0.0f;
        return ImVec2(middle.x + unit * float(place[0]), middle.y - unit * float(place[1]) + shift);
    };
    const ImU32 rod = ImGui::GetColorU32(ImGuiCol_Text, 0.35f);
    const LabState right = exact(system_, time_);
    for (std::size_t i = 0; i < lab_integrators.size(); ++i) {
        const std::vector<LabState>& path = paths_[i];
        const std::size_t now = std::min(std::size_t(time_ * double(rate_)), path.size() - 1);
        const std::size_t from = now - std::min(now, std::size_t(tail * double(rate_)));
        const std::uint32_t rgb = color_of(lab_integrators[i]);
        const ImVec2 pivot = system_ == LabSystem::spring ? ImVec2(corner.x, on_screen(path[now], i).y) : middle;
        if (system_ != LabSystem::spring)
            for (std::size_t k = from; k < now; ++k)
                list->AddLine(on_screen(path[k], i), on_screen(path[k + 1], i), chart_ink(rgb, 120),
                              0.12f * dot + 1.0f);
        const ImVec2 place = on_screen(path[now], i);
        if (system_ != LabSystem::orbit) list->AddLine(pivot, place, rod, 1.5f);
        if (lanes > 1 || i == 0)
            list->AddCircle(on_screen(right, i), 1.5f * dot, ImGui::GetColorU32(ImGuiCol_Text, 0.8f), 0,
                            0.16f * dot + 1.0f);
        list->AddCircleFilled(place, dot, chart_ink(rgb));
        const double away = std::hypot(drawn_place(system_, path[now])[0], drawn_place(system_, path[now])[1]);
        if (away > double(width) / double(2.0f * unit)) {
            const std::string words = std::string(name_of(lab_integrators[i])) + " has left the picture";
            const float y =
                lanes > 1 ? place.y + 1.8f * dot : corner.y + height - (2.0f + 1.2f * float(i)) * ImGui::GetFontSize();
            list->AddText(ImVec2(corner.x + width - 0.5f * dot - ImGui::CalcTextSize(words.c_str()).x, y),
                          word_ink(rgb), words.c_str());
        }
        if (lanes > 1)
            list->AddText(ImVec2(corner.x + 0.5f * dot, place.y - 1.6f * ImGui::GetFontSize()), word_ink(rgb),
                          name_of(lab_integrators[i]));
    }
    if (system_ == LabSystem::orbit) list->AddCircleFilled(middle, 1.3f * dot, IM_COL32(255, 214, 102, 255));
    list->PopClipRect();
    ImGui::TextDisabled("%.2f s; ring: the exact solution", time_);
}

// The observed errors in numbers.
void IntegratorWindow::draw_verdict() const {
    const double start = energy_of(system_, start_of(system_));
    for (std::size_t i = 0; i < lab_integrators.size(); ++i) {
        const std::vector<LabState>& path = paths_[i];
        const std::size_t now = std::min(std::size_t(time_ * double(rate_)), path.size() - 1);
        const double change = (energy_of(system_, path[now]) - start) / std::abs(start) * 100.0;
        const ImVec4 color = ImGui::ColorConvertU32ToFloat4(word_ink(color_of(lab_integrators[i])));
        ImGui::TextColored(color, "%s", name_of(lab_integrators[i]));
        ImGui::SameLine(12.0f * ImGui::GetFontSize());
        ImGui::Text(std::abs(change) < 100.0 ? "energy %+.3g %%" : "energy %+.0f %%",
                    std::abs(change) < 5e-7 ? 0.0 : change);
        ImGui::TextDisabled("   %s", formula_of(lab_integrators[i]));
    }
}

void IntegratorWindow::draw(Controller& controller, float scale, float column, float room, float bottom) {
    if (!controller.integrators) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float margin = 12.0f * scale;
    const ImVec2 size(std::min(room - 2.0f * margin, 940.0f * scale), display.y - bottom - 2.0f * margin);
    ImGui::SetNextWindowPos(ImVec2(column + 0.5f * room, margin), ImGuiCond_FirstUseEver, ImVec2(0.5f, 0.0f));
    ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
    const bool is_open = ImGui::Begin("Integrators side by side (F4)", &controller.integrators);
    keep_in_picture(column, bottom);
    if (is_open) {
        draw_controls(controller);
        compute();
        if (is_running_) time_ = std::min(time_ + double(std::min(ImGui::GetIO().DeltaTime, 0.1f)), seconds);
        const ImVec2 left = ImGui::GetContentRegionAvail();
        const float line = ImGui::GetTextLineHeightWithSpacing(), buttons = ImGui::GetFrameHeightWithSpacing();
        const float half = 0.5f * (left.x - ImGui::GetStyle().ItemSpacing.x);
        ImGui::BeginGroup();
        draw_motion(half, left.y - 7.6f * line - buttons); // leaves space for the numbers and buttons below
        draw_verdict();
        const std::string name = std::string("integrators_") + name_of(system_);
        draw_export_buttons(controller, "integrators", {{name + "_energy", &energies_}, {name + "_error", &errors_}});
        ImGui::EndGroup();
        ImGui::SameLine();
        ImGui::BeginGroup();
        const float height = 0.5f * (left.y - 9.0f * line); // leaves space for titles and legends
        if (const auto clicked = draw_chart("##energy", energies_, half, height, time_))
            time_ = std::clamp(*clicked, 0.0, seconds), is_running_ = false;
        draw_chart("##error", errors_, half, height);
        ImGui::EndGroup();
    }
    ImGui::End();
}

} // namespace cairn::viewer
