#include "viewer/timeline_bar.h"

#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cairn::viewer {

namespace {

// Colors of marks, which must be visible on the track, on its past part, and on the bar.
struct BarColors {
    ImU32 track, past, impact, breaking, change, head, parting, same, different;
};
constexpr BarColors dark_colors{
    IM_COL32(52, 60, 70, 255),    IM_COL32(66, 104, 140, 255),  IM_COL32(240, 170, 70, 255),
    IM_COL32(240, 90, 80, 255),   IM_COL32(120, 200, 255, 255), IM_COL32(245, 248, 250, 255),
    IM_COL32(170, 205, 255, 255), IM_COL32(115, 217, 140, 255), IM_COL32(255, 102, 89, 255)};
constexpr BarColors light_colors{
    IM_COL32(206, 213, 220, 255), IM_COL32(150, 186, 216, 255), IM_COL32(176, 84, 0, 255),
    IM_COL32(200, 30, 30, 255),   IM_COL32(0, 86, 160, 255),    IM_COL32(20, 26, 32, 255),
    IM_COL32(60, 60, 170, 255),   IM_COL32(0, 110, 50, 255),    IM_COL32(190, 20, 20, 255)};
const BarColors& colors_of(const Controller& controller) { return controller.light_theme ? light_colors : dark_colors; }

constexpr float snap = 4.0f;            // unscaled units: distance within which the mouse snaps to a mark
constexpr float violent_impact = 20.0f; // m/s, approach speed whose mark fills the height of the track

enum class Icon { start, backwards, back, pause, play, forward, branch };

// A button with a drawn icon, independent of fonts.
bool icon_button(const char* name, Icon icon, const char* meaning, bool is_on = false) {
    const float side = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (is_on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool pressed = ImGui::Button(name, ImVec2(1.15f * side, side));
    if (is_on) ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", meaning);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    const float u = 0.14f * side;
    const ImVec2 c(corner.x + 0.575f * side, corner.y + 0.5f * side);
    const auto triangle = [&](float x, float towards) {
        list->AddTriangleFilled(ImVec2(c.x + x - towards * u, c.y - 1.6f * u),
                                ImVec2(c.x + x - towards * u, c.y + 1.6f * u),
                                ImVec2(c.x + x + 1.4f * towards * u, c.y), color);
    };
    const auto bar = [&](float x) {
        list->AddRectFilled(ImVec2(c.x + x - 0.45f * u, c.y - 1.6f * u), ImVec2(c.x + x + 0.45f * u, c.y + 1.6f * u),
                            color);
    };
    switch (icon) {
    case Icon::start:
        bar(-1.8f * u);
        triangle(0.4f * u, -1.0f);
        break;
    case Icon::backwards:
        triangle(0.0f, -1.0f);
        break;
    case Icon::back:
        triangle(-0.6f * u, -1.0f);
        bar(1.5f * u);
        break;
    case Icon::pause:
        bar(-u);
        bar(u);
        break;
    case Icon::play:
        triangle(0.0f, 1.0f);
        break;
    case Icon::forward:
        bar(-1.5f * u);
        triangle(0.6f * u, 1.0f);
        break;
    case Icon::branch:
        for (const float end : {-1.3f, 1.3f})
            list->AddLine(ImVec2(c.x - 0.4f * u, c.y), ImVec2(c.x + 2.0f * u, c.y + end * u), color, 0.6f * u);
        list->AddLine(ImVec2(c.x - 2.2f * u, c.y), ImVec2(c.x - 0.4f * u, c.y), color, 0.6f * u);
        break;
    }
    ImGui::SameLine(0.0f, 0.15f * side);
    return pressed;
}

std::string describe(const Mark& mark) {
    char text[64];
    switch (mark.kind) {
    case Mark::Kind::impact:
        std::snprintf(text, sizeof text, "impact at %.3g m/s", double(mark.strength));
        return text;
    case Mark::Kind::break_:
        std::snprintf(text, sizeof text, " broke at %.4g N", double(mark.strength));
        return mark.text + text;
    case Mark::Kind::change:
        break;
    }
    return mark.text;
}

} // namespace

float TimelineBar::place_of(const TimelineState& timeline, std::uint64_t step) const {
    const double length = double(std::max<std::uint64_t>(timeline.last - timeline.first, 1));
    const double behind = double(step) - double(timeline.first);
    return left_ + (right_ - left_) * float(std::clamp(behind / length, 0.0, 1.0));
}

std::uint64_t TimelineBar::step_at(const TimelineState& timeline, float x, float scale) const {
    for (auto mark = timeline.marks->rbegin(); mark != timeline.marks->rend(); ++mark)
        if (mark->kind != Mark::Kind::impact && std::abs(place_of(timeline, mark->step) - x) <= snap * scale)
            return std::min(mark->step, timeline.last);
    const double share = std::clamp(double((x - left_) / std::max(right_ - left_, 1.0f)), 0.0, 1.0);
    return timeline.first + std::uint64_t(std::llround(share * double(timeline.last - timeline.first)));
}

void TimelineBar::draw_buttons(const StageState& state, Controller& controller) {
    const bool is_backwards = state.timeline.is_backwards;
    if (icon_button("##start", Icon::start, "to the start")) controller.post(command::SeekTo{state.timeline.first});
    if (icon_button("##backwards", Icon::backwards, "run time backwards (Shift+Space)", is_backwards))
        controller.post(command::PlayBackwards{});
    if (icon_button("##back", Icon::back, "one step back (,)")) controller.post(command::StepBack{});
    if (icon_button("##pause", state.paused ? Icon::play : Icon::pause,
                    state.paused ? "resume (Space)" : "pause (Space)"))
        controller.post(command::TogglePause{});
    if (icon_button("##forward", Icon::forward, "one step (.)")) controller.post(command::SingleStep{});
    if (icon_button("##branch", Icon::branch,
                    "branch off: a new run from here; the original continues beside it, transparent (Ctrl+B)",
                    state.other.has_value()))
        controller.post(command::BranchOff{});
    note_place(controller, "timeline.branch");
}

void TimelineBar::draw_marks(const TimelineState& timeline, bool is_light, float top, float bottom, float scale) {
    const BarColors& colors = is_light ? light_colors : dark_colors;
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (const Mark& mark : *timeline.marks) {
        const float x = place_of(timeline, mark.step);
        if (mark.kind == Mark::Kind::impact) {
            const float height = std::clamp(mark.strength / violent_impact, 0.15f, 1.0f) * (bottom - top);
            list->AddLine(ImVec2(x, bottom - height), ImVec2(x, bottom), colors.impact, scale);
        } else {
            const float r = 4.0f * scale;
            const ImU32 color = mark.kind == Mark::Kind::break_ ? colors.breaking : colors.change;
            list->AddTriangleFilled(ImVec2(x - r, top - 1.2f * r), ImVec2(x + r, top - 1.2f * r),
                                    ImVec2(x, top + 0.6f * r), color);
        }
    }
}

void TimelineBar::draw_track(const StageState& state, Controller& controller, float width, float scale) {
    const TimelineState& timeline = state.timeline;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    left_ = corner.x;
    right_ = corner.x + width;
    middle_ = corner.y + 0.5f * height;
    ImGui::InvisibleButton("##track", ImVec2(width, height));
    const float mouse = ImGui::GetIO().MousePos.x;
    const std::uint64_t step = step_at(timeline, mouse, scale);
    if (ImGui::IsItemActivated() || (ImGui::IsItemActive() && step != asked_)) {
        asked_ = step;
        controller.post(command::SeekTo{step});
    }
    const float top = corner.y + 0.28f * height, bottom = corner.y + 0.86f * height;
    const BarColors& colors = colors_of(controller);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float head = place_of(timeline, timeline.now);
    list->AddRectFilled(ImVec2(left_, top), ImVec2(right_, bottom), colors.track, 3.0f * scale);
    list->AddRectFilled(ImVec2(left_, top), ImVec2(head, bottom), colors.past, 3.0f * scale);
    draw_marks(timeline, controller.light_theme, top, bottom, scale);
    if (state.other) {
        const float x = place_of(timeline, state.other->branched_at);
        list->AddLine(ImVec2(x, corner.y), ImVec2(x, corner.y + height), colors.parting, 2.0f * scale);
    }
    list->AddRectFilled(ImVec2(head - 1.5f * scale, corner.y), ImVec2(head + 1.5f * scale, corner.y + height),
                        colors.head, 1.5f * scale);
    if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
    char text[64];
    std::snprintf(text, sizeof text, "%.2f s", (double(step) - double(timeline.first)) * state.time_step);
    std::string tip = text;
    for (const Mark& mark : *timeline.marks)
        if (std::abs(place_of(timeline, mark.step) - mouse) <= 3.0f * scale && tip.size() < 300)
            tip += "\n" + describe(mark);
    ImGui::SetTooltip("%s", tip.c_str());
}

float TimelineBar::draw(const StageState& state, Controller& controller, float scale, float column, float room) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float height = ImGui::GetFrameHeight() + 2.0f * style.WindowPadding.y;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(column, display.y - height));
    ImGui::SetNextWindowSize(ImVec2(room, height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::Begin("##timeline", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    draw_buttons(state, controller);
    const TimelineState& timeline = state.timeline;
    char time[64];
    std::snprintf(time, sizeof time, "%.2f / %.2f s",
                  double(timeline.now - std::min(timeline.first, timeline.now)) * state.time_step,
                  double(timeline.last - timeline.first) * state.time_step);
    // The first hexadecimal digits of the hashes: of this run, and of the original or recorded run.
    char badge[64] = "";
    const auto first_digits = [](std::uint64_t hash) { return static_cast<unsigned>(hash >> 32); };
    if (timeline.verdict.first_different)
        std::snprintf(badge, sizeof badge, "bits differ: %08x, not %08x", first_digits(timeline.verdict.here),
                      first_digits(timeline.verdict.there));
    else if (timeline.verdict.compared > 0)
        std::snprintf(badge, sizeof badge, "same bits: %08x = %08x", first_digits(timeline.verdict.here),
                      first_digits(timeline.verdict.there));
    const float words =
        ImGui::CalcTextSize(time).x + (badge[0] ? ImGui::CalcTextSize(badge).x + style.ItemSpacing.x : 0.0f);
    const float width = std::max(ImGui::GetContentRegionAvail().x - words - style.ItemSpacing.x, 40.0f * scale);
    draw_track(state, controller, width, scale);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(time);
    if (badge[0]) {
        ImGui::SameLine();
        const bool differs = timeline.verdict.first_different.has_value();
        const ImU32 color = differs ? colors_of(controller).different : colors_of(controller).same;
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(color), "%s", badge);
        if (ImGui::IsItemHovered() && differs)
            ImGui::SetTooltip("The replay led to another state at step %llu.",
                              static_cast<unsigned long long>(*timeline.verdict.first_different));
        else if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%llu recomputed states are the same, bit for bit.",
                              static_cast<unsigned long long>(timeline.verdict.compared));
    }
    ImGui::End();
    return height;
}

} // namespace cairn::viewer
