// Prints the table of impacts: measurements of fast motion, their bars, and whether each passes.
//
// usage: cairn_impacts [--list] [--shots N] [ROW...]   All rows by default; exit status 1 if any fails.
#include "table.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

namespace {

using cairn::validation::Bar;
using cairn::validation::Row;
using cairn_test::ImpactRow;

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

const char* sign_of(Bar kind) {
    switch (kind) {
    case Bar::at_least:
        return ">=";
    case Bar::at_most:
        return "<=";
    case Bar::absolute:
        return "+-";
    default:
        return "~";
    }
}

// Prints a row of the table; returns the number of its lines that fail.
int print(const ImpactRow& row, int shots) {
    const double start = processor_seconds();
    const std::vector<Row> lines = row.measure(shots);
    std::printf("%s (%s), %.1f s\n", row.name, row.about, processor_seconds() - start);
    int failed = 0;
    for (const Row& line : lines) {
        failed += !line.passes();
        std::printf("  %-4s %-62s %10.5g  %s %g", line.passes() ? "ok" : "FAIL", line.quantity.c_str(), line.measured,
                    sign_of(line.kind), line.bar);
        if (line.kind == Bar::relative) std::printf(" of %g", line.expected);
        if (!line.note.empty()) std::printf("   (%s)", line.note.c_str());
        std::printf("\n");
    }
    std::fflush(stdout);
    return failed;
}

const ImpactRow* find(const char* name) {
    for (const ImpactRow& row : cairn_test::impact_rows())
        if (std::strcmp(row.name, name) == 0) return &row;
    return nullptr;
}

int list() {
    for (const ImpactRow& row : cairn_test::impact_rows()) std::printf("%-16s %s\n", row.name, row.about);
    return 0;
}

int refuse(const char* argument) {
    std::fprintf(stderr, "cairn_impacts: %s: no such row\nusage: cairn_impacts [--list] [--shots N] [ROW...]\n",
                 argument);
    return 2;
}

} // namespace

int main(int argc, char** argv) {
    std::vector<const ImpactRow*> chosen;
    int shots = 0;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--list") == 0) return list();
        if (std::strcmp(argv[i], "--shots") == 0 && i + 1 < argc && std::atoi(argv[i + 1]) > 0)
            shots = std::atoi(argv[++i]);
        else if (const ImpactRow* row = find(argv[i]))
            chosen.push_back(row);
        else
            return refuse(argv[i]);
    }
    if (chosen.empty())
        for (const ImpactRow& row : cairn_test::impact_rows()) chosen.push_back(&row);
    const double start = processor_seconds();
    int failed = 0;
    for (const ImpactRow* row : chosen) failed += print(*row, shots);
    std::printf("%d lines fail, %.1f s\n", failed, processor_seconds() - start);
    return failed > 0;
}
