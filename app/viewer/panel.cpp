#include "viewer/panel.h"

#include "viewer/help_window.h"
#include "viewer/items.h"
#include "viewer/other_run_window.h"
#include "viewer/palette.h"
#include "viewer/solver_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr float panel_width = 300.0f;
constexpr float min_scene_lines = 5.5f; // the half line shows that the list continues

// A bar of the color ramp with a label at each end.
void draw_legend(Vec3 (*ramp)(float), const char* low, const char* high) {
    constexpr int pieces = 32;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = 0.8f * ImGui::GetTextLineHeight();
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (int i = 0; i < pieces; ++i) {
        const float from = float(i) / pieces, to = float(i + 1) / pieces;
        list->AddRectFilledMultiColor(ImVec2(corner.x + from * width, corner.y),
                                      ImVec2(corner.x + to * width, corner.y + height), display_color(ramp(from)),
                                      display_color(ramp(to)), display_color(ramp(to)), display_color(ramp(from)));
    }
    ImGui::Dummy(ImVec2(width, height));
    ImGui::TextUnformatted(low);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(high).x);
    ImGui::TextUnformatted(high);
}

void row(const char* name, const char* format, double value) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::Text(format, value);
}

// A text box no wider than the view, whose width is `room`. Returns the height of the box; 0 without text.
float draw_caption(const char* name, const std::string& text, const ImVec2& place, const ImVec2& pivot, float room) {
    if (text.empty()) return 0.0f;
    ImGui::SetNextWindowPos(place, ImGuiCond_Always, pivot);
    ImGui::SetNextWindowBgAlpha(0.72f);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    const float widest = room - 4.0f * ImGui::GetStyle().WindowPadding.x;
    // Measured from the window's left edge.
    ImGui::PushTextWrapPos(std::min(0.55f * ImGui::GetIO().DisplaySize.x, widest));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    const float height = ImGui::GetWindowHeight();
    ImGui::End();
    return height;
}

// Drawn below the windows, in the first view.
void draw_selection_frame(const Controller& controller, const WindowFacts& facts, float scale) {
    const auto frame = controller.selection_frame();
    if (!frame || facts.panes.empty()) return;
    const PaneRect& pane = facts.panes.front();
    const auto place = [&](float x, float y) {
        return ImVec2(pane.left + 0.5f * (1.0f + std::clamp(x, -1.0f, 1.0f)) * pane.width,
                      pane.top + 0.5f * (1.0f - std::clamp(y, -1.0f, 1.0f)) * pane.height);
    };
    const ImVec2 corner = place(frame->low.x, frame->high.y), opposite = place(frame->high.x, frame->low.y);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled(corner, opposite, IM_COL32(84, 158, 219, 40));
    list->AddRect(corner, opposite, IM_COL32(12, 30, 46, 200), 0.0f, 0, 3.0f * scale); // visible on bright pictures too
    list->AddRect(corner, opposite, IM_COL32(140, 200, 250, 255), 0.0f, 0, 1.5f * scale);
}

// Drawn over all windows, because it may explain why an action in one of them was refused. `place`: center of the lower
// edge.
void draw_notice(const std::string& text, const ImVec2& place, float room) {
    if (text.empty()) return;
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const float widest = room - 4.0f * padding.x;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest);
    const ImVec2 corner(std::round(place.x - 0.5f * size.x), std::round(place.y - padding.y - size.y));
    ImDrawList* list = ImGui::GetForegroundDrawList();
    const ImVec2 low(corner.x - padding.x, corner.y - padding.y), high(corner.x + size.x + padding.x, place.y);
    const float rounding = ImGui::GetStyle().WindowRounding;
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_WindowBg), rounding);
    list->AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border), rounding);
    list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner, ImGui::GetColorU32(ImGuiCol_Text), text.c_str(),
                  nullptr, widest);
}

