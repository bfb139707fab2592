// Shapes: adding, changing and removing them. Every argument is checked before anything changes.
#include "bodies/bodies.h"
#include "bodies/finalize.h"
#include "bodies/motion_budget.h"
#include "contacts/pairs.h"
#include "islands/islands.h"
#include "shapes/surface_materials.h"
#include "state/state.h"
#include "world/impl.h"
#include "world/validate.h"

namespace cairn {

namespace {

void unlink_shape(Bodies& bodies, Shapes& shapes, std::uint32_t shape) {
    ShapeLinks& links = shapes.links[shape];
    BodyLinks& body = bodies.links[links.body];
    if (links.previous == none)
        body.first_shape = links.next;
    else
        shapes.links[links.previous].next = links.next;
    if (links.next == none)
        body.last_shape = links.previous;
    else
        shapes.links[links.next].previous = links.previous;
}

void link_shape(Bodies& bodies, Shapes& shapes, std::uint32_t shape, std::int32_t body) {
    ShapeLinks& links = shapes.links[shape];
    BodyLinks& owner = bodies.links[body];
    links.body = body;
    links.next = none;
    links.previous = owner.last_shape;
    if (owner.last_shape == none)
        owner.first_shape = std::int32_t(shape);
    else
        shapes.links[owner.last_shape].next = std::int32_t(shape);
    owner.last_shape = std::int32_t(shape);
}

// The mass that a body gets from the densities of its shapes must be within the range of masses that users may set.
// `replaced`: the shape of the body that is replaced, or none.
void require_mass_in_range(const Bodies& bodies, const Shapes& shapes, std::int32_t body, std::int32_t replaced,
                           const Shape& shape, const ShapeDef& def) {
    const BodyMass& mass = bodies.mass[body];
    if (bodies.settings[body].own_type != BodyType::dynamic || !mass.follows_shapes || mass.has_given_mass ||
        !(def.density > 0))
        return;
    double sum = geometry_mass(make_geometry(shape, {}), make_shape_data(shape), def.density).mass;
    for (std::int32_t i = bodies.links[body].first_shape; i != none; i = shapes.links[i].next)
        if (i != replaced) sum += geometry_mass(shapes.geometry[i], shapes.data[i], shapes.links[i].density).mass;
    if (!(sum >= smallest_mass && sum <= largest_mass))
        refuse("ShapeDef.density", to_text(def.density),
               "must give the body a mass from 1e-32 to 1e32 kg, not " + to_text(sum) + " kg");
}

void require_still_surface(const char* field, const Vec3& velocity) {
    if (velocity != Vec3(0.0f))
        throw Error(ErrorCode::wrong_state, field, to_text(velocity),
                    "must be zero on a dynamic body: only surfaces of static and kinematic ones may move");
}

// A one-way shape must present a side as a whole, unlike infinite planes, meshes and height fields, and must not move
// by forces.
void require_ends(ShapeType type, bool is_dynamic, const Vec3& one_way) {
    if (one_way == Vec3(0.0f)) return;
    if (is_dynamic)
        throw Error(ErrorCode::wrong_state, "ShapeDef.one_way", to_text(one_way),
                    "must be zero on a dynamic body: only shapes of static and kinematic bodies can be one-way");
    if (type == ShapeType::plane || type >= ShapeType::mesh)
        throw Error(ErrorCode::wrong_state, "ShapeDef.one_way", to_text(one_way),
                    "must be zero for infinite planes, meshes and height fields");
}

// Surface velocity and one-way direction in the frame of the geometry. It is the frame of the shape, except for planes,
// whose geometry has its normal as y axis.
ShapeTraits make_traits(const Geometry& geometry, const ShapeDef& def) {
    const auto in_geometry = [&](const Vec3& v) {
        if (v == Vec3(0.0f)) return math::Vec3{};
        return is_plane(geometry.type)
                   ? math::rotate_back(geometry.rotation, math::rotate(to_math(def.rotation), to_math(v)))
                   : to_math(v);
    };
    ShapeTraits traits;
    traits.filter = def.filter;
    traits.is_trigger = def.is_trigger;
    traits.surface_velocity = in_geometry(def.surface_velocity);
    traits.has_surface_velocity = !(traits.surface_velocity == math::Vec3{});
    traits.one_way = in_geometry(def.one_way);
    traits.is_one_way = !(traits.one_way == math::Vec3{});
    return traits;
}

// Throws unless the body may have this shape. `replaced`: as for require_mass_in_range.
void require_fit(const State& s, std::int32_t body, std::int32_t replaced, const Shape& shape, const ShapeDef& def,
                 const char* argument) {
    validate(shape);
    validate(def);
    const bool is_dynamic = s.bodies.settings[body].own_type == BodyType::dynamic;
    if (is_surface(make_geometry(shape, {}).type) && is_dynamic)
        throw Error(ErrorCode::wrong_state, argument, shape_name(shape),
                    "has no mass: add it to static or kinematic bodies, or its Hull to dynamic ones");
    if (is_dynamic) require_still_surface("ShapeDef.surface_velocity", def.surface_velocity);
    require_ends(make_geometry(shape, {}).type, is_dynamic, def.one_way);
    require_mass_in_range(s.bodies, s.shapes, body, replaced, shape, def);
}

Transform place_of(const ShapeDef& def) { return {Position(def.position), def.rotation}; }

ShapeDef with_unit_rotation(const ShapeDef& def) {
    ShapeDef result = def;
    result.rotation = checked_rotation("ShapeDef.rotation", def.rotation);
    return result;
}

bool is_same(const CollisionFilter& a, const CollisionFilter& b) {
    return a.layers == b.layers && a.collides_with == b.collides_with;
}

// Whether a shape can change from `a` to `b` without a change in how its pairs are found and tested.
bool is_tested_alike(const Geometry& a, const Geometry& b) {
    return a.type == b.type && has_wide_kernels(a) == has_wide_kernels(b) && a.is_double_sided == b.is_double_sided;
}

} // namespace

void forget_ground(Characters& characters, std::uint32_t shape) {
    for (Character& c : characters.all)
        if (c.ground_shape == std::int32_t(shape)) c.ground_body = c.ground_shape = none;
}

void retire_shape(Shapes& shapes, BroadPhase& broad_phase, Characters& characters, std::uint32_t shape) {
    forget_ground(characters, shape);
    broad_phase.remove(shape);
    shapes.slots.kill(shape);
    shapes.dead.push_back(shape);
}

void World::Impl::define_shape(std::uint32_t i, Shape&& shape, const ShapeDef& def) {
    state.shapes.geometry[i] = make_geometry(shape, place_of(def));
    state.shapes.data[i] = make_shape_data(shape);
    state.shapes.materials[i] = def.material;
    state.shapes.traits[i] = make_traits(state.shapes.geometry[i], def);
    state.shapes.links[i].density = def.density;
    shape_of[i] = std::move(shape);
    def_of[i] = def;
}

ShapeId World::add_shape(BodyId id, const Shape& shape, const ShapeDef& def) {
    Impl::Change change(*impl_, commands::world_add_shape, id, shape, def);
    const std::int32_t b = impl_->index_of(id);
    State& s = impl_->state;
    require_fit(s, b, none, shape, def, "World::add_shape shape");
    require_slot(s.shapes.slots, "World::add_shape");
    Shape own(shape); // both may refer to elements of this world's lists, which grow
    const ShapeDef own_def = with_unit_rotation(def);
    change.begin();
    const std::uint32_t i = s.shapes.slots.create();
    make_room(s.shapes.geometry, i), make_room(s.shapes.data, i), make_room(s.shapes.poses, i),
        make_room(s.shapes.links, i), make_room(s.shapes.materials, i), make_room(s.shapes.traits, i);
    make_room(impl_->shape_of, i), make_room(impl_->def_of, i);
    s.shapes.links[i] = {};
    impl_->define_shape(i, std::move(own), own_def);
    link_shape(s.bodies, s.shapes, i, b);
    refresh_mass(s.bodies, s.shapes, s.joints, b);
    place_shapes(s.bodies, s.shapes, b);
    wake_body(s.bodies, s.islands, s.events, b);
    add_proxy(s.bodies, s.shapes, s.broad_phase, i);
    if (!s.bodies.is_dynamic(b)) wake_around_shape(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, i);
    return s.shapes.slots.id(i);
}

void World::set_shape(ShapeId id, const Shape& shape) {
    Impl::Change change(*impl_, commands::world_set_shape, id, shape);
    const std::uint32_t i = impl_->index_of(id);
    const State& s = impl_->state;
    require_fit(s, s.shapes.links[i].body, std::int32_t(i), shape, impl_->def_of[i], "World::set_shape geometry");
    change.begin();
    impl_->replace_shape(i, shape, impl_->def_of[i]);
}

void World::set_shape_def(ShapeId id, const ShapeDef& def) {
    Impl::Change change(*impl_, commands::world_set_shape_def, id, def);
    const std::uint32_t i = impl_->index_of(id);
    const State& s = impl_->state;
    require_fit(s, s.shapes.links[i].body, std::int32_t(i), impl_->shape_of[i], def, "World::set_shape_def");
    change.begin();
    impl_->replace_shape(i, impl_->shape_of[i], with_unit_rotation(def));
}

void World::Impl::replace_shape(std::uint32_t i, Shape shape, const ShapeDef& given) {
    State& s = state;
    const std::int32_t b = s.shapes.links[i].body;
    const ShapeDef def(given);
    const ShapeTraits traits = s.shapes.traits[i];
    const Geometry changed = make_geometry(shape, place_of(def));
    const bool stays = is_tested_alike(s.shapes.geometry[i], changed) && traits.is_trigger == def.is_trigger &&
                       kinds_stay(s.shapes, s.contacts, i, changed);
    wake_around_shape(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, i);
    wake_body(s.bodies, s.islands, s.events, b);
    if (!stays) { // its contacts end and are found again at the next step
        s.broad_phase.remove(i);
        update_pairs(s.bodies, s.shapes, s.contacts, s.islands, s.joints, s.broad_phase, s.events);
    }
    define_shape(i, std::move(shape), def);
    refresh_mass(s.bodies, s.shapes, s.joints, b);
    place_shapes(s.bodies, s.shapes, b);
    spend_budget(s.bodies, b); // every pair of the body is tested again
    if (stays) {
        renew_contacts(s.shapes, s.contacts, i);
        renew_proxy(s.bodies, s.shapes, s.broad_phase, i);
        if (!is_same(traits.filter, def.filter)) s.broad_phase.refilter(i);
    } else {
        add_proxy(s.bodies, s.shapes, s.broad_phase, i);
    }
    wake_around_shape(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, i);
}

void World::remove_shape(ShapeId id) {
    Impl::Change change(*impl_, commands::world_remove_shape, id);
    const std::uint32_t i = impl_->index_of(id);
    State& s = impl_->state;
    const std::int32_t b = s.shapes.links[i].body;
    change.begin();
    wake_around_shape(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, i);
    wake_body(s.bodies, s.islands, s.events, b);
    unlink_shape(s.bodies, s.shapes, i);
    retire_shape(s.shapes, s.broad_phase, s.characters, i);
    refresh_mass(s.bodies, s.shapes, s.joints, b);
    place_shapes(s.bodies, s.shapes, b);
    reclaim_slots(s.bodies, s.shapes, s.contacts, s.islands, s.joints, s.broad_phase, s.events);
}

BodyId World::body_of(ShapeId id) const {
    return impl_->state.bodies.id(impl_->state.shapes.links[impl_->index_of(id)].body);
}
const Shape& World::shape(ShapeId id) const { return impl_->shape_of[impl_->index_of(id)]; }
const ShapeDef& World::shape_def(ShapeId id) const { return impl_->def_of[impl_->index_of(id)]; }

Transform World::shape_transform(ShapeId id) const {
    const std::uint32_t i = impl_->index_of(id);
    const State& s = impl_->state;
    // The rotation of the shape as the user defined it: that of a plane's geometry includes the rotation to its normal.
    const BodyMotion& motion = s.bodies.motion[s.shapes.links[i].body];
    const math::DQuat q = motion.q * math::to_double(to_math(impl_->def_of[i].rotation));
    return {to_public(shape_position(s.shapes.poses[i])), to_public(math::to_float(math::normalized(q)))};
}

Bounds World::shape_bounds(ShapeId id) const {
    const DBounds b = cairn::shape_bounds(impl_->state.shapes, impl_->index_of(id));
    return {to_public(b.lo), to_public(b.hi)};
}

void World::set_material(ShapeId id, const Material& material) {
    Impl::Change change(*impl_, commands::world_set_material, id, material);
    const std::uint32_t i = impl_->index_of(id);
    check_material("Material", material);
    State& s = impl_->state;
    change.begin();
    s.shapes.materials[i] = material;
    impl_->def_of[i].material = material;
    wake_body(s.bodies, s.islands, s.events, s.shapes.links[i].body);
    wake_around_shape(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, i);
    for (std::uint32_t c = 0; c < s.contacts.info.size(); ++c)
        if (s.contacts.info[c].in_use && (s.contacts.info[c].shape_a == i || s.contacts.info[c].shape_b == i))
            combine_materials(s.shapes, s.contacts, c);
}

void World::set_filter(ShapeId id, const CollisionFilter& filter) {
    Impl::Change change(*impl_, commands::world_set_filter, id, filter);
    const std::uint32_t i = impl_->index_of(id);
    State& s = impl_->state;
    change.begin();
    s.shapes.traits[i].filter = filter;
    impl_->def_of[i].filter = filter;
    wake_body(s.bodies, s.islands, s.events, s.shapes.links[i].body);
    wake_around_shape(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, i);
    s.broad_phase.refilter(i);
}

void World::set_surface_velocity(ShapeId id, const Vec3& velocity) {
    Impl::Change change(*impl_, commands::world_set_surface_velocity, id, velocity);
    const std::uint32_t i = impl_->index_of(id);
    require_finite("World::set_surface_velocity velocity", velocity);
    State& s = impl_->state;
    if (s.bodies.settings[s.shapes.links[i].body].own_type == BodyType::dynamic)
        require_still_surface("World::set_surface_velocity velocity", velocity);
    change.begin();
    impl_->def_of[i].surface_velocity = velocity;
    s.shapes.traits[i] = make_traits(s.shapes.geometry[i], impl_->def_of[i]);
    wake_around_shape(s.bodies, s.shapes, s.islands, s.broad_phase, s.events, i);
    for (ContactInfo& c : s.contacts.info)
        if (c.in_use && c.shape_b == i) c.is_conveyor = s.shapes.traits[i].has_surface_velocity;
}

} // namespace cairn
