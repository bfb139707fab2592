// Contacts of pairs whose bounds begin or cease to overlap.
#include "contacts/pairs.h"

#include "bodies/motion_budget.h"
#include "contacts/contact_update.h"
#include "islands/coloring.h"
#include "islands/islands.h"
#include "state/joint_links.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr float max_margin = 0.01f; // m: contacts exist before they touch
constexpr float match_per_extent = 0.1f;

float largest_extent(const Geometry& g) {
    return g.type == ShapeType::plane || g.type >= ShapeType::mesh || is_strip(g) ? unlimited_extent
                                                                                  : g.bounding_radius;
}

// Wide kernels know balls, sharp boxes, capsules with equal ends, and surfaces that have ends and one side.
bool has_wide_kernels(const Geometry& g) {
    if (g.type == ShapeType::capsule) return g.size.x == g.size.z;
    return g.type <= ShapeType::rectangle && !(g.rounding > 0) && !g.is_double_sided && !is_strip(g);
}

// By PairKind.
struct WideTest {
    ShapeType first, second;
    CollideKernel KernelTable::*kernel;
};
#define CAIRN_WIDE_TEST(first, second) {ShapeType::first, ShapeType::second, &KernelTable::first##_##second},
constexpr WideTest wide_tests[wide_kinds] = {CAIRN_WIDE_PAIRS(CAIRN_WIDE_TEST)};
#undef CAIRN_WIDE_TEST

float combine_values(float a, float b, CombineRule rule) {
    switch (rule) {
    case CombineRule::average:
        return 0.5f * (a + b);
    case CombineRule::minimum:
        return std::min(a, b);
    case CombineRule::maximum:
        return std::max(a, b);
    case CombineRule::multiply:
        return a * b;
    }
    return 0;
}

struct Sink final : PairSink {
    explicit Sink(State& state) : s(state) {}
    State& s;

    bool pair_found(std::uint32_t a, std::uint32_t b, std::uint32_t& contact) override {
        const std::int32_t body_a = s.shapes[a].body, body_b = s.shapes[b].body;
        if (body_a == body_b) return false;
        const bool a_moves = s.is_dynamic(body_a), b_moves = s.is_dynamic(body_b);
        if (!a_moves && !b_moves) return false;
        // Two that cannot be moved by any force would be pushed in vain.
        auto movable = [&](std::int32_t body) {
            const BodyMass& m = s.mass[body];
            return m.inverse_mass > 0 || !(m.inverse_inertia == math::Vec3{});
        };
        const ShapeTraits &traits_a = s.shape_traits[a], &traits_b = s.shape_traits[b];
        if (!may_meet(traits_a.filter, traits_b.filter)) return false;
        if (joint_forbids_contact(s, body_a, body_b)) return false;
        const bool is_trigger = traits_a.is_trigger || traits_b.is_trigger;
        if (!is_trigger && !movable(body_a) && !movable(body_b)) return false;
        if (traits_a.is_trigger && traits_b.is_trigger) return false;
        bool swapped = false;
        const std::optional<PairKind> kind = pair_kind(s.geometry[a], s.geometry[b], swapped);
        if (!kind) return false;
        // A is the dynamic one; of two dynamic ones, the kernel's first.
        const bool b_is_a = a_moves && b_moves ? swapped : b_moves;
        const bool flipped = swapped != b_is_a && int(*kind) < wide_kinds;
        contact = create(b_is_a ? b : a, b_is_a ? a : b, *kind, flipped, a_moves && b_moves);
        return true;
    }

    void pair_lost(std::uint32_t, std::uint32_t, std::uint32_t contact) override {
        end_contact(s, contact);
        free_contact(s, contact);
    }

    std::uint32_t create(std::uint32_t shape_a, std::uint32_t shape_b, PairKind kind, bool flipped, bool b_moves) {
        const std::uint32_t id = new_contact(s);
        ContactInfo& c = s.contacts[id];
        c.shape_a = shape_a, c.shape_b = shape_b;
        c.body_a = s.shapes[shape_a].body, c.body_b = s.shapes[shape_b].body;
        c.kind = kind;
        c.flipped = flipped;
        c.b_moves = b_moves;
        const ShapeTraits &traits_a = s.shape_traits[shape_a], &traits_b = s.shape_traits[shape_b];
        c.is_trigger = traits_a.is_trigger || traits_b.is_trigger;
        c.is_conveyor = traits_b.has_surface_velocity;
        const Geometry &a = s.geometry[shape_a], &b = s.geometry[shape_b];
        c.base_margin = std::min(max_margin, margin_per_extent * std::min(smallest_extent(a, s.shape_data[shape_a]),
                                                                          smallest_extent(b, s.shape_data[shape_b])));
        c.match_tolerance = match_per_extent * std::min(largest_extent(a), largest_extent(b));
        s.answers[id] = {0, c.body_a, c.body_b};
        drop_answer(s, id);
        combine_materials(s, id);
        return id;
    }
};

} // namespace

