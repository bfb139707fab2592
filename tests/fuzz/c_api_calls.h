// Arguments of the C API out of bytes: mostly such that calls are accepted, now and then NaN, null, stale or nonsense.
#pragma once

#include <cairn/c/cairn.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace cairn_fuzz {

class CBytes {
  public:
    explicit CBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    bool is_empty() const { return bytes_.empty(); }
    int pick(int n) { return next() % n; } // 0 to n - 1
    bool changes() { return pick(3) == 0; }
    int whole() { return pick(8) ? pick(8) : int(bits()); }
    std::uint64_t bits() {
        std::uint64_t value = 0;
        for (int i = 0; i < 8; ++i) value = value << 8 | std::uint64_t(next());
        return value;
    }
    double number() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        constexpr std::array<double, 12> odd = {
            0,    -1,    infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), 1e-30, 1e-38, 1e30,
            1e15, -1e15, 1e300,    1e6};
        if (pick(24) == 0) return odd[std::size_t(pick(int(odd.size())))];
        const double value = double(next() + 1) / 64; // above 0, to 4
        return pick(4) ? value : -value;
    }
    cairn_vec2 vec2() { return {float(number()), float(number())}; }
    cairn_vec3 vec3() { return {float(number()), float(number()), float(number())}; }
    cairn_position position() { return {number(), number(), number()}; }
    cairn_quat quat() { return {float(number()), float(number()), float(number()), float(number())}; }
    const char* text() { return pick(16) ? names_[std::size_t(pick(3))] : nullptr; }
    const cairn_geometry* geometry() { return pick(8) ? geometries[std::size_t(pick(3))] : nullptr; }
    cairn_body_id body_id() { return of(bodies); }
    cairn_shape_id shape_id() { return of(shapes); }
    cairn_joint_id joint_id() { return of(joints); }
    cairn_force_field_id force_field_id() { return of(fields); }

    // Handles that were given out, those of what is gone included.
    std::vector<cairn_body_id> bodies;
    std::vector<cairn_shape_id> shapes;
    std::vector<cairn_joint_id> joints;
    std::vector<cairn_force_field_id> fields;
    std::array<const cairn_geometry*, 3> geometries{};
    template <class Id> void keep(std::vector<Id>& list, Id id) { list.push_back(id); }

  private:
    template <class Id> Id of(const std::vector<Id>& list) {
        if (list.empty() || pick(32) == 0) return {pick(2) ? bits() : 0};
        return list[std::size_t(pick(256)) % list.size()];
    }
    int next() {
        if (bytes_.empty()) return 0;
        const int value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value;
    }
    std::span<const std::uint8_t> bytes_;
    static constexpr const char* names_[] = {"", "name", "a longer name than most"};
};

// What cairn_world_get_shape gives is the caller's.
inline void release(const cairn_shape& shape) {
    if (shape.kind == CAIRN_SHAPE_HULL) cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.hull.geometry));
    if (shape.kind == CAIRN_SHAPE_MESH) cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.mesh.geometry));
    if (shape.kind == CAIRN_SHAPE_HEIGHT_FIELD)
        cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.height_field.geometry));
}

// One of the calls 0 to c_call_count - 1, with arguments out of the bytes.
extern const int c_call_count;
cairn_result c_call(cairn_world* world, CBytes& bytes, int call);

} // namespace cairn_fuzz
