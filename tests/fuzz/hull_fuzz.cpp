// Fuzzes build_hull: any bytes are points; they are rejected with an Error, or the hull passes every check.

//
// The first byte selects how the others are read: as raw floats, or as small integers on a lattice (which finds
// coplanar and collinear points much sooner), scaled, shifted or with a little noise. `./dev fuzz` runs it; its corpus
// also runs with the tests, without a fuzzer (corpus_main.cpp).
#include "hull_check.h"

#include <cairn/error.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

std::vector<cairn::math::Vec3> read_points(const std::uint8_t* data, std::size_t size) {
    std::vector<cairn::math::Vec3> points;
    if (size < 1) return points;
    const int mode = data[0] & 3;
    const float shift = (data[0] & 4) ? 1000.0f : 0.0f;
    const float flatness[] = {1.0f, 1e-2f, 1e-4f, 3e-5f};
    const float flat = flatness[(data[0] >> 3) & 3], thin = (data[0] & 32) ? 1e-3f : 1.0f;
    ++data, --size;
    if (mode == 0) {
        for (; size >= 12; data += 12, size -= 12) {
            cairn::math::Vec3 p;
            std::memcpy(&p, data, 12);
            points.push_back(p);
        }
        return points;
    }
    for (; size >= 3; data += 3, size -= 3) {
        float c[3];
        for (int k = 0; k < 3; ++k) {
            const int value = std::int8_t(data[k]);
            c[k] = mode == 1 ? float(value / 16) : float(value >> 5);
            if (mode == 2) c[k] += 1e-6f * float(value & 31); // a lattice with noise
            if (mode == 3) c[k] += 1e-3f * float((value & 31) * (value & 31));
        }
        points.push_back({c[0] + shift, c[1] * flat - shift, c[2] * thin});
    }
    return points;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::vector<cairn::math::Vec3> points = read_points(data, size);
    try {
        const cairn::HullData hull = cairn::build_hull(points);
        if (const std::string wrong = cairn::check_hull(points, hull); !wrong.empty()) {
            std::fprintf(stderr, "hull_fuzz: %s\n", wrong.c_str());
            std::abort();
        }
    } catch (const cairn::Error& error) {
        if (error.field() != "Hull points" || error.code() != cairn::ErrorCode::invalid_value) std::abort();
    }
    return 0;
}
