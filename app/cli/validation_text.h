// The results of the validation cases, as text.
#pragma once

#include "validation/validation.h"

#include <string>
#include <vector>

namespace cairn::cli {

struct Measured {
    const validation::Case* entry = nullptr;
    validation::Result result; // rows of one quantity are adjacent
};

struct Count {
    std::size_t passed = 0, rows = 0;
};

Count count_rows(const validation::Result& result);
Count count_rows(const std::vector<Measured>& cases);

std::string number_text(double value);            // six significant digits
std::string bar_text(const validation::Row& row); // "within 1 %", "at most 0.01"

// For terminals: a table for each case, and the last line "N of M rows pass".
std::string text_report(const std::vector<Measured>& cases);

// One JSON object: the rows, published reference values, and the counts.
std::string json_report(const std::vector<Measured>& cases);

// All rows as a Markdown page.
std::string markdown_report(const std::vector<Measured>& cases);

} // namespace cairn::cli
