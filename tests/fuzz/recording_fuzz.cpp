// Any bytes as a recording: it can be opened, replayed and entered at any step, or is rejected.
#include "recording/recording.h"

#include <algorithm>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto recording = cairn::recording::Recording::from_memory(
            std::string(reinterpret_cast<const char*>(data), size), "fuzz.mcap");
        cairn::recording::Replay replay(recording);
        while (replay.steps() < 20 && replay.step()) {}
        if (recording.info().steps < 40) replay.seek(recording.info().steps / 2);
        if (!recording.info().keyframes.empty()) replay.seek(recording.info().keyframes.back());
        replay.branch();
        replay.step();
    } catch (const cairn::Error&) { // rejected
    }
    return 0;
}
