// Reads tables of comma-separated values (RFC 4180) line by line. Error messages name the file, the line and the
// column.
#pragma once

#include <cairn/error.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::files {

// Fields of a table in order. A quoted field may contain commas, line breaks and doubled quotes. A byte order mark at
// the start is skipped.
class CsvReader {
  public:
    // `file`: name of the table in messages. The text must outlive the reader.
    CsvReader(std::string_view text, std::string file);
    bool at_end() const { return at_ >= text_.size(); }

    // The fields of the next line. Throws Error (invalid_file) for more than 10,000 fields, or a quote without an end.
    std::vector<std::string> row();

    // The finite number in a field of the current line. `column` counts from 0. Throws Error (invalid_file).
    double number(std::size_t column, const std::string& field) const;

    [[noreturn]] void fail(std::size_t column, const std::string& value, const std::string& expected) const;
    [[noreturn]] void fail(const std::string& expected) const;

  private:
    std::string field(std::size_t column);

    std::string_view text_;
    std::string file_;
    std::size_t at_ = 0;
    int line_ = 1, next_line_ = 1;
};

} // namespace cairn::files
