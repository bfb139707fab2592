#include "viewer/help_window.h"

#include "viewer/items.h"
#include "viewer/key_map.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace cairn::viewer {

namespace {

// Widths of the two columns of the key map: the keys and their meanings.
struct HelpWidths {
    float keys = 0.0f, meanings = 0.0f;
};

HelpWidths help_widths(std::span<const KeyHelp> lines) {
    HelpWidths widths;
    for (const KeyHelp& line : lines) {
        widths.keys = std::max(widths.keys, ImGui::CalcTextSize(line.keys).x);
        widths.meanings = std::max(widths.meanings, ImGui::CalcTextSize(line.meaning).x);
    }
    return widths;
}

// Draws one column, and records the position of its last line under `name`.
void draw_help_column(Controller& controller, std::span<const KeyHelp> lines, float gap, const char* name) {
    const ImVec4 heading = controller.light_theme ? ImVec4(0.55f, 0.33f, 0.0f, 1.0f) : ImVec4(1.0f, 0.80f, 0.45f, 1.0f);
    const float width = help_widths(lines).keys;
    ImGui::BeginGroup();
    for (const KeyHelp& line : lines) {
        if (line.keys[0] == '\0') {
            ImGui::TextColored(heading, "%s", line.meaning);
            continue;
        }
        ImGui::TextUnformatted(line.keys);
        ImGui::SameLine(width + gap); // measured from the left edge of the group
        ImGui::TextUnformatted(line.meaning);
    }
    note_place(controller, name);
    ImGui::EndGroup();
}

} // namespace

// Covers the whole window including the panel. The text is in two columns, split at the heading that makes the longer
// one shortest, and is scaled down if the window is too small.
void draw_help(Controller& controller, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const std::span<const KeyHelp> lines = key_help();
    std::size_t parting = lines.size();
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i].keys[0] == '\0' && std::max(i, lines.size() - i) < std::max(parting, lines.size() - parting))
            parting = i;
    const auto left = lines.first(parting), right = lines.subspan(parting);
    const float gap = 16.0f * scale, between = 24.0f * scale;
    ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::Begin("Keys and mouse (F1 or Escape closes this)", &controller.help,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    ImGui::SetWindowFontScale(1.0f);
    const HelpWidths a = help_widths(left), b = help_widths(right);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = a.keys + a.meanings + b.keys + b.meanings; // widths that scale with the text; the gaps do not
    const float height = float(std::max(left.size(), right.size())) * ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 room(io.DisplaySize.x - 4.0f * style.WindowPadding.x - 2.0f * gap - between,
                      io.DisplaySize.y - 2.0f * style.WindowPadding.y - ImGui::GetFrameHeight());
    const float letters = std::min({1.0f, room.x / width, room.y / height});
    ImGui::SetWindowFontScale(letters);
    const ImVec2 left_over(room.x - letters * width, room.y - letters * height);
    ImGui::SetCursorPos(ImVec2(ImGui::GetCursorPosX() + 0.5f * std::max(left_over.x, 0.0f),
                               ImGui::GetCursorPosY() + 0.4f * std::max(left_over.y, 0.0f)));
    draw_help_column(controller, left, gap, "help.left");
    ImGui::SameLine(0.0f, between);
    draw_help_column(controller, right, gap, "help.right");
    ImGui::End();
}

} // namespace cairn::viewer
