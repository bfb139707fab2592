#include "cli/sweep_results.h"

#include "cli/table_writer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace cairn::cli {

namespace {

std::vector<Column> columns_of(const sweep::Plan& plan) {
    std::vector<Column> columns;
    for (const std::string& name : plan.columns()) columns.push_back({name, Column::Kind::real64});
    columns.front().kind = columns.back().kind = Column::Kind::integer; // index and outcome
    return columns;
}

nlohmann::ordered_json number_or_null(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

} // namespace

sweep::Summary write_rows(const sweep::Plan& plan, const sweep::Store& store, const std::filesystem::path& folder) {
    sweep::Summary summary(plan);
    TableWriter csv(folder / "rows.csv", columns_of(plan)), npy(folder / "rows.npy", columns_of(plan));
    store.read([&](std::uint64_t row, std::span<const double> numbers) {
        summary.add(row, numbers);
        for (TableWriter* table : {&csv, &npy}) {
            table->add(static_cast<std::int64_t>(row));
            for (std::size_t i = 0; i + 1 < numbers.size(); ++i) table->add(numbers[i]);
            table->add(static_cast<std::int64_t>(numbers.back()));
            table->end_row();
            if (row % 256 == 0) table->flush();
        }
    });
    csv.close();
    npy.close();
    return summary;
}

std::vector<std::string> failure_lines(const sweep::Plan& plan, const sweep::Start& start,
                                       const sweep::Summary& summary) {
    std::vector<std::string> lines;
    if (summary.failures().empty()) return lines;
    sweep::Runner runner(plan, start);
    std::vector<double> numbers(plan.numbers());
    const std::atomic<bool> never{false};
    for (const std::uint64_t row : summary.failures()) {
        runner.run(row, numbers, never);
        lines.push_back(fmt::format("row {}: {}", row, runner.failure()));
    }
    return lines;
}

std::string sweep_json(const sweep::Plan& plan, const sweep::Summary& summary,
                       const std::vector<std::string>& failures) {
    nlohmann::ordered_json json;
    json["plan"] = plan.file;
    json["scene"] = plan.scene.generic_string();
    json["rows"] = summary.rows();
    json["ran"] = summary.count(sweep::Outcome::ran);
    json["stopped"] = summary.count(sweep::Outcome::stopped);
    json["failed"] = summary.count(sweep::Outcome::failed);
    json["failures"] = failures;
    json["hash"] = fmt::format("{:016x}", summary.hash());
    json["columns"] = nlohmann::ordered_json::array();
    for (const sweep::ColumnSummary& column : summary.columns()) {
        json["columns"].push_back({{"name", column.name},
                                   {"count", column.count},
                                   {"mean", number_or_null(column.mean)},
                                   {"deviation", number_or_null(column.deviation)},
                                   {"min", number_or_null(column.min)},
                                   {"max", number_or_null(column.max)}});
    }
    json["sensitivity"] = nlohmann::ordered_json::array();
    const std::vector<sweep::Parameter>& parameters = plan.design.parameters();
    for (std::size_t m = 0; m < std::min(most_measures_shown, plan.measures.size()); ++m) {
        for (std::size_t p = 0; p < parameters.size(); ++p) {
            const sweep::Sensitivity s = summary.sensitivity(p, m);
            json["sensitivity"].push_back({{"measure", plan.measures[m].name},
                                           {"parameter", parameters[p].name},
                                           {"first", number_or_null(s.first)},
                                           {"first_error", number_or_null(s.first_error)},
                                           {"total", number_or_null(s.total)},
                                           {"total_error", number_or_null(s.total_error)}});
        }
    }
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string sweep_text(const sweep::Plan& plan, const sweep::Summary& summary, const std::vector<std::string>& failures,
                       const std::filesystem::path& folder) {
    std::string text = fmt::format("{}: {} rows: {} ran to the end, {} stopped before, {} failed\n", plan.file,
                                   summary.rows(), summary.count(sweep::Outcome::ran),
                                   summary.count(sweep::Outcome::stopped), summary.count(sweep::Outcome::failed));
    for (const std::string& line : failures) text += line + "\n";
    if (summary.count(sweep::Outcome::failed) > failures.size()) text += "...\n";
    const std::vector<sweep::ColumnSummary> columns = summary.columns();
    for (std::size_t i = plan.design.parameters().size(); i < columns.size(); ++i) {
        const sweep::ColumnSummary& c = columns[i];
        if (c.count == 0) {
            text += fmt::format("{}: no row has a number\n", c.name);
            continue;
        }
        text += fmt::format("{}: {:.6g} to {:.6g}, mean {:.6g}, standard deviation {:.6g}", c.name, c.min, c.max,
                            c.mean, c.deviation);
        text += c.count < summary.rows() ? fmt::format("; {} rows have no number\n", summary.rows() - c.count) : "\n";
    }
    return text + fmt::format("all rows {:016x}, in {}: rows.csv, rows.npy, report.html, summary.json\n",
                              summary.hash(), folder.generic_string());
}

} // namespace cairn::cli
