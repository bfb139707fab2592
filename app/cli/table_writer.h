// Tables of numbers, as comma-separated values or as a NumPy array.
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

// Extensions of the supported table formats, with their dots.
std::vector<std::string_view> table_extensions();

using checkpoint::TableExtent;

// How a table is started or resumed.
struct TableStart {
    bool is_resumable = false;       // written data persists if the program ends: files::Appearance::resumable
    std::optional<TableExtent> from; // continues a table that an earlier process has written
};

// Writes a table. A name that ends in `.npy` gets the NumPy format (header version 1, 2 or 3), as a one-dimensional
// structured array whose fields are the columns except those of text; any other name gets comma-separated values (RFC
// 4180), with column names in the first line and enough digits to read back the same numbers.
class TableWriter {
  public:
    // Throws Error: io; wrong_state, if the table to be resumed does not exist or has other columns.
    TableWriter(const std::filesystem::path& path, std::vector<Column> columns, const TableStart& start = {});

    // Adds the fields of a row in order, each of its column's kind; then `end_row`.
    void add(std::int64_t value);
    void add(float value);
    void add(double value);
    void add(const std::string& text);
    void end_row();

    void flush(); // to be called regularly; throws Error (io)
    // The extent from which another process can resume. Only for a resumable table that is not a stream. Throws Error
    // (io).
    TableExtent extent();
    void close(); // throws Error (io); without it, the file does not appear under its name

  private:
    std::string header(std::size_t rows) const;

    std::optional<files::OutputFile> file_;
    std::vector<Column> columns_;
    bool is_array_;
    std::size_t rows_ = 0;
    std::string waiting_;
    TableExtent sent_; // written extent, except its number of rows
};

} // namespace cairn::cli
