// Reading eight contact records side by side.
#pragma once

#include "core/cache.h"
#include "kernels/solve/solver.h"

#include <cstddef>

namespace cairn::CAIRN_ISA {

alignas(64) inline const ContactRecord empty_record = {
    .normal = {0, 1, 0},
    .friction = 0,
    .center_offset = {},
    .restitution = 0,
    .first_point = {0, 0, 0, 1e30f},
    .impulses = {},
    .friction_impulse = {},
    .torsion_impulse = 0,
    .static_friction = 0,
    .rolling_radius = 0,
    .torsion_radius = 0,
    .approach_speed = 0,
    .total_friction = {},
    .first_total = 0,
    .radius_a = 0,
    .radius_b = 0,
    .features = 0,
    .touch_time = 0,
    .more_points = {{0, 0, 0, 1e30f}, {0, 0, 0, 1e30f}, {0, 0, 0, 1e30f}},
    .more_totals = {},
    .more_padding = 0,
};

// Byte offset of a point in a record.
CAIRN_INLINE std::size_t point_offset(int i) {
    return i == 0 ? offsetof(ContactRecord, first_point)
                  : offsetof(ContactRecord, more_points) + 16 * std::size_t(i - 1);
}

CAIRN_INLINE void gather_field(const ContactRecord* const* record, std::size_t offset, f32x8& x, f32x8& y, f32x8& z,
                               f32x8& w) {
    const float* p[8];
    for (int i = 0; i < 8; ++i)
        p[i] = reinterpret_cast<const float*>(reinterpret_cast<const char*>(record[i]) + offset);
    gather4(p, x, y, z, w);
}

// The contacts of one color are scattered over the array of records.
CAIRN_INLINE void prefetch_records(const std::int32_t* ids, const ContactRecord* records) {
    for (int i = 0; i < 8; ++i) {
        const char* record = reinterpret_cast<const char*>(records + (ids[i] >= 0 ? ids[i] : 0));
        for (std::size_t at = 0; at < sizeof(ContactRecord); at += 64) prefetch(record + at);
    }
}

} // namespace cairn::CAIRN_ISA
