#include "cli/activity.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "cli/progress.h"

#include "sweep/fit.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace cairn::cli {

namespace {

std::string fit_json(const sweep::Plan& plan, const sweep::Fit& fit) {
    nlohmann::ordered_json json;
    json["plan"] = plan.file;
    json["parameters"] = nlohmann::ordered_json::array();
    for (const sweep::Fitted& fitted : fit.parameters) {
        json["parameters"].push_back({{"name", fitted.name}, {"value", fitted.value}, {"error", fitted.error}});
        if (!std::isfinite(fitted.error)) json["parameters"].back()["error"] = nullptr;
    }
    json["residual"] = fit.residual;
    json["numbers"] = fit.numbers;
    json["evaluations"] = fit.evaluations;
    json["interrupted"] = fit.is_interrupted;
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string fit_text(const sweep::Fit& fit) {
    std::string text;
    for (const sweep::Fitted& fitted : fit.parameters) {
        text += std::isfinite(fitted.error)
                    ? fmt::format("{} = {:.6g} +- {:.2g}\n", fitted.name, fitted.value, fitted.error)
                    : fmt::format("{} = {:.6g}, not determined by the measurements\n", fitted.name, fitted.value);
    }
    return text + fmt::format("{} numbers are off by {:.4g} deviations (root mean square); {} evaluations{}\n",
                              fit.numbers, fit.residual, fit.evaluations, fit.is_interrupted ? ", interrupted" : "");
}

} // namespace

int fit_command(const FitOptions& options) {
    set_activity("reading", options.plan.generic_string());
    const sweep::Plan plan = sweep::read_plan(options.plan, sweep::Purpose::fit);
    const sweep::Measurements measured = sweep::read_measurements(plan, options.data);
    const sweep::Start start = sweep::load_start(plan);
    print_warnings(start.warnings);
    set_activity("fitting", plan.file);
    const InterruptGuard interrupt;
    sweep::FitOptions how;
    how.threads = options.threads.value_or(hardware_threads());
    const std::size_t fitted = plan.design.parameters().size() - measured.inputs.size(); // 0 is rejected below
    how.evaluations = options.evaluations.value_or(300 * std::max<std::size_t>(1, fitted));
    sweep::Fit fit;
    {
        ProgressLine progress(how.evaluations, "evaluations");
        fit = sweep::fit(plan, start, measured, how, [&](std::uint64_t done, double least) {
            progress.show(std::min(done, how.evaluations), fmt::format(", squares {:.4g}", least));
            return !interrupt.requested();
        });
    }
    print(options.json ? fit_json(plan, fit) : fit_text(fit));
    return fit.is_interrupted ? 1 : 0;
}

} // namespace cairn::cli
