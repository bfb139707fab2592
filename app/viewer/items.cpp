#include "viewer/items.h"

#include "viewer/palette.h"

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
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("an image of each plot, for reports");
        ImGui::SameLine();
    }
    if (ImGui::Button("Save as CSV"))
        for (const auto& [name, chart] : charts) controller.exports.push_back({name, ".csv", chart_csv(*chart)});
    note_place(controller, (prefix + ".csv").c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("a table of each plot, for spreadsheets and programs");
}

void keep_in_picture(float column, float bottom) {
    // A window that has just appeared has no size yet if it fits its content, and may be positioned by a corner other
    // than its top left; moving it now would fix a wrong position.
    if (ImGui::IsWindowAppearing()) return;
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

unsigned display_color(const Vec3& linear) {
    const Vec3 color = srgb(linear);
    return ImGui::ColorConvertFloat4ToU32(ImVec4(color.x, color.y, color.z, 1.0f));
}

void draw_swatch(const Vec3& color, const char* meaning) {
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(corner, ImVec2(corner.x + side, corner.y + side), display_color(color),
                                              3.0f);
    ImGui::Dummy(ImVec2(side, side));
    ImGui::SameLine();
    ImGui::TextUnformatted(meaning);
}

bool draw_link(const char* text, const char* meaning) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    const bool is_hovered = ImGui::IsItemHovered();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (is_hovered) {
        ImGui::GetWindowDrawList()->AddLine(ImVec2(low.x, high.y), high, ImGui::GetColorU32(ImGuiCol_CheckMark));
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        ImGui::SetTooltip("%s", meaning);
    }
    return is_hovered && ImGui::IsMouseClicked(0);
}

} // namespace cairn::viewer
