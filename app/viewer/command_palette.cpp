#include "viewer/command_palette.h"

#include <imgui.h>

#include <algorithm>

namespace cairn::viewer {

void CommandPalette::draw(Controller& controller, float scale, float column, float room) {
    const bool opens = controller.palette && !was_open_;
    was_open_ = controller.palette;
    if (!controller.palette) return;
    if (opens) {
        commands_ = all_commands(controller);
        query_.fill('\0');
        chosen_ = 0;
    }
    const float width = std::min(460.0f * scale, room - 24.0f * scale), line = ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetNextWindowPos(ImVec2(column + 0.5f * room, 0.14f * ImGui::GetIO().DisplaySize.y), ImGuiCond_Always,
                            ImVec2(0.5f, 0.0f));
    ImGui::SetNextWindowSize(ImVec2(width, 13.0f * line + ImGui::GetFrameHeightWithSpacing()));
    if (opens) ImGui::SetNextWindowFocus();
    ImGui::Begin("##palette", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav);
    ImGui::SetNextItemWidth(-1.0f);
    if (opens) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputTextWithHint("##query", "what do you want to do?", query_.data(), query_.size())) chosen_ = 0;
    const bool has_left = !opens && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    const std::vector<std::size_t> found = matching(commands_, query_.data());
    const int last = int(found.size()) - 1;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) ++chosen_;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) --chosen_;
    chosen_ = std::clamp(chosen_, 0, std::max(last, 0));
    const bool is_entered = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                            ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
    int run = is_entered && last >= 0 ? chosen_ : -1;
    ImGui::BeginChild("##found");
    for (int i = 0; i <= last; ++i) {
        const NamedCommand& command = commands_[found[std::size_t(i)]];
        ImGui::PushID(i);
        if (ImGui::Selectable(command.name.c_str(), i == chosen_)) run = i;
        ImGui::PopID();
        if (i == chosen_ && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
        const float keys = ImGui::CalcTextSize(command.keys.c_str()).x;
        ImGui::SameLine(ImGui::GetContentRegionMax().x - keys - ImGui::GetStyle().ItemSpacing.x);
        ImGui::TextDisabled("%s", command.keys.c_str());
    }
    if (last < 0) ImGui::TextDisabled("no command of that name");
    ImGui::EndChild();
    ImGui::End();
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) || has_left) controller.palette = false;
    if (run < 0) return;
    controller.palette = false;
    commands_[found[std::size_t(run)]].run(controller);
}

} // namespace cairn::viewer
