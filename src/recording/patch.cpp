#include "recording/patch.h"

#include "recording/zstd_context.h"

#include <cairn/error.h>

#include <zstd.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <new>

namespace cairn::recording {

namespace {

// Compression level: the fastest of zstd that finds more than repeated bytes, in half the time of the default level.
constexpr int level = 1;
constexpr unsigned long long largest = 1ull << 31; // greatest size of a state, bytes, as for chunks

} // namespace

struct Patcher::Context : ZstdContext {};

Patcher::Patcher() : context_(std::make_unique<Context>()) {}
Patcher::~Patcher() = default;

std::string Patcher::patch(std::string_view before, std::string_view after) {
    ZSTD_CCtx* const zstd = context_->zstd;
    // log2 of the window size, which covers both inputs
    const int window = std::clamp(int(std::bit_width(before.size() + after.size())), 17, 30);
    bool fails = false;
    const auto check = [&](std::size_t result) { fails = fails || ZSTD_isError(result) != 0; };
    check(ZSTD_CCtx_setParameter(zstd, ZSTD_c_compressionLevel, level));
    check(ZSTD_CCtx_setParameter(zstd, ZSTD_c_windowLog, window));
    check(ZSTD_CCtx_setParameter(zstd, ZSTD_c_enableLongDistanceMatching, 1));
    check(ZSTD_CCtx_refPrefix(zstd, before.data(), before.size()));
    std::string result(ZSTD_compressBound(after.size()), '\0');
    const std::size_t size = ZSTD_compress2(zstd, result.data(), result.size(), after.data(), after.size());
    check(size);
    if (fails) throw std::bad_alloc(); // the only possible error, given the bound on the size
    result.resize(size);
    result.shrink_to_fit();
    return result;
}

std::string patched(std::string_view before, std::string_view patch, const std::string& where) {
    const unsigned long long size = ZSTD_getFrameContentSize(patch.data(), patch.size());
    // size unknown or invalid
    if (size > largest) throw Error(ErrorCode::invalid_file, where, "", "does not state its size");
    const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
    if (context == nullptr) throw std::bad_alloc();
    std::string result(std::size_t(size), '\0');
    ZSTD_DCtx_refPrefix(context.get(), before.data(), before.size());
    const std::size_t count =
        ZSTD_decompressDCtx(context.get(), result.data(), result.size(), patch.data(), patch.size());
    if (ZSTD_isError(count) != 0 || count != result.size())
        throw Error(ErrorCode::invalid_file, where, ZSTD_isError(count) != 0 ? ZSTD_getErrorName(count) : "",
                    "cannot be computed from the previous state");
    return result;
}

} // namespace cairn::recording
