// The state of pairs of shapes whose fat boxes overlap.
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

// Greatest separation at which a contact begins, m: the lesser of max_margin and margin_per_extent times the least
// width of the smaller shape.
inline constexpr double max_margin = 0.01, margin_per_extent = 0.25;
inline float margin_of(float width) { return std::min(float(max_margin), float(margin_per_extent) * width); }

// How a pair of shapes is tested.
enum class PairKind : std::uint8_t {
// Tested by a wide kernel (wide_pairs.h).
#define CAIRN_PAIR_KIND(first, second) first##_##second,
    CAIRN_WIDE_PAIRS(CAIRN_PAIR_KIND)
#undef CAIRN_PAIR_KIND
    // Tested one at a time, A first (convex_tests.cpp).
    convex_plane,
    convex_rectangle,
    convex_convex,
    // Pairs with a mesh or height field: the contact of the pair, a mesh contact, has patches, which are contacts of
    // their own, one for each direction in which A touches the triangles (patches.cpp).
    group,
    patch,
};
inline constexpr int wide_kinds = int(PairKind::convex_plane), tested_kinds = int(PairKind::patch);
inline bool may_be_round(PairKind k) { return k < PairKind::box_box || k > PairKind::box_rectangle; }

// The state of a pair whose fat boxes overlap, besides its ContactRecord. Body A is dynamic, except with triggers.
struct alignas(64) ContactInfo {
    std::uint32_t shape_a = 0, shape_b = 0;
    std::int32_t body_a = none, body_b = none;
    PairKind kind = PairKind::sphere_sphere;
    std::uint8_t flipped = 0;     // A is the second shape of the test
    std::uint8_t point_count = 0; // 0: not solved, as the shapes are too far apart
    std::uint8_t color = 255;     // 255: no color
    std::uint8_t b_moves = 0;     // B is dynamic
    std::uint8_t touching = 0;    // a begin event was given
    std::uint8_t in_use = 0;
    std::uint8_t bounces = 0;            // has restitution; of a mesh contact: any of its patches may have
    float match_tolerance = 0;           // m: a point nearer than this to one of the last step is the same
    float base_margin = 0;               // m: separation up to which points are kept, see margin_of
    float force = 0;                     // N: the normal force of the last step
    float load = 0;                      // N: the sustained normal force, without impacts
    float substep_time = 0;              // s: the substep length of the stored impulses
    std::uint8_t is_trigger : 1 = 0;     // never solved: only `touching` is used
    std::uint8_t is_conveyor : 1 = 0;    // B has a surface velocity
    std::uint8_t is_round : 1 = 0;       // a shape is round: contact points move over both bodies, and are found anew
    std::uint8_t is_one_way : 1 = 0;     // B is touched from one side only
    std::uint8_t is_round_touch : 1 = 0; // its only point is of two round surfaces (is_round_touch of its record)
    std::uint8_t unused : 3 = 0;
    std::uint8_t padding = 0;
    std::uint16_t surface_material = 0; // of a patch: number of the material (SurfaceMaterials)
    Travel placed_at = 0;               // travel of both bodies when the pair was last tested
    std::int32_t related = none;        // of a mesh contact: its first patch; of a patch: its mesh contact
    std::int32_t next = none;           // of a patch: the next patch of its mesh contact
};
inline bool is_group(const ContactInfo& c) { return c.kind == PairKind::group; }

// The material of the triangles of a patch.
inline std::uint16_t surface_material_of(const Manifold& patch) {
    return static_cast<std::uint16_t>(patch.features[0] >> surface_material_bit);
}

// The result of a pair's last test: the sum of its bodies' travels until which the pair stays separated; for a pair
// that has points or may get them at any time, that sum at the time of the test.
struct SeparationBudget {
    Travel until = 0;
    std::int32_t body_a = none, body_b = none;
};

// A contact and the normal in its record, for ranks that do not have the record.
struct ContactNormal {
    std::uint32_t contact;
    math::Vec3 normal;
};

// All contacts. Vectors are indexed by contact.
struct Contacts {
    ContactRecords records;
    BodyOwners owners;
    std::vector<ContactInfo> info;
    std::vector<SeparationBudget> separation_budgets;
    std::vector<std::uint32_t> free; // unused contacts
};

} // namespace cairn
