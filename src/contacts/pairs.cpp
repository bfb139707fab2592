#include "contacts/pairs.h"

#include "bodies/motion_budget.h"
#include "collision/flat_side.h"
#include "contacts/contact_update.h"
#include "core/room.h"
#include "islands/coloring.h"
#include "islands/islands.h"
#include "state/joint_links.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr float match_per_extent = 0.1f;

float largest_extent(const Geometry& g) {
    return g.type == ShapeType::plane || g.type >= ShapeType::mesh || is_strip(g) ? unlimited_extent
                                                                                  : g.bounding_radius;
}

// The two shape types of a wide kernel, and its member of the kernel table; indexed by PairKind.
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

// Sets what a contact derives from the sizes of its shapes.
void size_contact(const Shapes& shapes, ContactInfo& c) {
    const Geometry &a = shapes.geometry[c.shape_a], &b = shapes.geometry[c.shape_b];
    c.base_margin =
        margin_of(std::min(smallest_extent(a, shapes.data[c.shape_a]), smallest_extent(b, shapes.data[c.shape_b])));
    c.is_round = is_round(a) || is_round(b);
    c.is_one_way = shapes.traits[c.shape_b].is_one_way && !c.is_trigger;
    c.match_tolerance = match_per_extent * std::min(largest_extent(a), largest_extent(b));
}

struct Sink final : PairSink {
    Bodies& bodies;
    const Shapes& shapes;
    Contacts& contacts;
    Islands& islands;
    const Joints& joints;
    StepEvents& events;

    Sink(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands, const Joints& joints,
         StepEvents& events)
        : bodies(bodies), shapes(shapes), contacts(contacts), islands(islands), joints(joints), events(events) {}

    bool pair_found(std::uint32_t a, std::uint32_t b, std::uint32_t& contact) override {
        if (a > b) std::swap(a, b); // which is first in the tree depends on all bodies of the world
        const std::int32_t body_a = shapes.links[a].body, body_b = shapes.links[b].body;
        if (body_a == body_b) return false;
        const bool a_moves = bodies.is_dynamic(body_a), b_moves = bodies.is_dynamic(body_b);
        const ShapeTraits &traits_a = shapes.traits[a], &traits_b = shapes.traits[b];
        if (traits_a.is_trigger && traits_b.is_trigger) return false;
        const bool is_trigger = traits_a.is_trigger || traits_b.is_trigger;
        if (!is_trigger && !a_moves && !b_moves) return false;
        // A contact between two bodies that no force can move would have no effect.
        auto movable = [&](std::int32_t body) {
            const BodyMass& m = bodies.mass[body];
            return m.inverse_mass > 0 || !(m.inverse_inertia == math::Vec3{});
        };
        if (!may_meet(traits_a.filter, traits_b.filter)) return false;
        if (joint_forbids_contact(bodies, joints, body_a, body_b)) return false;
        if (!is_trigger && !movable(body_a) && !movable(body_b)) return false;
        bool swapped = false;
        const std::optional<PairKind> kind = pair_kind(shapes.geometry[a], shapes.geometry[b], swapped);
        if (!kind) return false;
        // A is the dynamic body. If neither is (with a trigger), A is the shape that is no surface, or else the
        // kinematic body.
        const auto goes_behind = [&](std::uint32_t shape, std::int32_t body) {
            return 2 * int(is_surface(shapes.geometry[shape].type)) +
                   int(bodies.settings[body].type == BodyType::static_);
        };
        const bool b_is_a = a_moves && b_moves   ? goes_first(b, a, swapped)
                            : a_moves || b_moves ? b_moves
                                                 : goes_behind(a, body_a) > goes_behind(b, body_b);
        const std::uint32_t first = b_is_a ? b : a, second = b_is_a ? a : b;
        const bool rests_on_side = rests_on_round_side(shapes.geometry[first], shapes.geometry[second]);
        const bool flipped = swapped != b_is_a && int(*kind) < wide_kinds && !rests_on_side;
        contact = create(first, second, rests_on_side ? PairKind::convex_convex : *kind, flipped, a_moves && b_moves);
        return true;
    }