std::string present_state(const StageState& state) {
    std::string text;
    const auto add = [&text](const char* word) { text += (text.empty() ? "" : "   ") + std::string(word); };
    if (state.paused) add("paused");
    if (state.timeline.is_backwards) add("backwards");
    if (state.speed != 1.0) {
        char speed[32];
        if (state.speed < 1.0)
            std::snprintf(speed, sizeof speed, "slow motion 1/%g", 1.0 / state.speed);
        else
            std::snprintf(speed, sizeof speed, "%g times as fast", state.speed);
        add(speed);
    }
    if (state.frozen) add("frozen");
    if (state.pulled) add("pulled to the center");
    if (state.force != Vec3(0.0f)) add("pushed");
    return text;
}

} // namespace

float interface_share(float width, float height) {
    constexpr float smallest = 0.75f, largest = 3.0f;
    return std::clamp(std::min(width / 1280.0f, height / 720.0f), smallest, largest);
}

void apply_style(float scale, bool is_light) {
    ImGuiStyle style;
    is_light ? ImGui::StyleColorsLight(&style) : ImGui::StyleColorsDark(&style);
    style.WindowRounding = 8.0f;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 4.0f;
    style.WindowPadding = ImVec2(12.0f, 10.0f);
    style.ItemSpacing = ImVec2(8.0f, 5.0f);
    style.WindowBorderSize = 1.0f; // separates windows of the same color
    // Overlapping windows are opaque. Text is drawn on hovered items and slider grabs, so these contrast with the text
    // color.
    ImVec4 hovered(0.17f, 0.36f, 0.52f, 1.0f), grab(0.24f, 0.47f, 0.67f, 1.0f), strong(0.33f, 0.62f, 0.86f, 1.0f);
    if (!is_light) {
        style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09f, 0.11f, 0.13f, 1.0f);
        style.Colors[ImGuiCol_TitleBg] = style.Colors[ImGuiCol_TitleBgActive] = ImVec4(0.12f, 0.15f, 0.18f, 1.0f);
        style.Colors[ImGuiCol_FrameBg] = ImVec4(0.20f, 0.23f, 0.27f, 1.0f);
        style.Colors[ImGuiCol_Header] = ImVec4(0.20f, 0.26f, 0.32f, 1.0f);
        style.Colors[ImGuiCol_Button] = ImVec4(0.22f, 0.30f, 0.38f, 1.0f);
        style.Colors[ImGuiCol_TextDisabled] = ImVec4(0.64f, 0.68f, 0.72f, 1.0f);
    } else {
        hovered = ImVec4(0.66f, 0.79f, 0.91f, 1.0f);
        grab = ImVec4(0.52f, 0.72f, 0.90f, 1.0f);
        strong = ImVec4(0.14f, 0.42f, 0.66f, 1.0f);
        style.Colors[ImGuiCol_WindowBg] = ImVec4(0.96f, 0.97f, 0.98f, 1.0f);
        style.Colors[ImGuiCol_TitleBg] = style.Colors[ImGuiCol_TitleBgActive] = ImVec4(0.86f, 0.89f, 0.92f, 1.0f);
        style.Colors[ImGuiCol_FrameBg] = ImVec4(0.84f, 0.87f, 0.90f, 1.0f);
        style.Colors[ImGuiCol_Header] = ImVec4(0.80f, 0.86f, 0.92f, 1.0f);
        style.Colors[ImGuiCol_Button] = ImVec4(0.76f, 0.84f, 0.92f, 1.0f);
        style.Colors[ImGuiCol_TextDisabled] = ImVec4(0.36f, 0.39f, 0.43f, 1.0f);
    }
    style.Colors[ImGuiCol_PopupBg].w = 1.0f;
    style.Colors[ImGuiCol_HeaderHovered] = style.Colors[ImGuiCol_ButtonHovered] = hovered;
    style.Colors[ImGuiCol_HeaderActive] = style.Colors[ImGuiCol_ButtonActive] = grab; // pressed or active
    style.Colors[ImGuiCol_SliderGrab] = grab;
    style.Colors[ImGuiCol_SliderGrabActive] = style.Colors[ImGuiCol_CheckMark] = strong;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

