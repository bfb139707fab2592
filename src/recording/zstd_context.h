// The state that zstd keeps between compressions.
#pragma once

#include <zstd.h>

#include <new>

namespace cairn::recording {

struct ZstdContext {
    ZstdContext() : zstd(ZSTD_createCCtx()) {
        if (zstd == nullptr) throw std::bad_alloc();
    }
    ~ZstdContext() { ZSTD_freeCCtx(zstd); }
    ZstdContext(const ZstdContext&) = delete;
    ZstdContext& operator=(const ZstdContext&) = delete;
    ZSTD_CCtx* zstd;
};

} // namespace cairn::recording
