#include "viewer/window_places.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cstdio>

namespace cairn::viewer {

namespace {

constexpr char section[] = "Picture";

// The size for which the windows are placed; 0 if it is not known.
ImVec2& placed_for() {
    static ImVec2 size;
    return size;
}

ImVec2 moved(ImVec2 place, ImVec2 size, ImVec2 before, ImVec2 now) {
    if (place.x + 0.5f * size.x > 0.5f * before.x) place.x += now.x - before.x;
    if (place.y + 0.5f * size.y > 0.5f * before.y) place.y += now.y - before.y;
    return place;
}

void* begin_section(ImGuiContext*, ImGuiSettingsHandler*, const char*) { return &placed_for(); }
void read_line(ImGuiContext*, ImGuiSettingsHandler*, void*, const char* line) {
    ImVec2 size;
    if (std::sscanf(line, "Size=%f,%f", &size.x, &size.y) == 2 && size.x > 0 && size.y > 0) placed_for() = size;
}
void move_places_read(ImGuiContext* context, ImGuiSettingsHandler*) {
    const ImVec2 before = placed_for(), now = context->IO.DisplaySize;
    if (!(before.x > 0) || !(now.x > 0)) return;
    for (ImGuiWindowSettings* s = context->SettingsWindows.begin(); s; s = context->SettingsWindows.next_chunk(s)) {
        const ImVec2 place = moved(ImVec2(s->Pos.x, s->Pos.y), ImVec2(s->Size.x, s->Size.y), before, now);
        s->Pos = ImVec2ih(short(place.x), short(place.y));
    }
    placed_for() = now;
}
void write_section(ImGuiContext* context, ImGuiSettingsHandler*, ImGuiTextBuffer* text) {
    text->appendf("[%s][]\nSize=%.0f,%.0f\n\n", section, double(context->IO.DisplaySize.x),
                  double(context->IO.DisplaySize.y));
}

} // namespace

void remember_picture_size() {
    placed_for() = ImVec2();
    ImGuiSettingsHandler handler;
    handler.TypeName = section;
    handler.TypeHash = ImHashStr(section);
    handler.ReadOpenFn = begin_section;
    handler.ReadLineFn = read_line;
    handler.ApplyAllFn = move_places_read;
    handler.WriteAllFn = write_section;
    ImGui::GetCurrentContext()->SettingsHandlers.push_back(handler);
}

void follow_picture_size() {
    const ImVec2 before = placed_for(), now = ImGui::GetIO().DisplaySize;
    placed_for() = now;
    if (!(before.x > 0) || (before.x == now.x && before.y == now.y)) return;
    for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        constexpr ImGuiWindowFlags fixed =
            ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_ChildWindow;
        if (window->Flags & fixed) continue;
        ImGui::SetWindowPos(window, moved(window->Pos, window->SizeFull, before, now));
    }
    ImGui::MarkIniSettingsDirty();
}

} // namespace cairn::viewer