    // For two dynamic bodies: whether A is the shape `a`. While the bodies pass each other, the contact point stays
    // with A (solver.md, Arms that follow the bodies), as it does with a round shape that slides over a face. If both
    // shapes are round, it stays with neither: then A is the body with the smallest moment of inertia, as no couple
    // acts on A. `otherwise`: the result if neither rule decides.
    bool goes_first(std::uint32_t a, std::uint32_t b, bool otherwise) const {
        const auto is_round = [&](std::uint32_t shape) {
            const Geometry& g = shapes.geometry[shape];
            return g.rounding > 0 || (g.type != ShapeType::box && g.type != ShapeType::hull);
        };
        if (is_round(a) != is_round(b)) return is_round(a);
        const auto inertia = [&](std::uint32_t shape) {
            const math::Vec3 i = bodies.mass[shapes.links[shape].body].inertia;
            return std::min(i.x, std::min(i.y, i.z));
        };
        return inertia(a) != inertia(b) ? inertia(a) < inertia(b) : otherwise;
    }

    void pair_lost(std::uint32_t, std::uint32_t, std::uint32_t contact) override {
        end_contact(bodies, shapes, contacts, islands, events, contact);
        free_contact(contacts, contact);
    }

    std::uint32_t create(std::uint32_t shape_a, std::uint32_t shape_b, PairKind kind, bool flipped, bool b_moves) {
        const std::uint32_t id = new_contact(contacts, shapes.links[shape_a].body);
        ContactInfo& c = contacts.info[id];
        c.shape_a = shape_a, c.shape_b = shape_b;
        c.body_a = shapes.links[shape_a].body, c.body_b = shapes.links[shape_b].body;
        c.kind = kind;
        c.flipped = flipped;
        c.b_moves = b_moves;
        const ShapeTraits &traits_a = shapes.traits[shape_a], &traits_b = shapes.traits[shape_b];
        c.is_trigger = traits_a.is_trigger || traits_b.is_trigger;
        c.is_conveyor = traits_b.has_surface_velocity;
        size_contact(shapes, c);
        contacts.separation_budgets[id] = {0, c.body_a, c.body_b};
        forget_separation(bodies, contacts, id);
        combine_materials(shapes, contacts, id);
        return id;
    }
};

} // namespace

bool has_wide_kernels(const Geometry& g) {
    if (g.type == ShapeType::capsule) return g.size.x == g.size.z;
    return g.type <= ShapeType::rectangle && !(g.rounding > 0) && !g.is_double_sided && !is_strip(g);
}

std::optional<PairKind> pair_kind(const Geometry& first_shape, const Geometry& second_shape, bool& swapped) {
    ShapeType a = first_shape.type, b = second_shape.type;
    swapped = a > b;
    if (swapped) std::swap(a, b);
    if (is_surface(a) && is_surface(b)) return std::nullopt;
    if (b >= ShapeType::mesh) return PairKind::group;
    if (is_surface(a)) { // plane types precede the newer convex types in the enum
        swapped = !swapped;
        std::swap(a, b);
    }
    if (has_wide_kernels(first_shape) && has_wide_kernels(second_shape))
        for (int kind = 0; kind < wide_kinds; ++kind)
            if (wide_tests[kind].first == a && wide_tests[kind].second == b) return PairKind(kind);
    if (b == ShapeType::plane) return PairKind::convex_plane;
    return b == ShapeType::rectangle ? PairKind::convex_rectangle : PairKind::convex_convex;
}

bool rests_on_round_side(const Geometry& a, const Geometry& b) {
    if (a.type != ShapeType::box && a.type != ShapeType::capsule) return false;
    const float width = smallest_extent(a, {});
    return may_be_flat(b, a, width) || is_nearly_flat(b, a, margin_of(width));
}

CollideKernel wide_kernel(PairKind kind) { return kernels().*wide_tests[int(kind)].kernel; }

