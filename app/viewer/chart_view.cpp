#include "viewer/chart_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace cairn::viewer {

namespace {

// The axes of a chart with their place on the screen.
struct Frame {
    ChartAxis x, y;
    ImVec2 low, high; // lower left and upper right corner

    ImVec2 at(double vx, double vy) const {
        return {low.x + float(x.share(vx)) * (high.x - low.x), low.y + float(y.share(vy)) * (high.y - low.y)};
    }
};

void draw_legend(const Chart& chart, float width) {
    const float line = ImGui::GetTextLineHeight();
    const float left = ImGui::GetCursorPosX();
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        const Curve& curve = chart.curves[i];
        const float needs = 1.6f * line + ImGui::CalcTextSize(curve.label.c_str()).x;
        if (i > 0) {
            ImGui::SameLine(0.0f, line);
            if (ImGui::GetCursorPosX() + needs > left + width) ImGui::NewLine();
        }
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(corner.x, corner.y + 0.35f * line),
                                                  ImVec2(corner.x + 1.2f * line, corner.y + 0.65f * line),
                                                  chart_ink(curve.color), 2.0f);
        ImGui::Dummy(ImVec2(1.2f * line, line));
        ImGui::SameLine(0.0f, 0.4f * line);
        ImGui::TextUnformatted(curve.label.c_str());
    }
}

void draw_axes(const Chart& chart, const Frame& frame) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 grid = ImGui::GetColorU32(ImGuiCol_Border, 0.6f), text = ImGui::GetColorU32(ImGuiCol_Text, 0.8f);
    const float line = ImGui::GetTextLineHeight();
    const auto write = [&](const ImVec2& place, const std::string& words, float align) {
        const float width = ImGui::CalcTextSize(words.c_str()).x;
        list->AddText(ImVec2(place.x - align * width, place.y), text, words.c_str());
    };
    for (const ChartTick& tick : ticks_of(frame.x, std::max(int((frame.high.x - frame.low.x) / (5.0f * line)), 2))) {
        const float x = frame.low.x + float(frame.x.share(tick.value)) * (frame.high.x - frame.low.x);
        list->AddLine(ImVec2(x, frame.low.y), ImVec2(x, frame.high.y), grid);
        write(ImVec2(x, frame.low.y + 0.15f * line), tick.label, 0.5f);
    }
    for (const ChartTick& tick : ticks_of(frame.y, std::max(int((frame.low.y - frame.high.y) / (2.2f * line)), 2))) {
        const float y = frame.low.y + float(frame.y.share(tick.value)) * (frame.high.y - frame.low.y);
        list->AddLine(ImVec2(frame.low.x, y), ImVec2(frame.high.x, y), grid);
        write(ImVec2(frame.low.x - 0.3f * line, y - 0.5f * line), tick.label, 1.0f);
    }
    write(ImVec2(frame.high.x, frame.low.y + 1.2f * line), chart.x_label, 1.0f);
}

void draw_curve(const Curve& curve, const Frame& frame, const Chart& chart) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float unit = ImGui::GetTextLineHeight() / 15.0f;
    const ImU32 color = chart_ink(curve.color, curve.is_reference ? 150 : 255);
    std::vector<ImVec2> stroke;
    const auto end_stroke = [&] {
        if (stroke.size() > 1)
            list->AddPolyline(stroke.data(), int(stroke.size()), color, 0, (curve.is_reference ? 4.0f : 1.8f) * unit);
        stroke.clear();
    };
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const bool can_show = std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]) &&
                              (!chart.log_x || curve.x[i] > 0.0) && (!chart.log_y || curve.y[i] > 0.0);
        if (!can_show) {
            end_stroke();
            continue;
        }
        const ImVec2 point = frame.at(curve.x[i], curve.y[i]);
        // Points less than half a pixel apart are skipped, except the last one.
        const bool is_near = !stroke.empty() && std::abs(point.x - stroke.back().x) < 0.5f &&
                             std::abs(point.y - stroke.back().y) < 0.5f && i + 1 < curve.x.size();
        if (!is_near) stroke.push_back(point);
        if (curve.as_points) list->AddCircleFilled(point, 3.5f * unit, color);
    }
    end_stroke();
}

