/// \file handle.h
/// Versioned handles. A handle names one object of one world. Once that object is destroyed, its handle is stale for
/// good: calls detect it, and never mistake it for a newer object in the same slot. Only `World::restore` reissues
/// handles: those of objects that were created after the snapshot was taken.
#pragma once

#include <cstdint>
#include <functional>

namespace cairn {

/// 64-bit handle: 28 bits of slot index, 20 bits of generation, 16 bits of world number. Zero is the null handle. A
/// slot whose generations are used up is retired, so that handles never alias.
template <class Tag> struct Handle {
    std::uint64_t bits = 0;

    static constexpr unsigned index_bits = 28, generation_bits = 20, world_bits = 16;

    static constexpr Handle make(std::uint32_t index, std::uint32_t generation, std::uint32_t world) noexcept {
        return Handle{(std::uint64_t{world} << (index_bits + generation_bits)) |
                      (std::uint64_t{generation} << index_bits) | index};
    }
    constexpr std::uint32_t index() const noexcept { return std::uint32_t(bits & ((1u << index_bits) - 1)); }
    constexpr std::uint32_t generation() const noexcept {
        return std::uint32_t(bits >> index_bits) & ((1u << generation_bits) - 1);
    }
    constexpr std::uint32_t world() const noexcept { return std::uint32_t(bits >> (index_bits + generation_bits)); }
    constexpr bool is_null() const noexcept { return bits == 0; }
    constexpr explicit operator bool() const noexcept { return bits != 0; }
    friend constexpr bool operator==(Handle a, Handle b) noexcept = default;
    friend constexpr auto operator<=>(Handle a, Handle b) noexcept = default;
};

using BodyId = Handle<struct BodyTag>;             ///< Names a body.
using ShapeId = Handle<struct ShapeTag>;           ///< Names a shape on a body.
using JointId = Handle<struct JointTag>;           ///< Names a joint.
using ForceFieldId = Handle<struct ForceFieldTag>; ///< Names a force field.

} // namespace cairn

template <class Tag> struct std::hash<cairn::Handle<Tag>> {
    std::size_t operator()(cairn::Handle<Tag> h) const noexcept { return std::hash<std::uint64_t>{}(h.bits); }
};