std::uint32_t new_contact(Contacts& contacts, std::int32_t body_a) {
    std::uint32_t id;
    if (contacts.free.empty()) {
        id = std::uint32_t(contacts.info.size());
        set_size(contacts.info, id + 1), set_size(contacts.separation_budgets, id + 1);
    } else {
        id = contacts.free.back();
        contacts.free.pop_back();
    }
    contacts.info[id] = {};
    contacts.info[id].in_use = 1;
    contacts.records.open(id, contacts.owners.has(body_a));
    contacts.separation_budgets[id] = {};
    return id;
}

void free_contact(Contacts& contacts, std::uint32_t id) {
    contacts.info[id].in_use = 0;
    contacts.records.drop(id);
    contacts.free.push_back(id);
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

const Material& material_of(const Shapes& shapes, std::uint32_t shape, std::uint32_t number) {
    return number == 0 ? shapes.materials[shape] : surface_materials(shapes.data[shape])[number - 1];
}

void combine_materials(const Shapes& shapes, Contacts& contacts, std::uint32_t contact) {
    ContactInfo& c = contacts.info[contact];
    const Material& own = shapes.materials[c.shape_a];
    const PairMaterial m = combined_material(own, material_of(shapes, c.shape_b, c.surface_material));
    c.bounces = m.restitution > 0;
    if (is_group(c))
        for (const Material& other : surface_materials(shapes.data[c.shape_b]))
            c.bounces |= combined_material(own, other).restitution > 0;
    if (!contacts.records.has(contact)) return;
    ContactRecord& r = contacts.records[contact];
    r.friction = m.friction;
    r.static_friction = m.static_friction;
    r.restitution = m.restitution;
    r.rolling_radius = m.rolling_radius;
    r.torsion_radius = m.torsion_radius;
}

bool kinds_stay(const Shapes& shapes, const Contacts& contacts, std::uint32_t shape, const Geometry& changed) {
    return std::all_of(contacts.info.begin(), contacts.info.end(), [&](const ContactInfo& c) {
        if (!c.in_use || (c.shape_a != shape && c.shape_b != shape)) return true;
        const Geometry &a = shapes.geometry[c.shape_a], &b = shapes.geometry[c.shape_b];
        return rests_on_round_side(a, b) ==
               (c.shape_a == shape ? rests_on_round_side(changed, b) : rests_on_round_side(a, changed));
    });
}

void renew_contacts(const Shapes& shapes, Contacts& contacts, std::uint32_t shape) {
    for (std::uint32_t id = 0; id < contacts.info.size(); ++id) {
        ContactInfo& c = contacts.info[id];
        if (!c.in_use || (c.shape_a != shape && c.shape_b != shape)) continue;
        size_contact(shapes, c);
        c.is_conveyor = shapes.traits[c.shape_b].has_surface_velocity;
        if (c.surface_material > surface_materials(shapes.data[c.shape_b]).size()) c.surface_material = 0;
        combine_materials(shapes, contacts, id);
    }
}

void update_pairs(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, const Joints& joints,
                  BroadPhase& broad_phase, StepEvents& events, ThreadPool* thread_pool) {
    flush_sleep(bodies, shapes, islands, broad_phase);
    Sink sink(bodies, shapes, contacts, islands, joints, events);
    broad_phase.update(sink, thread_pool);
    if (!bodies.dead.empty()) // dead slots will be reused, and a new body must not be listed twice
        std::erase_if(bodies.pushed, [&](std::int32_t b) { return !bodies.slots.is_live(std::uint32_t(b)); });
    for (const std::uint32_t i : shapes.dead) shapes.slots.recycle(i);
    for (const std::uint32_t i : bodies.dead) bodies.slots.recycle(i);
    shapes.dead.clear();
    bodies.dead.clear();
}

void reclaim_slots(Bodies& bodies, Shapes& shapes, Contacts& contacts, Islands& islands, const Joints& joints,
                   BroadPhase& broad_phase, StepEvents& events) {
    const std::size_t dead = bodies.dead.size() + shapes.dead.size();
    const std::size_t live = bodies.slots.live_count() + shapes.slots.live_count();
    if (dead > live) update_pairs(bodies, shapes, contacts, islands, joints, broad_phase, events);
}

} // namespace cairn
