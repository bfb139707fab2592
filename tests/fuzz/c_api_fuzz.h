// Sequences of calls of the C API, and how often each call was accepted and rejected in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace cairn_fuzz {

struct CCallCount {
    std::size_t accepted = 0, refused = 0;
    bool can_fail = false;
};
const std::map<std::string, CCallCount>& c_call_counts();

} // namespace cairn_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
