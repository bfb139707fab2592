#include "sweep/plan.h"

#include "sweep/numbers.h"

#include "files/csv_reader.h"
#include "scene/gltf_file.h"
#include "scene/json_value.h"
#include "scene/nearby_files.h"

#include <cairn/version.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

namespace cairn::sweep {

namespace {

using scene::Value;
using Take = Measure::Take;

constexpr std::pair<Take, std::string_view> takes[]{{Take::end, "end"},    {Take::at, "at"},     {Take::max, "max"},
                                                    {Take::min, "min"},    {Take::mean, "mean"}, {Take::first, "first"},
                                                    {Take::since, "since"}};

constexpr std::size_t max_parameters = 1000, max_measures = 10000, max_values = 1'000'000, max_pairs = 1'000'000;

std::uint64_t hash_text(std::uint64_t hash, std::string_view text) {
    for (std::size_t at = 0; at < text.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + at, std::min<std::size_t>(8, text.size() - at));
        hash = hash_pair(hash, word);
    }
    return hash_pair(hash, text.size());
}

// Checks that a name is an identifier, so that it can be used in expressions.
void check_name(const std::string& name, const Value& place, std::set<std::string>& taken) {
    const bool is_word = !name.empty() && name.find_first_not_of("0123456789_abcdefghijklmnopqrstuvwxyz"
                                                                 "ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos;
    if (!is_word || (name[0] >= '0' && name[0] <= '9')) {
        throw Error(ErrorCode::invalid_file, place.place() + "name", "\"" + name.substr(0, 60) + "\"",
                    "must have letters, digits and _ only, and begin with no digit");
    }
    if (!taken.insert(name).second) {
        throw Error(ErrorCode::invalid_file, place.place() + "name", "\"" + name + "\"", "is taken already");
    }
}

void check_members(const Value& value, const std::vector<std::string>& known) {
    const std::vector<std::string> others = value.other_members(known, 1);
    if (others.empty()) return;
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    throw Error(ErrorCode::invalid_file, value.place() + "\"" + others[0].substr(0, 60) + "\"", {},
                "is unknown; there are " + list);
}

class PlanReader {
  public:
    PlanReader(const std::filesystem::path& path, const std::vector<std::byte>& bytes)
        : folder_(path.parent_path()), file_(scene::parse_gltf(bytes, path.generic_string())),
          name_(path.generic_string()), root_(file_.json, name_) {
        plan_.file = name_;
        plan_.fingerprint = hash_text(hash_pair(1, 1), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        for (const char* name : {"index", "time", "outcome"}) taken_.insert(name);
    }

    Plan read(Purpose purpose) {
        check_members(root_,
                      {"scene", "fixed_base", "floor", "parameters", "sample", "set", "seconds", "stop", "measure"});
        read_scene();
        read_parameters();
        if (purpose == Purpose::sweep) {
            read_sample();
        } else {
            plan_.design = one_row();
        }
        if (const auto set = root_.find("set")) read_settings(*set);
        if (const auto seconds = root_.find("seconds")) plan_.seconds = seconds->number({0.0001, 1e6});
        if (const auto stop = root_.find("stop")) read_stops(*stop);
        if (const auto measure = root_.find("measure")) read_measures(*measure);
        const std::size_t pairs = plan_.design.parameters().size() * plan_.measures.size();
        if (plan_.design.sampling() == Sampling::sensitivity && pairs > max_pairs) {
            root_.require("sample").fail("must have at most 1000000 pairs of parameters and measures");
        }
        return std::move(plan_);
    }

  private:
    // Returns the file that a value names, in the plan's folder or below it; nothing if it does not exist. Plans are
    // untrusted, as models are.
    std::optional<std::filesystem::path> find_beside(const Value& value) const {
        using Verdict = scene::NearbyFile::Verdict;
        const std::string text = value.text();
        const std::filesystem::path root = scene::folder_on_disk(folder_);
        const Verdict verdict = scene::nearby_file(text, root, root).verdict;
        if (verdict == Verdict::outside) value.fail("must not lead out of the plan's folder");
        if (verdict == Verdict::not_a_file) value.fail("must name a file");
        if (verdict == Verdict::missing) return std::nullopt;
        return folder_ / text;
    }

    void read_scene() {
        const Value scene = root_.require("scene");
        const std::string text = scene.text();
        const std::optional<std::filesystem::path> beside = find_beside(scene);
        plan_.scene = beside ? *beside : scene::find_named_scene(text);
        if (const auto flag = root_.find("fixed_base")) plan_.fixed_base = flag->boolean();
        if (const auto flag = root_.find("floor")) plan_.floor = flag->boolean();
    }

    // Parameters form a list, because JSON does not define an order of the members of an object.
    void read_parameters() {
        const auto list = root_.find("parameters");
        const std::size_t count = list ? list->size(max_parameters, "parameters") : 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Value value = (*list)[i];
            check_members(value, {"name", "values", "from", "to", "count", "log", "mean", "deviation"});
            Parameter parameter;
            parameter.name = value.require("name").text();
            check_name(parameter.name, value, taken_);
            if (const auto values = value.find("values")) {
                const std::size_t n = values->size(max_values, "values");
                if (n == 0) values->fail("must have a value, or there is no row");
                for (std::size_t k = 0; k < n; ++k) parameter.values.push_back((*values)[k].number());
            } else if (value.find("mean")) {
                parameter.kind = Parameter::Kind::normal;
                parameter.low = value.require("mean").number();
                parameter.high = value.require("deviation").number({0.0});
            } else if (value.find("from")) {
                read_range(value, parameter);
            }
            counts_.push_back(value.find("count") ? value.require("count").whole(1, max_values) : 0);
            parameters_.push_back(std::move(parameter));
        }
    }

    static void read_range(const Value& value, Parameter& parameter) {
        const auto log = value.find("log");
        parameter.kind = log && log->boolean() ? Parameter::Kind::log : Parameter::Kind::uniform;
        scene::Range range;
        if (parameter.kind == Parameter::Kind::log) range = {1e-300, 1e300};
        parameter.low = value.require("from").number(range);
        parameter.high = value.require("to").number(range);
    }

    // Gives each range of a grid its values: evenly spaced, including both ends.
    void spread(const Value& list) {
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            Parameter& parameter = parameters_[i];
            if (!parameter.values.empty()) continue;
            const bool is_range = parameter.kind == Parameter::Kind::uniform || parameter.kind == Parameter::Kind::log;
            if (!is_range || counts_[i] == 0)
                list[i].fail("must have \"values\", or \"from\", \"to\" and \"count\" in a grid");
            for (std::uint64_t k = 0; k < counts_[i]; ++k) {
                const double share =
                    counts_[i] == 1 ? 0.0 : static_cast<double>(k) / static_cast<double>(counts_[i] - 1);
                parameter.values.push_back(share == 0.0   ? parameter.low
                                           : share == 1.0 ? parameter.high
                                                          : parameter.quantile(share));
            }
            parameter.kind = Parameter::Kind::list;
        }
    }

    void read_sample() {
        const auto sample = root_.find("sample");
        const auto list = root_.find("parameters");
        Sampling sampling = Sampling::grid;
        std::uint64_t count = 1, seed = 0;
        if (sample && !sample->is_string()) {
            check_members(*sample, {"random", "sobol", "sensitivity", "table", "seed"});
            if (const auto value = sample->find("seed")) seed = value->whole(0, std::uint64_t{1} << 53);
            const std::pair<const char*, Sampling> kinds[]{
                {"random", Sampling::random}, {"sobol", Sampling::sobol}, {"sensitivity", Sampling::sensitivity}};
            bool is_found = false;
            for (const auto& [name, kind] : kinds) {
                const auto points = sample->find(name);
                if (!points) continue;
                if (is_found) points->fail("must be the only kind of sample");
                is_found = true;
                sampling = kind;
                count = points->whole(1, Design::max_rows);
            }
            if (const auto table = sample->find("table")) {
                if (is_found) table->fail("must be the only kind of sample");
                sampling = Sampling::table;
                read_table(*table);
            } else if (!is_found) {
                sample->fail("must have a member \"random\", \"sobol\", \"sensitivity\" or \"table\"");
            }
        } else if (sample && sample->text() != "grid") {
            sample->fail("must be \"grid\" or an object");
        }
        if (sampling == Sampling::grid && list) spread(*list);
        if (sampling == Sampling::random || sampling == Sampling::sobol || sampling == Sampling::sensitivity) {
            for (std::size_t i = 0; i < parameters_.size(); ++i) {
                if (parameters_[i].kind == Parameter::Kind::list && parameters_[i].values.empty())
                    (*list)[i].fail("must have \"from\" and \"to\", \"mean\" and \"deviation\", or \"values\"");
            }
        }
        try {
            plan_.design = Design(sampling, std::move(parameters_), count, seed);
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, root_.place() + (sample ? "sample" : "parameters"), {},
                        error.what() + 2);
        }
    }

