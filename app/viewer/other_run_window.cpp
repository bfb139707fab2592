#include "viewer/other_run_window.h"

#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>
#include <string>

namespace cairn::viewer {

void draw_other_run(const StageState& state, Controller& controller, float scale, float column, float bottom) {
    for (const char* place : {"other.exchange", "other.end"})
        if (!state.other) controller.places.erase(place);
    if (!state.other) return;
    const OtherRun& other = *state.other;
    const float margin = 12.0f * scale;
    ImGui::SetNextWindowPos(ImVec2(column + margin, margin), ImGuiCond_FirstUseEver);
    ImGui::Begin("Two runs", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoCollapse);
    keep_in_picture(column, bottom);
    const double since = double(other.branched_at) - double(state.timeline.first);
    ImGui::Text("The transparent run continues as of %.2f s, without the changes.",
                std::max(since, 0.0) * state.time_step);
    const RunDifference& difference = other.difference;
    if (difference.elsewhere == 0) {
        ImGui::TextUnformatted("All bodies are at the same positions in both.");
    } else {
        std::string name;
        for (const BodyLayout& body : state.layout->bodies)
            if (body.id == difference.farthest_body) name = label_of(body.id, body.name);
        ImGui::Text("%zu %s at another position.", difference.elsewhere,
                    difference.elsewhere == 1 ? "body is" : "bodies are");
        if (!name.empty()) ImGui::Text("Farthest apart: %s, %.3g m", name.c_str(), difference.farthest);
    }
    if (ImGui::Button("Exchange")) controller.post(command::ExchangeRuns{});
    note_place(controller, "other.exchange");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("makes the other run the one that is changed and plotted (Ctrl+Shift+B)");
    ImGui::SameLine();
    if (ImGui::Button("End the other run")) controller.post(command::EndOtherRun{});
    note_place(controller, "other.end");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("this run remains (Shift+B)");
    ImGui::End();
}

} // namespace cairn::viewer