void Panel::draw_time(const StageState& state, Controller& controller) {
    if (ImGui::Button(state.paused ? "Run" : "Pause")) controller.post(command::TogglePause{});
    ImGui::SameLine();
    if (ImGui::Button("Step")) controller.post(command::SingleStep{});
    ImGui::SameLine();
    if (ImGui::Button("Reset")) controller.post(command::ResetScene{});
    ImGui::SameLine();
    if (ImGui::Button("Keys (F1)")) controller.help = !controller.help;
    ImGui::SameLine();
    if (ImGui::Button("Find")) controller.palette = true;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("any command, by its name (Ctrl+P)");
    if (ImGui::Button("Plots (F3)")) controller.plots = !controller.plots;
    ImGui::SameLine();
    if (ImGui::Button("Integrators (F4)")) controller.integrators = !controller.integrators;
    note_place(controller, "panel.integrators");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("explicit Euler, semi-implicit Euler and RK4 compared with the exact solution");
    ImGui::SameLine();
    if (ImGui::Button("Panes")) controller.panes = !controller.panes;
    note_place(controller, "panel.panes");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("the same scene with other settings, side by side (F6)");
    if (!ImGui::IsAnyItemActive()) speed_octave_ = float(std::log2(state.speed));
    char text[32];
    if (speed_octave_ < 0.0f)
        std::snprintf(text, sizeof text, "1/%.3g", std::exp2(-speed_octave_));
    else
        std::snprintf(text, sizeof text, "%.3g x", std::exp2(speed_octave_));
    if (ImGui::SliderFloat("speed", &speed_octave_, -5.0f, 3.0f, text, ImGuiSliderFlags_NoInput))
        controller.post(command::SetSpeed{std::exp2(double(speed_octave_))});
}

