// Any bytes as a USD text layer: it loads and makes a step, or is rejected with an Error. A layer that loads can be
// saved, and the saved file loads again. `./dev fuzz` runs it; its corpus also runs with the tests, without a fuzzer
// (corpus_main.cpp).
#include "model_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return cairn::fuzz::try_model("#usda 1.0\n", data, size);
}
