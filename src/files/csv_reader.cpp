#include "files/csv_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace cairn::files {

namespace {

constexpr std::size_t max_columns = 10000;

} // namespace

CsvReader::CsvReader(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") text_.remove_prefix(3);
}

std::vector<std::string> CsvReader::row() {
    std::vector<std::string> fields;
    line_ = next_line_;
    for (bool more = true; more;) {
        if (fields.size() > max_columns) fail(fields.size(), {}, "must be one of at most 10000 columns");
        fields.push_back(field(fields.size()));
        more = !at_end() && text_[at_] == ',';
        if (more) ++at_;
    }
    if (!at_end() && text_[at_] == '\r') ++at_;
    if (!at_end() && text_[at_] == '\n') ++at_;
    ++next_line_;
    return fields;
}

double CsvReader::number(std::size_t column, const std::string& field) const {
    double number = 0.0;
    const char* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number)) fail(column, field, "must be a number");
    return number;
}

void CsvReader::fail(std::size_t column, const std::string& value, const std::string& expected) const {
    std::string shown;
    for (const char c : value.substr(0, 60)) shown += c >= ' ' && c <= '~' ? c : '?';
    throw Error(ErrorCode::invalid_file, file_ + ":" + std::to_string(line_) + ": column " + std::to_string(column + 1),
                "\"" + shown + "\"", expected);
}

void CsvReader::fail(const std::string& expected) const {
    throw Error(ErrorCode::invalid_file, file_ + ":" + std::to_string(line_), {}, expected);
}

std::string CsvReader::field(std::size_t column) {
    while (!at_end() && text_[at_] == ' ') ++at_;
    if (at_end() || text_[at_] != '"') {
        const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
        std::string result(text_.substr(at_, end - at_));
        at_ = end;
        result.erase(result.find_last_not_of(" \t") + 1);
        return result;
    }
    std::string result;
    for (++at_;; ++at_) {
        if (at_end()) fail(column, result, "must end with a quote");
        if (text_[at_] == '\n') ++next_line_;
        if (text_[at_] == '"') {
            ++at_;
            if (at_end() || text_[at_] != '"') break;
        }
        result += text_[at_];
    }
    while (!at_end() && text_[at_] == ' ') ++at_;
    if (!at_end() && std::string_view(",\r\n").find(text_[at_]) == std::string_view::npos) {
        fail(column, result, "must have nothing after its quotes");
    }
    return result;
}

} // namespace cairn::files
