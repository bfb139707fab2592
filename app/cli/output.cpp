#include "cli/commands.h"

#include <cairn/error.h>

#include <cstdio>

namespace cairn::cli {

void print(const std::string& text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0) throw Error(ErrorCode::io, "stdout", {}, "cannot be written");
}

} // namespace cairn::cli
