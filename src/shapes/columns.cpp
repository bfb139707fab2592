#include "shapes/columns.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace cairn {

using math::DVec3;

namespace {

using F4 = float __attribute__((vector_size(16)));
using I4 = std::int32_t __attribute__((vector_size(16)));

constexpr std::size_t block = 8;

F4 load(const float* p) {
    F4 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
F4 splat(float s) { return F4{s, s, s, s}; }
F4 greater(F4 a, F4 b) {
    const I4 m = a > b;
    return (F4)((m & (I4)a) | (~m & (I4)b));
}
bool any(I4 m) {
    std::int64_t halves[2];
    std::memcpy(halves, &m, sizeof m);
    return (halves[0] | halves[1]) != 0;
}

} // namespace

Columns::Columns(std::span<const math::Vec3> points) : size_(points.size()) {
    for (const math::Vec3& p : points) {
        x_.push_back(p.x), y_.push_back(p.y), z_.push_back(p.z);
        for (int i = 0; i < 3; ++i) largest_ = std::fabs(p[i]) > largest_ ? std::fabs(p[i]) : largest_;
    }
    while (x_.size() % block != 0) x_.push_back(x_.back()), y_.push_back(y_.back()), z_.push_back(z_.back());
}

// First in floats: the greatest product, and all that may be it, as floats are only so exact. Then these in double.
std::size_t Columns::farthest(DVec3 d) const {
    const DVec3 size = math::abs(d);
    const double greater_xy = size.x > size.y ? size.x : size.y, greatest = greater_xy > size.z ? greater_xy : size.z;
    if (!(greatest > 0)) return 0;
    const double scale = 1 / greatest;
    const F4 dx = splat(float(scale * d.x)), dy = splat(float(scale * d.y)), dz = splat(float(scale * d.z));
    const auto along = [&](std::size_t i) { return load(&x_[i]) * dx + load(&y_[i]) * dy + load(&z_[i]) * dz; };
    F4 most = along(0), more = along(4);
    for (std::size_t i = block; i < x_.size(); i += block) {
        most = greater(along(i), most);
        more = greater(along(i + 4), more);
    }
    most = greater(more, most);
    float top = most[0];
    for (int i = 1; i < 4; ++i) top = most[i] > top ? most[i] : top;
    // Three products of factors up to 1 and largest_, each of them and their sums rounded: 6 x 2^-24 at most for each
    // of two points.
    const float error = 2.4e-6f * largest_;
    const F4 least = splat(top - error);
    double best_along = -std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t i = 0; i < x_.size(); i += block) {
        const I4 may_be[2] = {along(i) >= least, along(i + 4) >= least};
        if (!any(may_be[0] | may_be[1])) continue;
        for (std::size_t k = i; k < i + block && k < size_; ++k) {
            if (may_be[(k - i) / 4][(k - i) % 4] == 0) continue;
            const double exact = math::dot(DVec3{x_[k], y_[k], z_[k]}, d);
            if (exact > best_along) best_along = exact, best = k;
        }
    }
    return best;
}

PlaneColumns::PlaneColumns(std::span<const math::Vec3> normals, std::span<const float> offsets)
    : size_(normals.size()), offset_(offsets.begin(), offsets.end()) {
    for (const math::Vec3& n : normals) x_.push_back(n.x), y_.push_back(n.y), z_.push_back(n.z);
    while (x_.size() % width != 0) {
        x_.push_back(x_.back()), y_.push_back(y_.back()), z_.push_back(z_.back());
        offset_.push_back(offset_.back());
    }
}

PlaneColumns::Floats PlaneColumns::below(std::size_t i, std::span<const math::Vec3> points) const {
    const F4 x = load(&x_[i]), y = load(&y_[i]), z = load(&z_[i]);
    const auto along = [&](math::Vec3 p) { return splat(p.x) * x + splat(p.y) * y + splat(p.z) * z; };
    F4 least = along(points[0]);
    for (std::size_t k = 1; k < points.size(); ++k) least = -greater(-along(points[k]), -least);
    return least - load(&offset_[i]);
}

} // namespace cairn
