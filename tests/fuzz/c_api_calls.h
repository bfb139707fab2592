// Arguments of the C API from bytes: mostly valid ones, sometimes NaN, null, stale handles or arbitrary values.
#pragma once

#include <cairn/c/cairn.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace cairn_fuzz {

// Ends the program if a condition that must hold does not.
void require(bool holds, const char* what);

class CBytes {
  public:
    explicit CBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    bool is_empty() const { return bytes_.empty(); }
    int pick(int n) { return next() % n; } // 0 to n - 1
    bool changes() { return pick(3) == 0; }
    int whole() { return pick(8) ? pick(8) : int(bits()); }
    int whole_between(int low, int high) { return pick(16) ? low + pick(high - low + 1) : whole(); }
    std::uint64_t bits() {
        std::uint64_t value = 0;
        for (int i = 0; i < 8; ++i) value = value << 8 | std::uint64_t(next());
        return value;
    }
    double number() {
        if (pick(24) == 0) return odd();
        const double value = usual();
        return pick(4) ? value : -value;
    }
    double positive() { return pick(32) ? usual() : pick(4) ? odd() : -usual(); }
    double at_least_zero() { return pick(8) ? positive() : 0; }
    double between(double low, double high) { return pick(32) ? low + (high - low) * (next() / 255.0) : odd(); }
    cairn_vec2 vec2() { return {float(number()), float(number())}; }
    cairn_vec3 vec3() { return {float(number()), float(number()), float(number())}; }
    cairn_position position() { return {number(), number(), number()}; }
    cairn_quat quat() { return {float(number()), float(number()), float(number()), float(number())}; }
    const char* text() { return pick(16) ? names_[std::size_t(pick(5))] : nullptr; }
    const cairn_geometry* geometry() {
        return pick(16) ? geometries[std::size_t(pick(256)) % geometries.size()] : nullptr;
    }
    // A geometry of that kind: 0 a hull, 1 a mesh, 2 a height field; rarely of another kind.
    const cairn_geometry* geometry(int kind) { return pick(16) ? geometries[std::size_t(kind)] : geometry(); }
    cairn_body_id body_id() { return of(bodies); }
    cairn_shape_id shape_id() { return of(shapes); }
    cairn_joint_id joint_id() { return of(joints); }
    cairn_force_field_id force_field_id() { return of(fields); }

    // Handles that any world has returned, including those of removed objects and of destroyed worlds.
    std::vector<cairn_body_id> bodies;
    std::vector<cairn_shape_id> shapes;
    std::vector<cairn_joint_id> joints;
    std::vector<cairn_force_field_id> fields;
    std::vector<cairn_geometry*> geometries; // the first three are one of each kind
    template <class Id> void keep(std::vector<Id>& list, Id id) { list.push_back(id); }

  private:
    double usual() { return double(next() + 1) / 64; } // above 0, to 4
    double odd() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        constexpr std::array<double, 16> odd = {
            0,     -1,    infinity, -infinity, std::numeric_limits<double>::quiet_NaN(),
            1e-30, 1e-38, 1e30,     1e15,      -1e15,
            1e300, 1e6,   -0.0,     5e-324,    3.4e38,
            -1e6};
        return odd[std::size_t(pick(int(odd.size())))];
    }
    // The newest handles are drawn more often: old ones are mostly stale.
    template <class Id> Id of(const std::vector<Id>& list) {
        if (list.empty() || pick(32) == 0) return {pick(2) ? bits() : 0};
        const std::size_t among = pick(4) ? std::min<std::size_t>(list.size(), 8) : list.size();
        return list[list.size() - 1 - std::size_t(pick(256)) % among];
    }
    int next() {
        if (bytes_.empty()) return 0;
        const int value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value;
    }
    std::span<const std::uint8_t> bytes_;
    static constexpr const char* names_[] = {"", "name", "a longer name than most", "\xff\xfe not UTF-8", "\n\t\"'<&"};
};

template <class T>
concept Versioned = requires(T value) {
    value.struct_size;
};

// A caller's structures on the heap, with exactly as many bytes as they claim: a sanitizer detects any access beyond
// them.
template <class T> class Block {
  public:
    Block(std::size_t size, const T& first) : bytes_(size) {
        for (std::size_t at = 0; at < size; at += sizeof(T))
            std::memcpy(bytes_.data() + at, &first, std::min(size - at, sizeof(T)));
    }
    T* data() { return reinterpret_cast<T*>(bytes_.data()); }
    const std::vector<std::byte>& bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_; // from operator new, aligned for anything
};

// An argument that a caller passes by pointer; null in one of `null_in` cases.
template <class T> class Given {
  public:
    Given(CBytes& bytes, const T& value, int null_in)
        : is_null_(bytes.pick(null_in) == 0), block_(size_of(value), value) {}
    const T* get() { return is_null_ ? nullptr : block_.data(); }

  private:
    static std::size_t size_of(const T& value) {
        if constexpr (Versioned<T>)
            return std::max<std::size_t>(std::min<std::size_t>(value.struct_size, sizeof(T)), sizeof value.struct_size);
        else
            return sizeof(T);
    }
    bool is_null_;
    Block<T> block_;
};

// Memory for the results of a call; rarely null.
template <class T> class Room {
  public:
    Room(CBytes& bytes, std::size_t count, T first = {})
        : Room(bytes, bytes.pick(64) == 0, count, sized(bytes, first)) {}
    T* get() { return is_null_ ? nullptr : block_.data(); }
    T& operator[](std::size_t i) { return block_.data()[i]; }
    bool is_as_it_was() const { return block_.bytes() == before_; }

  private:
    Room(CBytes&, bool is_null, std::size_t count, T first) : is_null_(is_null), block_(size_of(count, first), first) {
        before_ = block_.bytes();
    }
    static T sized(CBytes& bytes, T first) {
        if constexpr (Versioned<T>)
            if (bytes.pick(32) == 0) first.struct_size = std::uint32_t(bytes.pick(2) ? bytes.pick(256) : bytes.bits());
        return first;
    }
    static std::size_t size_of(std::size_t count, const T& first) {
        if constexpr (Versioned<T>)
            if (first.struct_size < sizeof(T))
                return std::max<std::size_t>(first.struct_size, sizeof first.struct_size);
        return count * sizeof(T);
    }
    bool is_null_;
    Block<T> block_;
    std::vector<std::byte> before_;
};

// Checks that a failed call has not modified its results.
template <class... Rooms> cairn_result done(cairn_result result, const Rooms&... rooms) {
    if (result != CAIRN_OK) require((rooms.is_as_it_was() && ...), "a refused call has written a result");
    return result;
}

// Releases the geometry that cairn_world_get_shape has returned.
inline void release(const cairn_shape& shape) {
    if (shape.kind == CAIRN_SHAPE_HULL) cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.hull.geometry));
    if (shape.kind == CAIRN_SHAPE_MESH) cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.mesh.geometry));
    if (shape.kind == CAIRN_SHAPE_HEIGHT_FIELD)
        cairn_geometry_release(const_cast<cairn_geometry*>(shape.as.height_field.geometry));
}

struct CCallInfo {
    const char* name;
    bool changes;  // whether it changes the world
    bool can_fail; // even with a valid world
};

// Makes one of the generated calls, with arguments from the bytes. The world may be null.
extern const std::span<const CCallInfo> c_calls;
cairn_result c_call(cairn_world* world, CBytes& bytes, int call);
cairn_world_def draw_world_def(CBytes& bytes);
cairn_joint draw_joint(CBytes& bytes);

} // namespace cairn_fuzz
