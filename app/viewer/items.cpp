#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>

namespace cairn::viewer {

void note_place(Controller& controller, const char* name) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    controller.places.insert_or_assign(name, glm::vec2(0.5f * (low.x + high.x), 0.5f * (low.y + high.y)));
}

void draw_export_buttons(Controller& controller, const std::string& prefix,
                         const std::vector<std::pair<std::string, const Chart*>>& charts) {
    if (controller.svg_of_chart) {
        if (ImGui::Button("Save as SVG"))
            for (const auto& [name, chart] : charts)
                controller.exports.push_back({name, ".svg", controller.svg_of_chart(*chart)});
        note_place(controller, (prefix + ".svg").c_str());
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("a picture of each plot, for reports");
        ImGui::SameLine();
    }
    if (ImGui::Button("Save as CSV"))
        for (const auto& [name, chart] : charts) controller.exports.push_back({name, ".csv", chart_csv(*chart)});
    note_place(controller, (prefix + ".csv").c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("a table of each plot, for spreadsheets and programs");
}

void keep_in_picture(float column, float bottom) {
    const ImVec2 display = ImGui::GetIO().DisplaySize, place = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const ImVec2 kept(std::max(std::min(place.x, display.x - size.x), column),
                      std::max(std::min(place.y, display.y - bottom - size.y), 0.0f));
    if (kept.x != place.x || kept.y != place.y) ImGui::SetWindowPos(kept);
}

void explain(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

} // namespace cairn::viewer
