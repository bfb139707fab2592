// Fuzzes the API: any bytes encode a sequence of calls (calls.h), which runs on one thread, on several, and on a world
// that is saved and restored in between.
#include "calls.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        cairn_fuzz::Calls({data, size}).run();
    } catch (const std::exception& broken) {
        std::fprintf(stderr, "%s\n", broken.what());
        std::abort();
    }
    return 0;
}