std::optional<PairKind> pair_kind(const Geometry& first_shape, const Geometry& second_shape, bool& swapped) {
    ShapeType a = first_shape.type, b = second_shape.type;
    swapped = a > b;
    if (swapped) std::swap(a, b);
    if (is_surface(a) && is_surface(b)) return std::nullopt;
    if (b >= ShapeType::mesh) return PairKind::group;
    if (is_surface(a)) { // planes come before the newer convex shapes
        swapped = !swapped;
        std::swap(a, b);
    }
    if (has_wide_kernels(first_shape) && has_wide_kernels(second_shape))
        for (int kind = 0; kind < wide_kinds; ++kind)
            if (wide_tests[kind].first == a && wide_tests[kind].second == b) return PairKind(kind);
    if (b == ShapeType::plane) return PairKind::convex_plane;
    return b == ShapeType::rectangle ? PairKind::convex_rectangle : PairKind::convex_convex;
}

CollideKernel wide_kernel(PairKind kind) { return kernels().*wide_tests[int(kind)].kernel; }

std::uint32_t new_contact(State& s) {
    std::uint32_t id;
    if (s.free_contacts.empty()) {
        id = std::uint32_t(s.contacts.size());
        s.contacts.emplace_back();
        s.records.emplace_back();
        s.answers.emplace_back();
    } else {
        id = s.free_contacts.back();
        s.free_contacts.pop_back();
    }
    s.contacts[id] = {};
    s.contacts[id].in_use = 1;
    s.records[id] = {};
    s.answers[id] = {};
    if (id < s.narrow.found.size()) s.narrow.found[id] = 0;
    return id;
}

void free_contact(State& s, std::uint32_t id) {
    s.contacts[id].in_use = 0;
    s.free_contacts.push_back(id);
}

PairMaterial combined_material(const Material& a, const Material& b) {
    const CombineRule friction = std::min(a.friction_combine, b.friction_combine);
    const CombineRule restitution = std::min(a.restitution_combine, b.restitution_combine);
    PairMaterial m{};
    m.friction = combine_values(a.dynamic_friction, b.dynamic_friction, friction);
    m.static_friction = std::max(combine_values(a.static_friction, b.static_friction, friction), m.friction);
    m.restitution = combine_values(a.restitution, b.restitution, restitution);
    m.rolling_radius = std::max(a.rolling_friction, b.rolling_friction);
    m.torsion_radius = std::max(a.torsional_friction, b.torsional_friction);
    return m;
}

void combine_materials(State& s, std::uint32_t contact) {
    ContactInfo& c = s.contacts[contact];
    ContactRecord& r = s.records[contact];
    const PairMaterial m = combined_material(s.materials[c.shape_a], s.materials[c.shape_b]);
    r.friction = m.friction;
    r.static_friction = m.static_friction;
    r.restitution = m.restitution;
    c.bounces = r.restitution > 0;
    r.rolling_radius = m.rolling_radius;
    r.torsion_radius = m.torsion_radius;
}

void update_pairs(State& state) {
    flush_sleep(state);
    Sink sink(state);
    state.broad_phase.update(sink);
    if (!state.dead_bodies.empty()) // their slots are given out again, and must not be pushed twice
        std::erase_if(state.pushed, [&](std::int32_t b) { return !state.body_slots.is_live(std::uint32_t(b)); });
    for (const std::uint32_t i : state.dead_shapes) state.shape_slots.recycle(i);
    for (const std::uint32_t i : state.dead_bodies) state.body_slots.recycle(i);
    state.dead_shapes.clear();
    state.dead_bodies.clear();
}

void reclaim_slots(State& state) {
    constexpr std::size_t always_allowed = 1024; // so that small worlds do not update for every body
    const std::size_t dead = state.dead_bodies.size() + state.dead_shapes.size();
    const std::size_t live = state.body_slots.live_count() + state.shape_slots.live_count();
    if (dead > always_allowed + live) update_pairs(state);
}

} // namespace cairn