    // Returns the design for a fit, which has no rows of its own.
    Design one_row() {
        for (Parameter& parameter : parameters_) {
            if (parameter.kind == Parameter::Kind::list && parameter.values.empty()) parameter.values = {0.0};
        }
        return {Sampling::random, std::move(parameters_), 1, 0};
    }

    // Reads the table, whose columns become the parameters; those that the plan names must be among them.
    void read_table(const Value& table) {
        const std::filesystem::path path = find_beside(table).value_or(folder_ / table.text());
        const std::vector<std::byte> bytes = scene::read_file(path);
        const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        plan_.fingerprint = hash_text(plan_.fingerprint, content);
        files::CsvReader reader(content, path.generic_string());
        if (content.empty()) reader.fail("must have a first line with the names of parameters");
        const std::vector<std::string> names = reader.row();
        for (const Parameter& parameter : parameters_) {
            taken_.erase(parameter.name);
            if (std::find(names.begin(), names.end(), parameter.name) == names.end()) {
                reader.fail("must have a column \"" + parameter.name + "\"");
            }
        }
        parameters_.clear();
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (names[i] == "index" && i == 0) continue; // the table may be the result of another sweep
            check_name(names[i], Value(file_.json, path.native()), taken_);
            parameters_.emplace_back().name = names[i];
        }
        const std::size_t skipped = names.size() - parameters_.size();
        while (!reader.at_end()) {
            const std::vector<std::string> fields = reader.row();
            if (fields.size() == 1 && fields[0].empty()) continue;
            if (fields.size() != names.size()) {
                reader.fail("must have " + std::to_string(names.size()) + " fields as the first line, has " +
                            std::to_string(fields.size()));
            }
            for (std::size_t i = skipped; i < fields.size(); ++i) {
                parameters_[i - skipped].values.push_back(reader.number(i, fields[i]));
            }
        }
        if (parameters_.empty() || parameters_[0].values.empty())
            reader.fail("must have a line of numbers after the first");
    }

    void read_settings(const Value& set) {
        set.must_be_object();
        for (const std::string& path : set.other_members({}, max_measures)) {
            const auto value = set.find(path.c_str()); // nothing if the name was truncated
            if (!value)
                throw Error(ErrorCode::invalid_file, set.place() + "\"" + path.substr(0, 60) + "\"", {},
                            "does not name a property");
            plan_.settings.push_back({path, expression_of(*value), value->place()});
        }
    }

    void read_stops(const Value& stop) {
        if (stop.is_string()) {
            plan_.stops.push_back({{}, stop.text(), stop.place()});
            return;
        }
        for (std::size_t i = 0; i < stop.size(max_measures, "rules"); ++i) {
            plan_.stops.push_back({{}, stop[i].text(), stop[i].place()});
        }
    }

    // An expression may also be given as a number.
    static std::string expression_of(const Value& value) {
        if (value.is_string()) return value.text();
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", value.number());
        return text;
    }

    void read_measures(const Value& list) {
        const std::size_t count = list.size(max_measures, "measures");
        for (std::size_t i = 0; i < count; ++i) {
            const Value value = list[i];
            check_members(value, {"name", "of", "at", "take", "deviation"});
            Measure measure;
            measure.name = value.require("name").text();
            measure.expression = value.require("of").text();
            measure.place = value.require("of").place();
            if (const auto deviation = value.find("deviation")) measure.deviation = deviation->number({1e-300, 1e300});
            if (const auto at = value.find("at")) {
                if (value.find("take")) at->fail("must not stand beside \"take\"");
                measure.take = Measure::Take::at;
                if (at->is_array()) {
                    add_moments(value, measure, *at);
                    continue;
                }
                measure.time = at->number({0.0, plan_.seconds});
            } else if (const auto take = value.find("take")) {
                measure.take = take_of(*take);
            }
            check_name(measure.name, value, taken_);
            plan_.measures.push_back(std::move(measure));
        }
    }

    // Adds a measure for each time: x_0, x_1, ...
    void add_moments(const Value& value, const Measure& measure, const Value& times) {
        const std::size_t count = times.size(max_measures, "times");
        for (std::size_t i = 0; i < count; ++i) {
            Measure& moment = plan_.measures.emplace_back(measure);
            moment.name += "_" + std::to_string(i);
            moment.time = times[i].number({0.0, plan_.seconds});
            check_name(moment.name, value, taken_);
        }
    }

    static Measure::Take take_of(const Value& value) {
        const std::string text = value.text();
        for (const auto& [take, name] : takes) {
            if (text == name && take != Measure::Take::at) return take;
        }
        value.fail("must be \"end\", \"max\", \"min\", \"mean\", \"first\" or \"since\"");
    }

    std::filesystem::path folder_;
    scene::GltfFile file_;
    std::string name_;
    Value root_;
    Plan plan_;
    std::vector<Parameter> parameters_;
    std::vector<std::uint64_t> counts_; // of a grid, by parameter; 0: not given
    std::set<std::string> taken_;
};

} // namespace

std::string_view name_of(Take take) {
    const auto* found =
        std::find_if(std::begin(takes), std::end(takes), [&](const auto& t) { return t.first == take; });
    return found->second;
}

std::vector<std::string> Plan::columns() const {
    std::vector<std::string> names{"index"};
    for (const Parameter& parameter : design.parameters()) names.push_back(parameter.name);
    for (const Measure& measure : measures) names.push_back(measure.name);
    names.insert(names.end(), {"time", "outcome"});
    return names;
}

Plan read_plan(const std::filesystem::path& path, Purpose purpose) {
    const std::vector<std::byte> bytes = scene::read_file(path);
    return PlanReader(path, bytes).read(purpose);
}

Start load_start(const Plan& plan) {
    scene::Scene scene = scene::load(plan.scene, {.fixed_base = plan.fixed_base});
    if (plan.floor) scene::add_floor(scene);
    Start start;
    start.fingerprint = hash_text(plan.fingerprint, scene::save_to_string(scene) + version_string);
    start.time_step = static_cast<double>(scene.info.time_step);
    start.warnings = std::move(scene.warnings);
    start.snapshot = scene.world.save();
    return start;
}

} // namespace cairn::sweep