void Panel::draw_scenes(const StageState& state, Controller& controller) {
    if (!ImGui::CollapsingHeader("Scenes", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const auto& scenes = controller.scenes();
    if (scenes.empty()) return ImGui::TextDisabled("no scenes found");
    // The list scrolls, and takes the height that the rest of the column leaves.
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float room = (ImGui::GetWindowHeight() - other_height_) / line;
    const float lines_shown = std::min(float(scenes.size()), std::max(room, min_scene_lines));
    list_height_ = lines_shown * line;
    scene_lines_ = int(lines_shown);
    scene_is_listed_ = false;
    ImGui::BeginChild("scenes", ImVec2(0.0f, list_height_));
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        char label[160];
        if (i < 9)
            std::snprintf(label, sizeof label, "%zu  %s##%zu", i + 1, scenes[i].title.c_str(), i);
        else
            std::snprintf(label, sizeof label, "    %s##%zu", scenes[i].title.c_str(), i);
        const bool present = scenes[i].path == state.path;
        if (ImGui::Selectable(label, present)) controller.choose_scene(i);
        if (!present) continue;
        scene_is_listed_ = ImGui::IsItemVisible();
        // Also scrolls after the list has become shorter, but not while the user scrolls.
        if (shown_scene_ != state.path || shown_lines_ != scene_lines_) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
    shown_scene_ = state.path;
    shown_lines_ = scene_lines_;
}

void Panel::draw_settings(const StageState& state, Controller& controller) {
    if (!ImGui::CollapsingHeader("Settings")) return;
    bool changed = ImGui::SliderFloat3("gravity", &settings_.gravity.x, -20.0f, 20.0f, "%.2f");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("m/s^2; double-click to type");
    const std::string by_step = std::to_string(state.usual_substeps) + ", automatic";
    changed |= ImGui::SliderInt("substeps", &settings_.substeps, 0, 32,
                                settings_.substeps > 0 || state.settings.substeps > 0 ? "%d" : by_step.c_str(),
                                ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("0: as many as keep a substep at most 1/360 s long");
    changed |= ImGui::Checkbox("adaptive substeps", &settings_.adaptive_substeps);
    int integrator = int(settings_.integrator);
    constexpr std::array names{"semi-implicit Euler", "explicit Euler", "Runge-Kutta 4"};
    if (ImGui::Combo("integrator", &integrator, names.data(), int(names.size()))) {
        settings_.integrator = Integrator(integrator);
        changed = true;
    }
    changed |= ImGui::Checkbox("sleeping", &settings_.enable_sleep);
    if (changed) controller.post(command::SetSettings{settings_});
}

void Panel::draw_view(const StageState& state, Controller& controller) {
    if (!ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (ImGui::BeginCombo("colors", name_of(controller.colors))) {
        for (int i = 0; i < color_mode_count; ++i)
            if (ImGui::Selectable(name_of(ColorMode(i)), int(controller.colors) == i))
                controller.set_colors(ColorMode(i));
        ImGui::EndCombo();
    }
    char low[32], high[32];
    switch (controller.colors) {
    case ColorMode::mass:
        std::snprintf(low, sizeof low, "%.3g kg", double(state.layout->min_mass));
        std::snprintf(high, sizeof high, "%.3g kg", double(state.layout->greatest_mass));
        draw_legend(mass_ramp, low, high);
        break;
    case ColorMode::speed:
        std::snprintf(high, sizeof high, "%.0f m/s", double(fast_speed));
        draw_legend(speed_ramp, "at rest", high);
        break;
    case ColorMode::island:
        draw_swatch(sleeping_color(), "asleep");
        ImGui::TextUnformatted("awake: a color for each island");
        break;
    case ColorMode::shape: {
        bool is_left = true; // column of two
        for (const auto& [type, name] : {std::pair(ShapeType::sphere, "sphere"),
                                         {ShapeType::box, "box"},
                                         {ShapeType::capsule, "capsule"},
                                         {ShapeType::cylinder, "cylinder, cone"},
                                         {ShapeType::hull, "hull"},
                                         {ShapeType::mesh, "mesh"},
                                         {ShapeType::height_field, "height field"},
                                         {ShapeType::plane, "plane"}}) {
            if (!is_left) ImGui::SameLine(0.5f * ImGui::GetWindowWidth());
            is_left = !is_left;
            draw_swatch(shape_color(type), name);
        }
        break;
    }
    case ColorMode::scene:
        break;
    }
    ImGui::Checkbox("grid", &controller.grid);
    ImGui::SameLine();
    ImGui::Checkbox("shadows", &controller.shadows);
    if (!state.layout->visuals.empty()) ImGui::Checkbox("visual meshes", &controller.visuals);
}

void Panel::draw_spawn_tool(Controller& controller) {
    if (!ImGui::CollapsingHeader("Spawn tool")) return;
    SpawnSettings& tool = controller.tool;
    int kind = int(tool.kind);
    const auto name = [](void*, int i, const char** text) {
        *text = name_of(SpawnSettings::Kind(i));
        return true;
    };
    if (ImGui::Combo("shape", &kind, name, nullptr, spawn_kind_count)) tool.kind = SpawnSettings::Kind(kind);
    constexpr ImGuiSliderFlags clamped = ImGuiSliderFlags_AlwaysClamp;
    ImGui::SliderFloat("size", &tool.size, 0.05f, 5.0f, "%.2f m", clamped | ImGuiSliderFlags_Logarithmic);
    ImGui::SliderFloat("density", &tool.density, 1.0f, 20000.0f, "%.0f kg/m3", clamped | ImGuiSliderFlags_Logarithmic);
    ImGui::SliderFloat("friction", &tool.friction, 0.0f, 1.5f, "%.2f", clamped);
    ImGui::SliderFloat("bounce", &tool.restitution, 0.0f, 1.0f, "%.2f", clamped);
    ImGui::SliderFloat("shot speed", &tool.speed, 0.0f, greatest_shot_speed, "%.0f m/s", clamped);
    if (ImGui::Button("Drop")) {
        const Position above = controller.camera.target() + Position(0.0, 0.3 * controller.camera.distance(), 0.0);
        controller.post(command::Spawn{tool, above});
    }
    ImGui::SameLine();
    ImGui::TextDisabled("P shoots a %s", name_of(tool.kind));
}

void Panel::draw_statistics(const StageState& state, const WindowFacts& facts) {
    if (!ImGui::CollapsingHeader("Statistics", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const Statistics& s = state.statistics;
    if (!ImGui::BeginTable("statistics", 4)) return;
    row("bodies", "%.0f", double(s.bodies));
    row("awake", "%.0f", double(s.awake_bodies));
    row("contacts", "%.0f", double(s.contacts));
    row("islands", "%.0f", double(s.islands));
    row("step", "%.2f ms", state.step_milliseconds);
    row("fps", "%.0f", facts.frames_per_second);
    row("time", "%.1f s", s.time);
    row("real time", "%.2f x", state.real_time_factor); // measured, whatever speed is set
    ImGui::EndTable();
    if (!ImGui::TreeNode("stages of a step")) return;
    if (ImGui::BeginTable("stages", 2)) {
        row("broad phase", "%.3f ms", s.times.broad_phase);
        row("narrow phase", "%.3f ms", s.times.narrow_phase);
        row("islands", "%.3f ms", s.times.islands);
        row("prepare", "%.3f ms", s.times.prepare);
        row("solve", "%.3f ms", s.times.solve);
        row("finalize", "%.3f ms", s.times.finalize);
        ImGui::EndTable();
    }
    ImGui::TreePop();
}

float Panel::column_width(const Controller& controller, float scale, float window_width) {
    const float width = panel_width * scale;
    return controller.panel && 1.6f * width <= window_width ? width : 0.0f;
}

void Panel::draw(const StageState& state, Controller& controller, const WindowFacts& facts, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const float margin = 12.0f * scale;
    const float column = column_width(controller, scale, io.DisplaySize.x), room = io.DisplaySize.x - column;
    // With several panes, the inspector or joint window takes the lower half of the column.
    const bool is_shared = column > 0.0f && !state.panes.empty() && (state.inspected || state.selected_joint);
    const float below = is_shared ? std::round(0.5f * io.DisplaySize.y) : 0.0f;
    if (controller.panel) {
        if (!ImGui::IsAnyItemActive()) settings_ = state.settings;
        ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
        ImGui::SetNextWindowSize(ImVec2(panel_width * scale, io.DisplaySize.y - below));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
        ImGui::Begin("Cairn (F2 hides this)", nullptr,
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoSavedSettings);
        ImGui::PopStyleVar();
        ImGui::PushItemWidth(0.56f * panel_width * scale);
        list_height_ = 0.0f;
        draw_time(state, controller);
        panes_.draw_section(state, controller);
        draw_scenes(state, controller);
        draw_view(state, controller);
        draw_solver_section(state, controller);
        draw_statistics(state, facts);
        joints_.draw(state, controller);
        fields_.draw(state, controller);
        draw_settings(state, controller);
        draw_spawn_tool(controller);
        ImGui::PopItemWidth();
        other_height_ = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y - list_height_;
        ImGui::End();
    }
    draw_selection_frame(controller, facts, scale);
    const bool has_title = state.panes.empty(); // panes have captions instead
    const std::string title = has_title ? state.title + (state.hint.empty() ? "" : "\n" + state.hint) : "";
    const float title_height =
        draw_caption("##title", title, ImVec2(io.DisplaySize.x - margin, margin), ImVec2(1.0f, 0.0f), room);
    if (controller.panel)
        joints_.draw_selected(state, controller, scale, 2.0f * margin + title_height, bar_height_, room);
    const float bar = controller.panel ? timeline_.draw(state, controller, scale, column, room) : 0.0f;
    bar_height_ = bar;
    const float low = io.DisplaySize.y - margin - bar;
    draw_caption("##state", present_state(state), ImVec2(io.DisplaySize.x - margin, low), ImVec2(1.0f, 1.0f), room);
    draw_other_run(state, controller, scale, column, bar);
    if (is_shared)
        inspector_.draw_in_column(state, controller, column, below);
    else
        inspector_.draw(state, controller, scale, 2.0f * margin + title_height, bar, room);
    plots_.draw(state, controller, scale, column, room, bar);
    integrators_.draw(controller, scale, column, room, bar);
    impacts_.draw(state, controller, scale, column, bar);
    panes_.draw(state, controller, facts, scale);
    palette_.draw(controller, scale, column, room);
    if (controller.help) draw_help(controller, scale);
    draw_notice(facts.notice, ImVec2(column + 0.5f * room, low), room);
}

} // namespace cairn::viewer
