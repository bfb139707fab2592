#include "viewer/plot_window.h"

#include "viewer/chart_view.h"
#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr std::pair<const char*, double> windows[] = {
    {"5 s", 5.0}, {"20 s", 20.0}, {"60 s", 60.0}, {"all", std::numeric_limits<double>::infinity()}};

std::string name_of_selected(const StageState& state) {
    for (const BodyLayout& body : state.layout->bodies)
        if (body.id == state.selected)
            return body.name.empty() ? "number " + std::to_string(body.id.index()) : '"' + body.name + '"';
    return {};
}

} // namespace

void PlotWindow::draw_choice(const StageState& state, Controller& controller) {
    const auto groups = plot_groups();
    ImGui::SetNextItemWidth(18.0f * ImGui::GetFontSize()); // fits the longest name
    if (ImGui::BeginCombo("##group", groups[std::size_t(group_)].name)) {
        for (int i = 0; i < int(groups.size()); ++i) {
            if (ImGui::Selectable(groups[std::size_t(i)].name, i == group_)) group_ = i;
            note_place(controller, ("plots.group" + std::to_string(i)).c_str());
        }
        ImGui::EndCombo();
    }
    note_place(controller, "plots.group");
    ImGui::SameLine();
    ImGui::TextUnformatted("against");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(8.5f * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##against", against_ ? name_of(*against_) : "time")) {
        if (ImGui::Selectable("time", !against_)) against_.reset();
        for (int i = 0; i < quantity_count; ++i)
            if (ImGui::Selectable(name_of(Quantity(i)), against_ == Quantity(i))) against_ = Quantity(i);
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(4.5f * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##window", windows[window_].first)) {
        for (int i = 0; i < int(std::size(windows)); ++i)
            if (ImGui::Selectable(windows[i].first, i == window_)) window_ = i;
        ImGui::EndCombo();
    }
    const bool needs_body = groups[std::size_t(group_)].is_of_body && !state.selected;
    if (needs_body) explain("Click a body: this plot is of the selected one.");
}

void PlotWindow::draw(const StageState& state, Controller& controller, float scale, float column, float room,
                      float bottom) {
    if (was_open_ != controller.plots) {
        was_open_ = controller.plots;
        controller.post(command::TakeSamples{was_open_});
    }
    if (!controller.plots) return;
    const float margin = 12.0f * scale;
    const float display = ImGui::GetIO().DisplaySize.y;
    const ImVec2 size(std::min(room - 2.0f * margin, 568.0f * scale), std::min(330.0f * scale, 0.6f * display));
    ImGui::SetNextWindowPos(ImVec2(column + margin, display - bottom - margin - size.y), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
    const bool is_open = ImGui::Begin("Plots (F3)", &controller.plots);
    keep_in_picture(column, bottom);
    if (is_open) {
        draw_choice(state, controller);
        const PlotGroup& group = plot_groups()[std::size_t(group_)];
        const Chart chart = sample_chart(state.samples, group, windows[window_].second, state.selected,
                                         name_of_selected(state), against_);
        const ImVec2 left = ImGui::GetContentRegionAvail();
        const float line = ImGui::GetTextLineHeightWithSpacing();
        const auto clicked = draw_chart(
            "##plot", chart, left.x, std::max(left.y - 4.0f * line - ImGui::GetFrameHeightWithSpacing(), 3.0f * line),
            against_ ? std::nullopt : std::optional(state.statistics.time));
        // A click seeks to that time.
        if (clicked && !against_ && !chart.curves.front().x.empty()) {
            const double behind = state.statistics.time - *clicked;
            const double step = double(state.timeline.now) - behind / state.time_step;
            controller.post(command::SeekTo{std::uint64_t(std::max(step, 0.0))});
        }
        std::string name = group.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        draw_export_buttons(controller, "plots", {{name, &chart}});
        controller.plotted = chart.curves.front().x.size();
    }
    ImGui::End();
}

} // namespace cairn::viewer
