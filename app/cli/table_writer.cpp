#include "cli/table_writer.h"

#include "files/checksum.h"

#include <cairn/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace cairn::cli {

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

// Quotes a text as in RFC 4180, with inner quotes doubled.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

bool is_plain(const std::string& text) { return text.find_first_of(",\"\r\n ") == std::string::npos; }

// A text as a Python string literal. Non-ASCII bytes become their Latin-1 characters.
std::string python_text(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') {
            result += std::string("\\") + c;
        } else if (c < ' ' || c > '~') {
            result += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        } else {
            result += c;
        }
    }
    return result + "'";
}

std::string_view type_of(Column::Kind kind) {
    if (kind == Column::Kind::integer) return "<i8";
    return kind == Column::Kind::real32 ? "<f4" : "<f8";
}

template <class T> void append_bytes(std::string& bytes, T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

// Whether a file starts with the part of the table that `from` describes.
bool begins(const fs::path& path, const std::string& head, bool is_array, const TableExtent& from) {
    std::ifstream file(path, std::ios::binary);
    std::string piece(head.size(), '\0');
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    // The header of an array contains the number of rows, which differs.
    if (!file || (!is_array && piece != head)) return false;
    std::uint32_t crc = 0;
    piece.resize(std::size_t{1} << 20);
    for (std::uint64_t left = from.bytes - head.size(); left > 0;) {
        const std::uint64_t now = std::min<std::uint64_t>(left, piece.size());
        if (!file.read(piece.data(), static_cast<std::streamsize>(now))) return false;
        crc = files::crc32(std::string_view(piece).substr(0, now), crc);
        left -= now;
    }
    return crc == from.rows_crc;
}

// Ensures that the written part of a resumed table is in the file that `files::OutputFile` continues; if the earlier
// run was completed, it has already been renamed.
void require_beginning(const fs::path& path, const std::string& head, bool is_array, const TableExtent& from,
                       std::uint32_t columns) {
    const std::string name = path.generic_string();
    if (columns != from.columns || from.bytes < head.size()) {
        throw Error(ErrorCode::wrong_state, name, {},
                    "has other columns than the run that continues: --columns must be as before");
    }
    const fs::path place = files::destination_of(path).path, unfinished = files::unfinished_beside(place);
    if (begins(unfinished, head, is_array, from)) return;
    if (!begins(place, head, is_array, from)) {
        throw Error(ErrorCode::wrong_state, name, {},
                    fmt::format("cannot be continued: its first {} bytes are in neither {} nor {}; another file gets "
                                "the steps after the checkpoint",
                                from.bytes, unfinished.generic_string(), place.generic_string()));
    }
    std::error_code error;
    fs::remove(unfinished, error);
    fs::copy_file(place, unfinished, error);
    if (error) throw Error(ErrorCode::io, unfinished.generic_string(), {}, "cannot be written: " + error.message());
}

} // namespace

std::vector<std::string_view> table_extensions() { return {".csv", ".npy"}; }

TableWriter::TableWriter(const std::filesystem::path& path, std::vector<Column> columns, const TableStart& start)
    : columns_(std::move(columns)), is_array_(files::extension_of(path) == ".npy") {
    const std::string head = header(0);
    sent_.columns = files::crc32(head);
    if (start.from) require_beginning(path, head, is_array_, *start.from, sent_.columns);
    file_.emplace(path, start.is_resumable ? files::Appearance::resumable : files::Appearance::when_whole,
                  start.from ? start.from->bytes : 0);
    if (start.from) {
        sent_ = *start.from;
        rows_ = start.from->rows;
        return;
    }
    waiting_ = head;
    flush(); // makes the header visible to the reader of a pipe at once
    sent_.rows_crc = 0;
}

// The header. That of an array has the same length for any number of rows (format: numpy.lib.format).
std::string TableWriter::header(std::size_t rows) const {
    std::string names;
    for (const Column& column : columns_) {
        if (!is_array_) {
            names += (names.empty() ? "" : ",") + (is_plain(column.name) ? column.name : quoted(column.name));
        } else if (column.kind != Column::Kind::text) {
            names += fmt::format("({}, '{}'), ", python_text(column.name), type_of(column.kind));
        }
    }
    if (!is_array_) return names + "\n";
    std::string text = fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", names, rows);
    constexpr std::size_t alignment = 64, longest_count = 20;
    const std::size_t digits = std::to_string(rows).size(), longest = text.size() + longest_count - digits;
    const std::size_t before = longest + 11 < 65536 ? 10 : 12; // magic, version and header length of 2 or 4 bytes
    const std::size_t whole = (before + longest + 1 + alignment - 1) / alignment * alignment;
    text.append(whole - before - 1 - text.size(), ' ');
    text += '\n';
    std::string start("\x93NUMPY", 6);
    start += before == 10 ? '\1' : '\2';
    start += '\0';
    if (before == 10) {
        append_bytes(start, static_cast<std::uint16_t>(text.size()));
    } else {
        append_bytes(start, static_cast<std::uint32_t>(text.size()));
    }
    return start + text;
}

void TableWriter::add(std::int64_t value) {
    if (is_array_) return append_bytes(waiting_, value);
    fmt::format_to(std::back_inserter(waiting_), "{},", value);
}

void TableWriter::add(float value) {
    if (is_array_) return append_bytes(waiting_, value);
    fmt::format_to(std::back_inserter(waiting_), "{},", value);
}

void TableWriter::add(double value) {
    if (is_array_) return append_bytes(waiting_, value);
    fmt::format_to(std::back_inserter(waiting_), "{},", value);
}

void TableWriter::add(const std::string& text) {
    if (!is_array_) waiting_ += quoted(text) + ",";
}

void TableWriter::end_row() {
    ++rows_;
    if (!is_array_) waiting_.back() = '\n';
}

void TableWriter::flush() {
    if (is_array_ && file_->is_stream()) return; // the header contains the number of rows, which is not known yet
    file_->write(waiting_);
    sent_.bytes += waiting_.size();
    sent_.rows_crc = files::crc32(waiting_, sent_.rows_crc);
    waiting_.clear();
}

TableExtent TableWriter::extent() {
    flush();
    file_->sync();
    TableExtent extent = sent_;
    extent.rows = rows_;
    return extent;
}

void TableWriter::close() {
    if (is_array_) {
        const std::string start = header(rows_);
        if (file_->is_stream()) {
            waiting_.replace(0, start.size(), start);
            file_->write(std::exchange(waiting_, {}));
        } else {
            flush();
            file_->overwrite(0, start);
        }
    } else {
        flush();
    }
    file_->close();
}

} // namespace cairn::cli
