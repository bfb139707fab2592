#include "cli/validation_report.h"

#include "cli/svg_plot.h"
#include "files/output_file.h"
#include "validation/text.h"

#include <cairn/error.h>
#include <cairn/version.h>
#include <cairn/world.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace cairn::cli {

namespace {

using validation::Bar;
using validation::Published;
using validation::Row;

constexpr const char* style = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0; background: #f5f6f8; color: #23272e; }
body { font: 15px/1.5 system-ui, "Segoe UI", Helvetica, Arial, sans-serif; }
main { max-width: 1320px; margin: 0 auto; padding: 32px 24px 64px; }
h1 { font-size: 28px; margin: 0 0 4px; letter-spacing: -0.01em; }
h2 { font-size: 20px; margin: 0 0 4px; letter-spacing: -0.01em; }
h2 .number { color: #8a919b; font-weight: 400; margin-right: 6px; }
p { margin: 0 0 12px; max-width: 75ch; }
.quiet { color: #68707b; }
section { background: white; border: 1px solid #e1e4e9; border-radius: 8px; padding: 22px 24px; margin-top: 22px; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(370px, 1fr)); gap: 14px; margin: 14px 0; }
.plots svg { width: 100%; max-width: 560px; height: auto; display: block; }
table { border-collapse: collapse; width: 100%; font-size: 13px; font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: 600; color: #68707b; border-bottom: 1px solid #cfd4db; padding: 4px 10px 4px 0; }
td { border-bottom: 1px solid #eef0f3; padding: 3px 10px 3px 0; vertical-align: top; }
sup { line-height: 0; font-size: 0.75em; }
td.number, th.number { text-align: right; white-space: nowrap; padding-left: 6px; }
td.bar { white-space: nowrap; color: #68707b; }
tr.new td { border-top: 1px solid #cfd4db; }
tr.fail td { background: #fdecea; }
.pass, .fail .verdict { font-weight: 600; white-space: nowrap; }
.pass { color: #2f7d5b; }
.fail .verdict { color: #b3261e; }
.note { color: #68707b; font-size: 12px; }
.meter { display: inline-block; width: 72px; height: 7px; border-radius: 3px; background: #e6e9ed; overflow: hidden; }
.meter i { display: block; height: 100%; background: #2f8f6b; }
.fail .meter i { background: #b3261e; }
nav table { max-width: 640px; }
nav table td { padding: 4px 10px 4px 0; }
a { color: #1f5f99; text-decoration: none; }
a:hover { text-decoration: underline; }
h3 { font-size: 14px; margin: 18px 0 4px; }
summary { cursor: pointer; color: #1f5f99; font-size: 13px; padding: 4px 0; }
@media print { body { background: white; } section { break-inside: avoid; border: none; padding: 0; } }
)";

// Error of a row as a share of its bar: a row passes up to 1.
double share_of_bar(const Row& row) {
    const double off = std::fabs(row.measured - row.expected);
    double share = 0;
    switch (row.kind) {
    case Bar::relative:
        share = off / (row.bar * std::fabs(row.expected));
        break;
    case Bar::absolute:
        share = off / row.bar;
        break;
    case Bar::at_most:
        share = std::max(0.0, row.measured) / row.bar;
        break;
    case Bar::at_least:
        share = row.measured > 0 ? row.bar / row.measured : std::numeric_limits<double>::infinity();
        break;
    }
    if (std::isfinite(share)) return share;
    return row.passes() ? 0 : std::numeric_limits<double>::infinity(); // zero bar, or NaN
}

// Escapes a formula, with x^2 as a superscript and -+ as one sign.
std::string formula(std::string_view law) {
    const std::string text = escaped(law);
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.compare(i, 2, "-+") == 0) {
            out += "∓", ++i;
        } else if (text[i] != '^') {
            out += text[i];
        } else {
            const std::size_t end = text.find_first_not_of("-0123456789n", i + 1);
            const std::size_t length = std::min(end, text.size()) - (i + 1);
            out += "<sup>" + text.substr(i + 1, length) + "</sup>";
            i += length;
        }
    }
    return out;
}

void add_row(std::string& out, const Row& row, bool is_new) {
    const bool passes = row.passes();
    const double share = share_of_bar(row);
    out += fmt::format("<tr class=\"{}{}\"><td>{}", passes ? "" : "fail ", is_new ? "new" : "",
                       is_new ? escaped(row.quantity) : std::string());
    if (!row.note.empty()) out += fmt::format("<div class=\"note\">{}</div>", escaped(row.note));
    out += fmt::format("</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>",
                       validation::step_text(row.time_step), number_text(row.expected), number_text(row.measured));
    const std::string used = std::isfinite(share) ? fmt::format("{:.3g} % of the bar", 100 * share) : "exceeded";
    out += fmt::format("<td class=\"bar\">{}</td><td title=\"{}\"><span class=\"meter\"><i style=\"width:{:.0f}%\">"
                       "</i></span></td>",
                       escaped(bar_text(row)), used, std::clamp(100 * share, 0.0, 100.0));
    out += fmt::format("<td class=\"{}\">{}</td></tr>\n", passes ? "pass" : "verdict", passes ? "pass" : "fails");
}

void add_rows(std::string& out, const std::vector<Row>& rows) {
    out += "<table><thead><tr><th>Quantity</th><th class=\"number\">Step, s</th><th class=\"number\">Expected</th>"
           "<th class=\"number\">Measured</th><th>Bar</th><th>Used</th><th></th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
        add_row(out, rows[i], i == 0 || rows[i].quantity != rows[i - 1].quantity);
    out += "</tbody></table>\n";
}

void add_published(std::string& out, const std::vector<Published>& published) {
    if (published.empty()) return;
    out += "<h3>Published results of other "
           "engines</h3><table><thead><tr><th>Quantity</th><th>Engine</th><th>Value</th><th>Source</th></tr></"
           "thead><tbody>\n";
    for (std::size_t i = 0; i < published.size(); ++i) {
        const Published& p = published[i];
        const bool is_new = i == 0 || p.quantity != published[i - 1].quantity;
        out += fmt::format("<tr class=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td class=\"quiet\">{}</td></tr>\n",
                           is_new ? "new" : "", is_new ? escaped(p.quantity) : std::string(), escaped(p.engine),
                           escaped(p.value), escaped(p.source));
    }
    out += "</tbody></table>\n";
}

std::string count_text(const Count& count) {
    return count.passed == count.rows
               ? fmt::format("<span class=\"pass\">{} of {} pass</span>", count.passed, count.rows)
               : fmt::format("<span class=\"fail\"><span class=\"verdict\">{} of {} pass</span>"
                             "</span>",
                             count.passed, count.rows);
}

void add_case(std::string& out, const Measured& measured) {
    const validation::Case& entry = *measured.entry;
    const Count count = count_rows(measured.result);
    out += fmt::format("<section id=\"{}\"><h2><span class=\"number\">{}</span>{}</h2><p class=\"quiet\">{}</p>\n",
                       escaped(entry.name), entry.number, escaped(entry.title), formula(entry.law));
    if (!measured.result.plots.empty()) {
        out += "<div class=\"plots\">\n";
        for (const validation::Plot& plot : measured.result.plots) out += svg_plot(plot) + "\n";
        out += "</div>\n";
    }
    // Long tables are collapsed if all rows pass.
    const bool folds = count.rows > 6 && count.passed == count.rows && !measured.result.plots.empty();
    if (folds) out += fmt::format("<details><summary>{} rows, all pass</summary>\n", count.rows);
    add_rows(out, measured.result.rows);
    if (folds) out += "</details>\n";
    add_published(out, measured.result.published);
    out += "</section>\n";
}

std::string page(const std::vector<Measured>& cases) {
    const Count all = count_rows(cases);
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
                      "<title>Cairn: validation of the physics</title><style>";
    out += style;
    out += "</style></head><body><main>\n<h1>Validation of the physics</h1>\n";
    out +=
        fmt::format("<p class=\"quiet\">Cairn {}, instruction set {}. Small worlds measured against closed forms and "
                    "against published numbers; results are the same on every machine.</p>\n",
                    cairn::version_string, instruction_set());
    out +=
        fmt::format("<p>{} rows. A row passes if what was measured lies within its bar of what is expected; the small "
                    "bars beside the rows show how much of it is used. Where both axes of a plot are logarithmic, "
                    "the slope fitted to a curve, as far as it falls with the step, is the order of the error.</p>\n",
                    count_text(all));
    out += "<nav><table><thead><tr><th></th><th>Case</th><th>Rows</th></tr></thead><tbody>\n";
    for (const Measured& measured : cases)
        out += fmt::format("<tr><td class=\"quiet\">{}</td><td><a href=\"#{}\">{}</a></td><td>{}</td></tr>\n",
                           measured.entry->number, escaped(measured.entry->name), escaped(measured.entry->title),
                           count_text(count_rows(measured.result)));
    out += "</tbody></table></nav>\n";
    for (const Measured& measured : cases) add_case(out, measured);
    return out + "</main></body></html>\n";
}

} // namespace

void check_report_folder(const std::filesystem::path& folder) {
    // Writing and removing an empty file is more reliable than checking permissions.
    const std::filesystem::path trial = files::temporary_beside(folder / "index.html");
    try {
        files::make_parent_folder(trial);
        files::write_file(trial, "");
    } catch (const Error& error) {
        throw Error(ErrorCode::io, folder.string(), {}, "cannot take a report: " + error.value());
    }
    std::error_code ignored;
    std::filesystem::remove(trial, ignored);
}

void write_report(const std::filesystem::path& folder, const std::vector<Measured>& cases) {
    for (const Measured& measured : cases)
        for (std::size_t i = 0; i < measured.result.plots.size(); ++i)
            files::write_file(folder / fmt::format("{}_{}.svg", measured.entry->name, i + 1),
                              svg_plot(measured.result.plots[i]) + "\n");
    files::write_file(folder / "table.md", markdown_report(cases));
    files::write_file(folder / "index.html", page(cases));
}

} // namespace cairn::cli
