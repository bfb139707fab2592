#include "viewer/solver_panel.h"

#include "viewer/items.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr std::size_t most_lines = 12; // of a legend

// The depth slider, and a legend of the box colors.
void draw_tree_choice(const StageState& state, Controller& controller, SolverShown& shown) {
    ImGui::SliderInt("depth", &shown.tree_depth, 0, greatest_tree_depth, "%d", ImGuiSliderFlags_AlwaysClamp);
    note_place(controller, "solver.depth");
    if (!state.current->solver) return;
    const std::vector<BroadPhaseNode>& nodes = state.current->solver->nodes;
    std::array<int, greatest_tree_depth + 1> count{};
    int shapes = 0;
    for (const BroadPhaseNode& node : nodes) ++count[std::size_t(node.depth)], shapes += node.is_leaf;
    for (int depth = 0; depth <= greatest_tree_depth; ++depth) {
        if (count[std::size_t(depth)] == 0) continue;
        char text[64];
        std::snprintf(text, sizeof text, "%d%s: %d %s", depth, depth == 0 ? ", the roots" : "",
                      count[std::size_t(depth)], count[std::size_t(depth)] == 1 ? "box" : "boxes");
        draw_swatch(tree_color(depth), text);
    }
    if (nodes.empty())
        ImGui::TextUnformatted("Empty: planes are not in trees.");
    else
        ImGui::Text("%d leaves, of one shape each", shapes);
}

// A legend line for each group of contacts: its color, name, and number.
template <class Name> void draw_contact_legend(const std::map<int, int>& counts, Vec3 (*color)(int), const Name& name) {
    if (counts.empty()) ImGui::TextUnformatted("No contacts.");
    std::size_t lines = 0;
    for (const auto& [group, count] : counts) {
        if (++lines > most_lines) {
            ImGui::Text("and %zu more", counts.size() - most_lines);
            break;
        }
        draw_swatch(color(group), (name(group) + ": " + std::to_string(count)).c_str());
    }
}

void draw_contact_order(const SolverView& view, const SolverShown& shown, bool SolverShown::*part) {
    std::map<int, int> counts;
    if (part == &SolverShown::colors && shown.colors) {
        for (const SolverView::Solved& contact : view.solved) ++counts[contact.color];
        draw_contact_legend(counts, contact_color, [](int color) {
            return color < 0 ? std::string("no color free: solved serially") : "color " + std::to_string(color);
        });
    } else if (part == &SolverShown::substeps && shown.substeps) {
        for (const SolverView::Solved& contact : view.solved) ++counts[contact.substeps];
        draw_contact_legend(counts, substep_color, [](int substeps) {
            return substeps == 0 ? std::string("asleep from the start")
                                 : std::to_string(substeps) + (substeps == 1 ? " substep" : " substeps");
        });
    }
}

} // namespace

void draw_solver_section(const StageState& state, Controller& controller) {
    const bool is_open = ImGui::CollapsingHeader("Solver data");
    note_place(controller, "panel.solver");
    if (!is_open) return;
    SolverShown shown = controller.solver;
    const SolverView* view = state.current->solver.get();
    for (const SolverPart& part : solver_parts()) {
        ImGui::Checkbox(part.name, &(shown.*part.shown));
        note_place(controller, (std::string("solver.") + part.name).c_str());
        if (!(shown.*part.shown)) continue;
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize("docs").x);
        if (draw_link("docs", (std::string("opens docs/") + part.page).c_str())) controller.page = part.page;
        note_place(controller, (std::string("page.") + part.name).c_str());
        explain(part.meaning);
        if (part.shown == &SolverShown::tree) draw_tree_choice(state, controller, shown);
        if (view) draw_contact_order(*view, shown, part.shown);
    }
    if (shown.difference && view && view->difference) {
        const GjkResult& gjk = view->difference->gjk;
        ImGui::Text(gjk.distance > 0.0 ? "%.4g m apart" : "overlapping", gjk.distance);
        ImGui::Text("found in %d iterations, with %zu points", gjk.iterations, gjk.simplex.size());
    } else if (shown.difference) {
        ImGui::TextUnformatted("Click a body.");
    }
    if (shown != controller.solver) controller.show_solver(shown);
}

} // namespace cairn::viewer