void show_values(const Chart& chart, const Frame& frame, float mouse) {
    const double x = frame.x.value(double((mouse - frame.low.x) / (frame.high.x - frame.low.x)));
    std::string text;
    char line[160];
    std::snprintf(line, sizeof line, "%s: %.4g", chart.x_label.c_str(), x);
    text = line;
    for (const Curve& curve : chart.curves) {
        if (curve.x.empty()) continue;
        const auto next = std::lower_bound(curve.x.begin(), curve.x.end(), x);
        std::size_t i = std::size_t(next - curve.x.begin());
        if (i == curve.x.size() || (i > 0 && x - curve.x[i - 1] < curve.x[i] - x)) --i;
        std::snprintf(line, sizeof line, "\n%s: %.5g", curve.label.c_str(), curve.y[i]);
        text += line;
    }
    ImGui::GetWindowDrawList()->AddLine(ImVec2(mouse, frame.low.y), ImVec2(mouse, frame.high.y),
                                        ImGui::GetColorU32(ImGuiCol_Text, 0.4f));
    ImGui::SetTooltip("%s", text.c_str());
}

bool is_sorted_by_x(const Chart& chart) {
    return std::all_of(chart.curves.begin(), chart.curves.end(),
                       [](const Curve& curve) { return std::is_sorted(curve.x.begin(), curve.x.end()); });
}

} // namespace

unsigned int chart_ink(std::uint32_t rgb, int alpha) {
    return IM_COL32(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255, alpha);
}

unsigned int word_ink(std::uint32_t rgb) {
    const ImVec4 text = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    const auto mixed = [](std::uint32_t part, float word) {
        constexpr float share = 0.6f; // share of the given color
        return share * float(part & 255) / 255.0f + (1.0f - share) * word;
    };
    return ImGui::ColorConvertFloat4ToU32(
        ImVec4(mixed(rgb >> 16, text.x), mixed(rgb >> 8, text.y), mixed(rgb, text.z), 1.0f));
}

std::optional<double> draw_chart(const char* id, const Chart& chart, float width, float height,
                                 std::optional<double> cursor) {
    const float line = ImGui::GetTextLineHeight();
    ImGui::TextUnformatted(chart.title.c_str());
    draw_legend(chart, width);
    ImGui::TextDisabled("%s", chart.y_label.c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, ImVec2(width, height));
    const bool is_hovered = ImGui::IsItemHovered(), is_clicked = ImGui::IsItemActive();
    Frame frame{x_axis(chart), y_axis(chart), {}, {}};
    float labels = 0.0f;
    for (const ChartTick& tick : ticks_of(frame.y, std::max(int(height / (2.2f * line)), 2)))
        labels = std::max(labels, ImGui::CalcTextSize(tick.label.c_str()).x);
    frame.low = ImVec2(corner.x + labels + 0.5f * line, corner.y + height - 2.4f * line);
    frame.high = ImVec2(corner.x + width - 0.8f * line, corner.y + 0.4f * line);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(ImVec2(frame.low.x, frame.high.y), ImVec2(frame.high.x, frame.low.y),
                        ImGui::GetColorU32(ImGuiCol_FrameBg, 0.35f));
    draw_axes(chart, frame);
    list->PushClipRect(ImVec2(frame.low.x, frame.high.y - 1.0f), ImVec2(frame.high.x + 1.0f, frame.low.y + 1.0f), true);
    for (const Curve& curve : chart.curves) draw_curve(curve, frame, chart);
    if (cursor) {
        const float x = frame.at(*cursor, frame.y.value(0.0)).x;
        list->AddLine(ImVec2(x, frame.low.y), ImVec2(x, frame.high.y), ImGui::GetColorU32(ImGuiCol_Text, 0.7f));
    }
    const float mouse = ImGui::GetIO().MousePos.x;
    const bool is_inside = mouse >= frame.low.x && mouse <= frame.high.x;
    if (is_hovered && is_inside && is_sorted_by_x(chart)) show_values(chart, frame, mouse);
    list->PopClipRect();
    if (!is_clicked || !is_inside) return std::nullopt;
    return frame.x.value(double((mouse - frame.low.x) / (frame.high.x - frame.low.x)));
}

} // namespace cairn::viewer
