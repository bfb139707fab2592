// What is known of a pair of shapes whose bounds overlap.
#pragma once

#include "collision/manifold.h"
#include "collision/wide_pairs.h"
#include "kernels/solve/solver_data.h"
#include "state/contact_records.h"
#include "state/none.h"
#include "state/travel.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cairn {

// m: contacts exist before they touch, by that much, or by that share of the smaller shape's least width.
inline constexpr double max_margin = 0.01, margin_per_extent = 0.25;
inline float margin_of(float width) { return std::min(float(max_margin), float(margin_per_extent) * width); }

// How a pair of shapes is tested.
enum class PairKind : std::uint8_t {
// By a wide kernel (wide_pairs.h).
#define CAIRN_PAIR_KIND(first, second) first##_##second,
    CAIRN_WIDE_PAIRS(CAIRN_PAIR_KIND)
#undef CAIRN_PAIR_KIND
    // One at a time, A first (convex_tests.cpp).
    convex_plane,
    convex_rectangle,
    convex_convex,
    // Against the triangles of a mesh or height field: the contact of the pair is a group, and has patches, contacts of
    // their own, one for each direction in which A touches it (patches.cpp).
    group,
    patch,
};
inline constexpr int wide_kinds = int(PairKind::convex_plane), tested_kinds = int(PairKind::patch);
inline bool has_one_point(PairKind k) { return k <= PairKind::sphere_capsule; }
inline bool may_be_round(PairKind k) { return k < PairKind::box_box || k > PairKind::box_rectangle; }

// What is known of a pair of shapes whose bounds overlap, beside its ContactRecord. Body A is dynamic.
struct alignas(64) ContactInfo {
    std::uint32_t shape_a = 0, shape_b = 0;
    std::int32_t body_a = none, body_b = none;
    PairKind kind = PairKind::sphere_sphere;
    std::uint8_t flipped = 0;     // A is the kernel's second shape
    std::uint8_t point_count = 0; // 0: too far apart to be solved
    std::uint8_t color = 255;     // none
    std::uint8_t b_moves = 0;     // B is dynamic
    std::uint8_t touching = 0;    // a begin event was given
    std::uint8_t in_use = 0;
    std::uint8_t bounces = 0;         // has any restitution; of groups: any of its patches may
    float match_tolerance = 0;        // m: points closer than this to last step's are the same
    float base_margin = 0;            // m
    float force = 0;                  // N: the normal force of the last step
    float load = 0;                   // N: the sustained one, without impacts
    float substep_time = 0;           // s: that the impulses are for
    std::uint8_t is_trigger : 1 = 0;  // never solved: only `touching` counts
    std::uint8_t is_conveyor : 1 = 0; // B's surface moves
    std::uint8_t is_round : 1 = 0;    // of either shape: places of touch move over both bodies, and are found anew
    std::uint8_t is_one_way : 1 = 0;  // B holds only what comes from one side
    std::uint8_t unused : 4 = 0;
    std::uint8_t padding = 0;
    std::uint16_t surface_material = 0; // of patches: its number (SurfaceMaterials)
    Travel placed_at = 0;               // of both bodies, when the pair was tested
    std::int32_t related = none;        // group: its first patch; patch: its group
    std::int32_t next = none;           // patch: the next one of its group
};
inline bool is_group(const ContactInfo& c) { return c.kind == PairKind::group; }

// Of the triangles that a patch is on.
inline std::uint16_t surface_material_of(const Manifold& patch) {
    return static_cast<std::uint16_t>(patch.features[0] >> surface_material_bit);
}

// What was found out when a pair was tested last: that it stays apart until its bodies together have moved that far. Of
// one that has points, or may get some at any time: how far they had moved then.
struct PairAnswer {
    Travel until = 0;
    std::int32_t body_a = none, body_b = none;
};

// A contact, and the normal of its record, which few ranks have.
struct ContactNormal {
    std::uint32_t contact;
    math::Vec3 normal;
};

// All contacts; vectors are by contact.
struct Contacts {
    ContactRecords records;
    BodyOwners owners;
    std::vector<ContactInfo> info;
    std::vector<PairAnswer> answers;
    std::vector<std::uint32_t> free; // contacts that are not in use
};

} // namespace cairn
