#include "cli/svg_plot.h"
#include "cli/sweep_charts.h"
#include "cli/sweep_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace cairn::cli {

namespace {

constexpr const char* page_head =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title><style>\n"
    "body{{font:15px/1.5 system-ui,sans-serif;max-width:960px;margin:2em auto;padding:0 "
    "1em;color:#222;background:#fff}}\n"
    "table{{border-collapse:collapse;margin:1em 0}}td,th{{padding:.2em .8em;border-bottom:1px solid "
    "#ddd;text-align:right}}\n"
    "td:first-child,th:first-child{{text-align:left}}code{{background:#f2f2f2;padding:0 .2em}}svg{{margin:.3em}}\n"
    "</style></head><body>\n<h1>{0}</h1>\n";

std::string cell(double value) {
    return std::isfinite(value) ? fmt::format("<td>{:.6g}</td>", value) : std::string("<td>none</td>");
}

std::string column_table(const sweep::Summary& summary) {
    std::string html =
        "<h2>Columns</h2>\n<table><tr><th>column</th><th>rows with a number</th><th>mean</th><th>standard "
        "deviation</th><th>least</th><th>greatest</th></tr>\n";
    for (const sweep::ColumnSummary& column : summary.columns()) {
        html += fmt::format("<tr><td>{}</td><td>{}</td>{}{}{}{}</tr>\n", escaped(column.name), column.count,
                            cell(column.mean), cell(column.deviation), cell(column.min), cell(column.max));
    }
    return html + "</table>\n";
}

std::string index_cell(double value, double error) {
    if (!std::isfinite(value)) return "<td>unknown</td>";
    if (!std::isfinite(error)) return fmt::format("<td>{:.3f}</td>", value);
    return fmt::format("<td>{:.3f} &plusmn; {:.3f}</td>", value, error);
}

std::string sensitivity_table(const sweep::Plan& plan, const sweep::Summary& summary, std::size_t measure) {
    const bool is_designed = plan.design.sampling() == sweep::Sampling::sensitivity;
    std::string html = "<table><tr><th>parameter</th><th>share of the variance by itself</th>";
    html += is_designed ? "<th>with all others</th></tr>\n" : "</tr>\n";
    const std::vector<sweep::Parameter>& parameters = plan.design.parameters();
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        const sweep::Sensitivity s = summary.sensitivity(p, measure);
        html +=
            fmt::format("<tr><td>{}</td>{}{}</tr>\n", escaped(parameters[p].name), index_cell(s.first, s.first_error),
                        is_designed ? index_cell(s.total, s.total_error) : std::string());
    }
    return html + "</table>\n";
}

// Parameters in order of decreasing influence.
std::vector<std::size_t> by_influence(const sweep::Plan& plan, const sweep::Summary& summary, std::size_t measure) {
    const std::size_t count = plan.design.parameters().size();
    std::vector<double> share(count);
    for (std::size_t p = 0; p < count; ++p) {
        const sweep::Sensitivity s = summary.sensitivity(p, measure);
        share[p] = std::isfinite(s.total) ? s.total : std::isfinite(s.first) ? s.first : -1.0;
    }
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return share[a] > share[b]; });
    return order;
}

// The time at which a measure is taken.
std::string moment_of(const sweep::Measure& measure) {
    if (measure.take == sweep::Measure::Take::at) return fmt::format("at {:g} s", measure.time);
    return std::string(sweep::name_of(measure.take));
}

std::string measure_section(const sweep::Plan& plan, const sweep::Summary& summary, std::size_t measure) {
    const std::vector<sweep::Parameter>& parameters = plan.design.parameters();
    const auto series = [&](std::size_t column) {
        const std::string& name =
            column < parameters.size() ? parameters[column].name : plan.measures[column - parameters.size()].name;
        return Series{name, summary.sample().columns[column]};
    };
    const Series values = series(parameters.size() + measure);
    std::string html = fmt::format("<h2>{}</h2>\n<p><code>{}</code>, {}</p>\n", escaped(values.name),
                                   escaped(plan.measures[measure].expression), moment_of(plan.measures[measure]));
    const std::string bars = histogram(values);
    if (bars.empty()) return html + "<p>No row has a number.</p>\n";
    html += bars;
    const std::vector<std::size_t> order = by_influence(plan, summary, measure);
    if (!order.empty()) html += effect_plot(series(order[0]), values);
    if (order.size() > 1) html += heat_map(series(order[0]), series(order[1]), values);
    if (!order.empty()) html += sensitivity_table(plan, summary, measure);
    return html;
}

} // namespace

std::string sweep_report(const sweep::Plan& plan, const sweep::Summary& summary,
                         const std::vector<std::string>& failures) {
    std::string html = fmt::format(fmt::runtime(page_head), "Sweep " + escaped(plan.file));
    html += fmt::format("<p>{} rows of <code>{}</code>: {} ran to the end, {} stopped before, {} failed. All rows: "
                        "<code>{:016x}</code>.</p>\n",
                        summary.rows(), escaped(plan.scene.generic_string()), summary.count(sweep::Outcome::ran),
                        summary.count(sweep::Outcome::stopped), summary.count(sweep::Outcome::failed), summary.hash());
    if (!failures.empty()) {
        html += "<h2>Failures</h2>\n<ul>\n";
        for (const std::string& line : failures) html += "<li>" + escaped(line) + "</li>\n";
        if (summary.count(sweep::Outcome::failed) > failures.size()) html += "<li>and more</li>\n";
        html += "</ul>\n";
    }
    html += column_table(summary);
    if (summary.sample().every > 1) {
        html += fmt::format("<p>The charts show one row of {}.</p>\n", summary.sample().every);
    }
    const std::size_t shown = std::min(most_measures_shown, plan.measures.size());
    for (std::size_t m = 0; m < shown; ++m) html += measure_section(plan, summary, m);
    if (shown < plan.measures.size()) {
        html += fmt::format("<p>Charts of {} more measures are left out; their rows are in rows.csv.</p>\n",
                            plan.measures.size() - shown);
    }
    return html + "</body></html>\n";
}

} // namespace cairn::cli
