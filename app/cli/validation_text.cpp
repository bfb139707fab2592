#include "cli/validation_text.h"

#include "validation/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cairn::cli {

using validation::Bar;
using validation::Published;
using validation::Result;
using validation::Row;
using validation::step_text;

Count count_rows(const Result& result) {
    Count count;
    for (const Row& row : result.rows) {
        ++count.rows;
        if (row.passes()) ++count.passed;
    }
    return count;
}

Count count_rows(const std::vector<Measured>& cases) {
    Count sum;
    for (const Measured& measured : cases) {
        const Count count = count_rows(measured.result);
        sum.passed += count.passed;
        sum.rows += count.rows;
    }
    return sum;
}

std::string number_text(double value) { return fmt::format("{:.6g}", value); }

std::string bar_text(const Row& row) {
    switch (row.kind) {
    case Bar::relative:
        return fmt::format("within {:.3g} %", 100 * row.bar);
    case Bar::absolute:
        return fmt::format("within {:.3g}", row.bar);
    case Bar::at_most:
        return fmt::format("at most {:.3g}", row.bar);
    case Bar::at_least:
        return fmt::format("at least {:.3g}", row.bar);
    }
    return {};
}

std::string text_report(const std::vector<Measured>& cases) {
    std::size_t widest = 8;
    for (const Measured& measured : cases)
        for (const Row& row : measured.result.rows) widest = std::max(widest, row.quantity.size());
    std::string text;
    for (const Measured& measured : cases) {
        text += fmt::format("{} {}: {}\n", measured.entry->number, measured.entry->name, measured.entry->title);
        text += fmt::format("    {:<{}}  {:>8}  {:>12}  {:>12}  {:<15}  {}\n", "quantity", widest, "step, s",
                            "expected", "measured", "bar", "verdict");
        for (const Row& row : measured.result.rows) {
            text += fmt::format("    {:<{}}  {:>8}  {:>12}  {:>12}  {:<15}  {}\n", row.quantity, widest,
                                step_text(row.time_step), number_text(row.expected), number_text(row.measured),
                                bar_text(row), row.passes() ? "pass" : "FAIL");
            if (!row.note.empty()) text += fmt::format("        note: {}\n", row.note);
        }
        for (const Published& other : measured.result.published)
            text += fmt::format("    published: {}, {}: {} ({})\n", other.quantity, other.engine, other.value,
                                other.source);
        text += "\n";
    }
    const Count count = count_rows(cases);
    return text + fmt::format("{} of {} rows pass\n", count.passed, count.rows);
}

std::string json_report(const std::vector<Measured>& cases) {
    static constexpr const char* kinds[] = {"relative", "absolute", "at_most", "at_least"};
    nlohmann::ordered_json rows = nlohmann::ordered_json::array(), published = rows;
    for (const Measured& measured : cases) {
        const std::string name(measured.entry->name);
        for (const Row& row : measured.result.rows)
            rows.push_back({{"number", measured.entry->number},
                            {"case", name},
                            {"quantity", row.quantity},
                            {"dt", row.time_step},
                            {"expected", row.expected},
                            {"measured", row.measured}, // NaN becomes null
                            {"bar", row.bar},
                            {"bar_kind", kinds[static_cast<std::size_t>(row.kind)]},
                            {"pass", row.passes()},
                            {"note", row.note}});
        for (const Published& other : measured.result.published)
            published.push_back({{"case", name},
                                 {"quantity", other.quantity},
                                 {"engine", other.engine},
                                 {"value", other.value},
                                 {"source", other.source}});
    }
    const Count count = count_rows(cases);
    nlohmann::ordered_json json;
    json["rows"] = std::move(rows);
    json["published"] = std::move(published);
    json["passed"] = count.passed;
    json["total"] = count.rows;
    return json.dump(2) + "\n";
}

std::string markdown_report(const std::vector<Measured>& cases) {
    const auto cell = [](const std::string& text) { // a `|` would end the cell
        std::string result;
        for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
        return result;
    };
    const Count count = count_rows(cases);
    std::string text =
        fmt::format("# Rows of `cairn validate`, as measured\n\n{} of {} rows pass.\n", count.passed, count.rows);
    for (const Measured& measured : cases) {
        text += fmt::format("\n## {} {}\n\n{}.\n\n| quantity | step, s | expected | measured | bar | |\n"
                            "|---|---|---|---|---|---|\n",
                            measured.entry->number, measured.entry->name, measured.entry->title);
        std::string last;
        for (const Row& row : measured.result.rows) {
            const std::string note = row.note.empty() ? "" : " (" + cell(row.note) + ")";
            text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", row.quantity == last ? "" : cell(row.quantity),
                                step_text(row.time_step), number_text(row.expected), number_text(row.measured),
                                bar_text(row), (row.passes() ? "pass" : "**FAIL**") + note);
            last = row.quantity;
        }
        if (measured.result.published.empty()) continue;
        text += "\n| published | engine | value | source |\n|---|---|---|---|\n";
        for (const Published& other : measured.result.published)
            text += fmt::format("| {} | {} | {} | {} |\n", cell(other.quantity), cell(other.engine), cell(other.value),
                                cell(other.source));
    }
    return text;
}

} // namespace cairn::cli
