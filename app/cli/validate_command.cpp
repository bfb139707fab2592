#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/validation_report.h"

#include <cairn/world.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace cairn::cli {

namespace {

using validation::Case;
using validation::Row;

std::vector<Measured> chosen_cases(const std::vector<std::string>& names) {
    std::vector<Measured> chosen;
    for (const Case& entry : validation::cases()) {
        const bool is_wanted = std::any_of(
            names.begin(), names.end(), [&](const std::string& name) { return validation::find_case(name) == &entry; });
        if (names.empty() || is_wanted) chosen.push_back({&entry, {}});
    }
    return chosen;
}

// Makes the rows of each quantity adjacent, in the order in which the quantities first appear.
void group_by_quantity(std::vector<Row>& rows) {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < rows.size(); ++i) first.emplace(rows[i].quantity, i);
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const Row& a, const Row& b) { return first.at(a.quantity) < first.at(b.quantity); });
}

// Measures the cases on as many threads as the machine has. Each thread takes the last remaining case, because the last
// cases take longest; results of a case do not depend on the others.
void measure_all(std::vector<Measured>& cases) {
    ProgressLine progress(cases.size(), "cases");
    std::atomic<std::size_t> taken{0};
    std::mutex mutex; // guards the next two variables
    std::size_t done = 0;
    std::exception_ptr error;
    const auto work = [&] {
        for (std::size_t i = taken++; i < cases.size(); i = taken++) {
            Measured& measured = cases[cases.size() - 1 - i];
            try {
                measured.result = measured.entry->measure();
                group_by_quantity(measured.result.rows);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(mutex);
                if (!error) error = std::current_exception();
                taken = cases.size();
            }
            const std::lock_guard<std::mutex> lock(mutex);
            progress.show(++done);
        }
    };
    progress.show(0);
    std::vector<std::jthread> helpers;
    const std::size_t threads = std::min(static_cast<std::size_t>(hardware_threads()), cases.size());
    for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(work);
    work();
    helpers.clear(); // joins the threads
    if (error) std::rethrow_exception(error);
}

} // namespace

int validate_command(const ValidateOptions& options) {
    std::vector<Measured> cases = chosen_cases(options.cases);
    if (!options.report.empty()) check_report_folder(options.report); // before minutes of computation
    set_activity("measuring");
    measure_all(cases);
    set_activity("writing the report", options.report.generic_string());
    if (!options.report.empty()) write_report(options.report, cases);
    print(options.json ? json_report(cases) : text_report(cases));
    const Count count = count_rows(cases);
    return count.passed == count.rows ? 0 : 1;
}

} // namespace cairn::cli
