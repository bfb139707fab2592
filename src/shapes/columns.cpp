#include "shapes/columns.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace cairn {

using math::DVec3;

namespace {

using namespace columns;

constexpr std::size_t block = 8, max_kept = 4;

constexpr std::size_t round_up(std::size_t count, std::size_t width) { return (count + width - 1) / width * width; }

} // namespace

Columns::Columns(std::span<const math::Vec3> points) : size_(points.size()) {
    room_ = round_up(size_, block);
    all_.resize(3 * room_);
    for (std::size_t k = 0; k < room_; ++k) {
        const math::Vec3& p = points[std::min(k, size_ - 1)];
        for (std::size_t i = 0; i < 3; ++i) {
            all_[i * room_ + k] = p[int(i)];
            largest_ = std::fabs(p[int(i)]) > largest_ ? std::fabs(p[int(i)]) : largest_;
        }
    }
}

// First finds the greatest dot product in floats, and all candidates within the rounding error of it. If there are
// several, they are compared in double precision.
std::size_t Columns::farthest(const DVec3& d) const {
    const DVec3 size = math::abs(d);
    const double greater_xy = size.x > size.y ? size.x : size.y, greatest = greater_xy > size.z ? greater_xy : size.z;
    if (!(greatest > 0)) return 0;
    const double scale = 1 / greatest;
    const F4 dx = splat(float(scale * d.x)), dy = splat(float(scale * d.y)), dz = splat(float(scale * d.z));
    const float *const x = column(0), *const y = column(1), *const z = column(2);
    F4 kept[2 * max_kept]; // the products of the first blocks, which are all blocks of most hulls
    const auto along = [&](std::size_t i) { return load(x + i) * dx + load(y + i) * dy + load(z + i) * dz; };
    const std::size_t blocks = room_ / block, in_kept = blocks < max_kept ? blocks : max_kept;
    F4 most = splat(-std::numeric_limits<float>::infinity()), more = most;
    for (std::size_t i = 0; i < in_kept; ++i) {
        kept[2 * i] = along(block * i), kept[2 * i + 1] = along(block * i + 4);
        most = greater(kept[2 * i], most), more = greater(kept[2 * i + 1], more);
    }
    for (std::size_t i = in_kept; i < blocks; ++i)
        most = greater(along(block * i), most), more = greater(along(block * i + 4), more);
    most = greater(more, most);
    // A dot product sums three products of factors up to 1 and largest_. Rounding of these and of the sums adds up to
    // at most 6 x 2^-24 for each of the two points compared.
    const float least = greatest_of(most) - 2.4e-6f * largest_;
    I4 count = {}, places = {}, place = {0, 1, 2, 3};
    for (std::size_t i = 0; i < 2 * blocks; ++i) {
        const I4 may_be = (i < 2 * in_kept ? kept[i] : along(4 * i)) >= splat(least);
        count -= may_be, places |= may_be & place, place += 4;
    }
    if (count[0] + count[1] + count[2] + count[3] == 1)
        return std::size_t(places[0] | places[1] | places[2] | places[3]);
    return farthest_of(d, scale, least);
}

std::size_t Columns::nearly_farthest(const DVec3& d) const {
    const float *const x = column(0), *const y = column(1), *const z = column(2);
    constexpr std::size_t at_once = 8;
    const F4 dx = splat(float(d.x)), dy = splat(float(d.y)), dz = splat(float(d.z));
    F4 products[at_once];
    float farthest = -std::numeric_limits<float>::infinity();
    std::size_t best = 0;
    for (std::size_t first = 0; first < room_; first += 4 * at_once) {
        const std::size_t left = (room_ - first) / 4, count = left < at_once ? left : at_once;
        F4 most = splat(farthest);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = first + 4 * k;
            products[k] = load(x + i) * dx + load(y + i) * dy + load(z + i) * dz;
            most = greater(products[k], most);
        }
        most = spread_greatest(most);
        if (!(most[0] > farthest)) continue;
        farthest = most[0];
        unsigned places = 0;
        for (std::size_t k = 0; k < count; ++k) places |= bits(products[k] == most) << (4 * k);
        best = first + static_cast<std::size_t>(__builtin_ctz(places));
    }
    return best;
}

Columns::Range Columns::range(const math::Vec3& d) const {
    const float *const x = column(0), *const y = column(1), *const z = column(2);
    const F4 dx = splat(d.x), dy = splat(d.y), dz = splat(d.z);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    F4 most = splat(-infinity), least = splat(infinity);
    for (std::size_t i = 0; i < room_; i += 4) {
        const F4 along = load(x + i) * dx + load(y + i) * dy + load(z + i) * dz;
        most = greater(along, most), least = lesser(along, least);
    }
    return {-greatest_of(-least), greatest_of(most)};
}

// The farthest of the points whose dot product with scale * d, in floats, is at least `least`.
std::size_t Columns::farthest_of(const DVec3& d, double scale, float least) const {
    const float *const x = column(0), *const y = column(1), *const z = column(2);
    const F4 dx = splat(float(scale * d.x)), dy = splat(float(scale * d.y)), dz = splat(float(scale * d.z));
    double best_along = -std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t i = 0; i < room_; i += 4) {
        const I4 may_be = load(x + i) * dx + load(y + i) * dy + load(z + i) * dz >= splat(least);
        if (!any(may_be)) continue;
        for (std::size_t k = i; k < i + 4 && k < size_; ++k) {
            if (may_be[k - i] == 0) continue;
            const double exact = math::dot(DVec3{x[k], y[k], z[k]}, d);
            if (exact > best_along) best_along = exact, best = k;
        }
    }
    return best;
}

PlaneColumns::PlaneColumns(std::span<const math::Vec3> normals, std::span<const float> offsets)
    : size_(normals.size()), room_(round_up(size_, width)) {
    all_.resize(4 * room_);
    for (std::size_t k = 0; k < room_; ++k) {
        const std::size_t from = std::min(k, size_ - 1);
        for (std::size_t i = 0; i < 3; ++i) all_[i * room_ + k] = normals[from][int(i)];
        all_[3 * room_ + k] = k < size_ ? offsets[k] : std::numeric_limits<float>::infinity();
    }
}

} // namespace cairn
