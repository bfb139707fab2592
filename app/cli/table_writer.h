// Tables of numbers, as comma-separated values or as an array of NumPy.
#pragma once

#include "checkpoint/index.h"
#include "files/output_file.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::cli {

struct Column {
    enum class Kind { integer, real32, real64, text };
    std::string name;
    Kind kind = Kind::real64;
};

// Extensions of the tables that are known, with their dots.
std::vector<std::string_view> table_extensions();

using checkpoint::TableExtent;

// How a table begins.
struct TableStart {
    bool is_resumable = false;       // what is written stays if the program ends: files::Appearance::resumable
    std::optional<TableExtent> from; // goes on with what a program before has written
};

// A name that ends in `.npy` is written in the format of NumPy (version 1, 2 or 3 of its header), as a structured array
// of one dimension whose fields are the columns but those of text; anything else as comma-separated values (RFC 4180),
// whose first line names the columns, with as many digits as are needed to read back the same number.
class TableWriter {
  public:
    // Throws Error: io; wrong_state, if what it is to go on with is not there, or has other columns.
    TableWriter(const std::filesystem::path& path, std::vector<Column> columns, const TableStart& start = {});

    // The fields of a row, one after the other, each of its column's kind; then the end of the row.
    void add(std::int64_t value);
    void add(float value);
    void add(double value);
    void add(const std::string& text);
    void end_row();

    void flush(); // to be called now and then; throws Error (io)
    // What another program can go on with, from now on. Of what is resumable, and is no stream. Throws Error (io).
    TableExtent extent();
    void close(); // throws Error (io); a file that is not closed is not written

  private:
    std::string header(std::size_t rows) const;

    std::optional<files::OutputFile> file_;
    std::vector<Column> columns_;
    bool is_array_;
    std::size_t rows_ = 0;
    std::string waiting_;
    TableExtent sent_; // but for its number of rows
};

} // namespace cairn::cli
