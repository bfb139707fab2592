#include "impacts/swept_pairs.h"

#include "bodies/motion_budget.h"
#include "collision/one_way.h"
#include "contacts/pairs.h"
#include "contacts/patches.h"
#include "core/cache.h"
#include "state/joint_links.h"

#include <algorithm>
#include <bit>
#include <span>

namespace cairn {

using math::DVec3;

namespace {

constexpr int bodies_per_chunk = 16, pairs_per_chunk = 256; // for threads

// The inner ball of a body, about its center of mass.
Geometry inner_ball(const Bodies& bodies, std::int32_t b) {
    Geometry ball;
    ball.size = {bodies.links[b].inner_radius, bodies.links[b].inner_radius, bodies.links[b].inner_radius};
    ball.bounding_radius = bodies.links[b].inner_radius;
    ball.position = bodies.mass[b].center;
    return ball;
}

bool is_one_part(const Mover& m) { return m.path.until >= 1 && !m.turns_over; }

template <class F> void for_each_shape(const Bodies& bodies, const Shapes& shapes, std::int32_t body, F&& f) {
    for (std::int32_t k = bodies.links[body].first_shape; k != none; k = shapes.links[k].next) f(std::uint32_t(k));
}

} // namespace

SweptPairs::SweptPairs(const SweptInput& input, SweepScratch& scratch, Movers& movers, Assemblies& assemblies)
    : in(input), movers_(movers), assemblies_(assemblies), scratch_(scratch), pairs_(scratch.pairs) {
    pairs_.clear();
    if (scratch_.first_waiting.size() < in.bodies.links.size())
        scratch_.first_waiting.resize(in.bodies.links.size(), none);
    scratch_.redirected.clear();
    scratch_.widest_redirected = 0;
    scratch_.has_swept_bounds = scratch_.has_known = false;
}

SweptPairs::~SweptPairs() {
    for (const SweptPair& pair : pairs_) scratch_.first_waiting[std::size_t(in.shapes.links[pair.other].body)] = none;
}

bool SweptPairs::may_collide(std::uint32_t a, std::uint32_t b) const {
    const std::int32_t body_a = in.shapes.links[a].body, body_b = in.shapes.links[b].body;
    return body_a != body_b && may_meet(in.shapes.traits[a].filter, in.shapes.traits[b].filter) &&
           !joint_forbids_contact(in.bodies, in.joints, body_a, body_b);
}

bool SweptPairs::note_trigger(std::uint32_t a, std::uint32_t b) {
    const bool a_is_trigger = in.shapes.traits[a].is_trigger != 0, b_is_trigger = in.shapes.traits[b].is_trigger != 0;
    bool swapped = false;
    if (a_is_trigger != b_is_trigger && pair_kind(in.shapes.geometry[a], in.shapes.geometry[b], swapped))
        scratch_.near_triggers.push_back({a_is_trigger ? a : b, a_is_trigger ? b : a});
    return a_is_trigger || b_is_trigger;
}

// Joints keep the bodies of an assembly apart, or bring them together, and act in the solver only.
bool SweptPairs::are_joined(std::int32_t a, std::int32_t b) {
    const std::int32_t assembly = assemblies_.of(a);
    return assembly != none && assembly == assemblies_.of(b);
}

// Lists the dynamic bodies that a kinematic body passes, even slow ones, and notes the triggers among the shapes.
void SweptPairs::find_struck(std::int32_t kinematic) {
    const BodyMotion& motion = in.bodies.motion[kinematic];
    const double radius = double(in.bodies.links[kinematic].radius);
    const double moved = uncounted(in.bodies.counted[kinematic], motion, in.bodies.links[kinematic].radius);
    if (!(moved > free_share * double(in.bodies.links[kinematic].inner_radius))) return;
    DBounds bounds;
    const DVec3 from = in.bodies.counted[kinematic].x;
    for (int k = 0; k < 3; ++k)
        bounds.lo[k] = std::min(from[k], motion.x[k]) - radius, bounds.hi[k] = std::max(from[k], motion.x[k]) + radius;
    std::vector<std::uint32_t>& near = scratch_.near; // pairs are added after the query
    near.clear();
    in.broad_phase.query_bounds(bounds, [&](std::uint32_t other) { near.push_back(other); });
    for (const std::uint32_t other : near) {
        const std::int32_t body = in.shapes.links[other].body;
        for_each_shape(in.bodies, in.shapes, kinematic, [&](std::uint32_t shape) {
            if (!may_collide(other, shape) || note_trigger(other, shape) || !in.bodies.is_dynamic(body)) return;
            const std::int32_t mover = add_mover(body);
            if (!is_listed(mover, other, shape)) add(mover, other, shape, known_contact(other, shape));
        });
    }
}

// Whether two bodies have moved so far relative to each other that a core may have passed the other one, and have come
// near each other. The first one is fast.
bool SweptPairs::may_pass(std::int32_t mover, std::int32_t b, const Geometry& other) const {
    if (in.bodies.settings[b].type == BodyType::kinematic) return true;
    const Mover& m = movers_[mover];
    const Mover* const second = movers_.of_body(b) != none ? &movers_[movers_.of_body(b)] : nullptr;
    const RigidPath path_b = second ? second->path : movers_.path_of(b);
    const DVec3 start = path_b.start - m.path.start, displacement = path_b.translation - m.path.translation;
    const double square = math::dot(displacement, displacement), radius_a = double(in.bodies.links[m.body].radius),
                 radius_b = double(in.bodies.links[b].radius);
    const double free =
        free_share * double(std::min(in.bodies.links[m.body].inner_radius, in.bodies.links[b].inner_radius));
    const bool is_whole = is_one_part(m) && (!second || is_one_part(*second)); // else paths end before the step
    const double turned = math::length(m.path.turn) * radius_a + math::length(path_b.turn) * radius_b;
    if (is_whole && std::sqrt(square) + turned <= free) return false;
    if (other.type == ShapeType::plane || is_strip(other)) return true; // unbounded
    // Least distance along the straight relative path.
    const double time = square > 0 ? std::clamp(-math::dot(start, displacement) / square, 0.0, 1.0) : 0;
    const DVec3 nearest = start + time * displacement;
    return math::dot(nearest, nearest) <= (radius_a + radius_b) * (radius_a + radius_b);
}

void SweptPairs::link(std::int32_t k, std::int32_t mover) {
    SweptPair& pair = (*this)[k];
    (pair.first == mover ? pair.next_of_first : pair.next_of_second) = movers_[mover].first_pair;
    movers_[mover].first_pair = k;
}

bool SweptPairs::is_listed(std::int32_t mover, std::uint32_t shape, std::uint32_t other) {
    bool found = false;
    for_each_of(mover, [&](std::int32_t k) {
        const SweptPair& pair = (*this)[k];
        found |= (pair.shape == shape && pair.other == other) || (pair.shape == other && pair.other == shape);
    });
    return found;
}

// The search for a meeting starts along the normal of the contact.
void SweptPairs::set_axis(SweptPair& pair, math::Vec3 normal) const {
    const DVec3 n = math::to_double(normal);
    pair.known.axis = in.contacts.info[std::size_t(pair.contact)].shape_a == pair.shape ? n : -n;
}

// On several ranks: gets the normals for the pairs that were added last from the owners of their contacts.
void SweptPairs::ask_for_axes() {
    if (without_axis_.empty()) return;
    std::vector<ContactNormal> normals;
    for (const std::int32_t k : without_axis_) normals.push_back({std::uint32_t((*this)[k].contact), {}});
    find_normals(in.contacts, normals, in.ranks);
    for (std::size_t i = 0; i < normals.size(); ++i) set_axis((*this)[without_axis_[i]], normals[i].normal);
    without_axis_.clear();
}

// Adds a pair; its order does not depend on which of two movers was visited first.
void SweptPairs::add(std::int32_t mover, std::uint32_t shape, std::uint32_t other, std::int32_t contact) {
    SweptPair pair{mover, movers_.of_body(in.shapes.links[other].body), shape, other, contact};
    bool has_axis = false;
    if (contact != none) {
        const ContactInfo& c = in.contacts.info[contact];
        for_each_patch(in.contacts, std::uint32_t(contact),
                       [&](std::uint32_t patch) { pair.is_known |= in.contacts.info[patch].point_count > 0; });
        has_axis = c.point_count > 0;
    }
    if (pair.second != none && other < shape) {
        std::swap(pair.first, pair.second), std::swap(pair.shape, pair.other);
        pair.known.axis = -pair.known.axis;
    }
    const std::int32_t k = count();
    if (has_axis && in.ranks)
        without_axis_.push_back(k);
    else if (has_axis)
        set_axis(pair, math::to_vec(in.contacts.records[std::size_t(contact)].normal));
    pairs_.push_back(pair);
    link(k, pair.first);
    if (pair.second != none) return link(k, pair.second);
    std::int32_t& waiting = scratch_.first_waiting[std::size_t(in.shapes.links[other].body)];
    pairs_[std::size_t(k)].next_of_second = waiting;
    waiting = k;
}

std::int32_t SweptPairs::add_mover(std::int32_t body) {
    const std::int32_t mover = movers_.add(body);
    std::int32_t& waiting = scratch_.first_waiting[std::size_t(body)];
    while (waiting != none) {
        const std::int32_t k = waiting;
        SweptPair& pair = (*this)[k];
        waiting = pair.next_of_second;
        pair.second = mover;
        pair.known.slack = 0; // its path may be another one than without impacts
        link(k, mover);
    }
    return mover;
}

void SweptPairs::find() {
    for (const std::uint32_t id : in.narrow.in_flight) {
        const ContactInfo& c = in.contacts.info[id];
        add(movers_.of_body(c.body_a), c.shape_a, c.shape_b, std::int32_t(id));
        pairs_.back().flies = true;
    }
    for (const std::int32_t b : in.bodies.kinematics) find_struck(b);
    if (in.fast.empty()) return ask_for_axes();
    list_passing();
    for (const PassingPair& pair : scratch_.passing) {
        if (note_trigger(pair.shape, pair.other)) continue;
        if (are_joined(movers_[pair.mover].body, in.shapes.links[pair.other].body)) continue;
        if (!is_listed(pair.mover, pair.shape, pair.other))
            add(pair.mover, pair.shape, pair.other, std::int32_t(pair.contact));
    }
    find_near_strayed();
    ask_for_axes();
}

// Lists the pairs of the narrow phase in which a fast body may pass the other one.
void SweptPairs::list_passing() {
    const auto write = [&](int begin, int end, PassingPair* next) {
        for (int i = begin; i < end; ++i) {
            constexpr int ahead = 2 * int(contacts_ahead);
            if (i + ahead < end)
                prefetch(&in.contacts.separation_budgets[in.narrow.candidates[in.narrow.open[std::size_t(i + ahead)]]]);
            const std::uint32_t id = in.narrow.candidates[in.narrow.open[std::size_t(i)]];
            const SeparationBudget& answer = in.contacts.separation_budgets[id];
            const std::int32_t a = movers_.of_body(answer.body_a), b = movers_.of_body(answer.body_b);
            const bool a_is_fast = a != none && movers_[a].is_fast, b_is_fast = b != none && movers_[b].is_fast;
            if (!a_is_fast && !b_is_fast) continue;
            const ContactInfo& c = in.contacts.info[id];
            const std::uint32_t shape = a_is_fast ? c.shape_a : c.shape_b, other = a_is_fast ? c.shape_b : c.shape_a;
            const std::int32_t mover = a_is_fast ? a : b;
            if (may_pass(mover, in.shapes.links[other].body, in.shapes.geometry[other]))
                *next++ = {mover, shape, other, id};
        }
        return next;
    };
    list_in_order(&in.thread_pool, int(in.narrow.open.size()), pairs_per_chunk, scratch_.passing, scratch_.parts,
                  write);
}

// Chunks search independently; their results are then concatenated in a fixed order, so that they do not depend on the
// number of threads.
void SweptPairs::find_near_strayed() {
    list_swept_bounds();
    const int count = int(in.strayed.size());
    std::vector<std::vector<NearShape>>& found = scratch_.near_in_chunk;
    found.resize(std::max(found.size(), std::size_t(count / bodies_per_chunk + 1)));
    in.thread_pool.for_chunks(count, bodies_per_chunk, [&](int begin, int end, int) {
        std::vector<NearShape>& own = found[std::size_t(begin / bodies_per_chunk)];
        own.clear();
        for (int k = begin; k < end; ++k) {
            const std::int32_t mover = movers_.of_body(in.strayed[std::size_t(k)]);
            for_each_near(mover, movers_.swept_bounds(movers_[mover], 0), [&](std::uint32_t other) {
                own.push_back({mover, other});
            });
        }
    });
    std::int32_t last = none;
    for (int begin = 0; begin < count; begin += bodies_per_chunk)
        for (const NearShape& near : found[std::size_t(begin / bodies_per_chunk)]) {
            if (near.mover != last) list_pairs_of(near.mover);
            last = near.mover;
            add_near(near.mover, near.shape);
        }
}

// The contact by which the solver has moved two shapes' bodies, or none.
std::int32_t SweptPairs::known_contact(std::uint32_t a, std::uint32_t b) {
    if (!scratch_.has_known) list_known();
    const auto contact_of = [&](std::uint32_t first, std::uint32_t second) {
        for (std::int32_t k = scratch_.first_known[in.shapes.links[first].body]; k != none;
             k = scratch_.known[k].next) {
            const ContactInfo& c = in.contacts.info[scratch_.known[k].contact];
            if (c.shape_a == first && c.shape_b == second)
                return c.related != none ? c.related : std::int32_t(scratch_.known[k].contact); // of a patch: its group
        }
        return none;
    };
    const std::int32_t contact = contact_of(a, b);
    return contact != none ? contact : contact_of(b, a);
}

void SweptPairs::list_known() {
    scratch_.has_known = true;
    scratch_.first_known.assign(in.bodies.links.size(), none);
    scratch_.known.clear();
    for (const SortedContact& c : in.solved) {
        std::int32_t& first = scratch_.first_known[std::size_t(c.body_a)];
        scratch_.known.push_back({c.id, first});
        first = std::int32_t(scratch_.known.size()) - 1;
    }
}

void SweptPairs::list_swept_bounds() {
    if (scratch_.has_swept_bounds) return;
    scratch_.has_swept_bounds = true;
    scratch_.swept_bounds.clear();
    scratch_.strayed.clear();
    scratch_.widest_strayed = 0;
    for (std::int32_t i = 0; i < movers_.count(); ++i) {
        const DBounds bounds = movers_.swept_bounds(movers_[i], 0);
        scratch_.swept_bounds.push_back(bounds);
        if (!movers_[i].has_strayed || movers_[i].is_redirected) continue;
        scratch_.strayed.push_back({bounds.lo.x, i, bounds});
        scratch_.widest_strayed = std::max(scratch_.widest_strayed, bounds.hi.x - bounds.lo.x);
    }
    std::sort(scratch_.strayed.begin(), scratch_.strayed.end());
}

namespace {

// Calls f(path) for the entries, sorted by x, whose ranges along x may overlap the bounds; no range exceeds `widest`.
template <class Run, class F> void for_each_beside(const Run& run, double widest, const DBounds& bounds, F&& f) {
    const auto begins_before = [](const SweptBounds& w, double x) { return w.begin < x; };
    auto next = std::lower_bound(run.begin(), run.end(), bounds.lo.x - widest, begins_before);
    for (; next != run.end() && next->begin <= bounds.hi.x; ++next) f(*next);
}

} // namespace

// Calls f(shape) for the shapes of all other bodies near the bounds. Bodies that have neither strayed nor been
// redirected are where the broad phase has them.
template <class F> void SweptPairs::for_each_near(std::int32_t mover, const DBounds& bounds, F&& f) const {
    in.broad_phase.query_bounds(bounds, [&](std::uint32_t other) {
        const std::int32_t i = movers_.of_body(in.shapes.links[other].body);
        if (i == mover) return;
        if (i != none) {
            if (movers_[i].has_strayed || movers_[i].is_redirected) return;
            const bool is_listed = std::size_t(i) < scratch_.swept_bounds.size(); // not movers added since then
            if (is_listed && !meet(bounds, scratch_.swept_bounds[std::size_t(i)])) return;
        }
        f(other);
    });
    const auto visit = [&](const SweptBounds& swept) {
        if (swept.mover != mover && meet(bounds, swept.bounds) && swept.search == movers_[swept.mover].search)
            for_each_shape(in.bodies, in.shapes, movers_[swept.mover].body, f);
    };
    for_each_beside(scratch_.strayed, scratch_.widest_strayed, bounds, [&](const SweptBounds& swept) {
        if (!movers_[swept.mover].is_redirected) visit(swept);
    });
    for (std::span<const SweptBounds> left = scratch_.redirected; !left.empty();) {
        const std::size_t size = std::bit_floor(left.size());
        for_each_beside(left.first(size), scratch_.widest_redirected, bounds, visit);
        left = left.subspan(size);
    }
}

// Merges runs of equal length, so that n insertions take n log^2 n operations, and a query log^2 n.
void SweptPairs::note_swept_bounds(const SweptBounds& swept) {
    std::vector<SweptBounds>& redirected = scratch_.redirected;
    redirected.push_back(swept);
    const std::size_t last_run = redirected.size() & (~redirected.size() + 1); // the lowest digit of 1
    std::sort(redirected.end() - std::ptrdiff_t(last_run), redirected.end());
    scratch_.widest_redirected = std::max(scratch_.widest_redirected, swept.bounds.hi.x - swept.bounds.lo.x);
}

void SweptPairs::find_near(std::int32_t mover, double from) {
    list_swept_bounds();
    Mover& m = movers_[mover];
    m.is_redirected = true;
    const DBounds needed = movers_.swept_bounds(m, from);
    if (m.search > 0 && contains(m.searched, needed)) return;
    const DBounds bounds = grown(needed, double(in.bodies.links[m.body].inner_radius));
    m.searched = bounds, ++m.search;
    std::vector<std::uint32_t>& near = scratch_.near; // pairs are added after the query
    near.clear();
    for_each_near(mover, bounds, [&](std::uint32_t other) { near.push_back(other); });
    list_pairs_of(mover);
    for (const std::uint32_t other : near) add_near(mover, other);
    note_swept_bounds({bounds.lo.x, mover, bounds, movers_[mover].search});
    ask_for_axes();
}

namespace {

std::uint64_t key_of(std::uint32_t shape, std::uint32_t other) { return std::uint64_t(shape) << 32 | other; }

} // namespace

void SweptPairs::list_pairs_of(std::int32_t mover) {
    std::vector<std::uint64_t>& listed = scratch_.listed;
    listed.clear();
    for_each_of(mover, [&](std::int32_t k) {
        const SweptPair& pair = (*this)[k];
        listed.push_back(pair.first == mover ? key_of(pair.shape, pair.other) : key_of(pair.other, pair.shape));
    });
    std::sort(listed.begin(), listed.end());
}

// Adds the pairs with a near shape that are not listed yet; call list_pairs_of before.
void SweptPairs::add_near(std::int32_t mover, std::uint32_t other) {
    const std::vector<std::uint64_t>& listed = scratch_.listed;
    const std::int32_t body = movers_[mover].body;
    for_each_shape(in.bodies, in.shapes, body, [&](std::uint32_t shape) {
        if (std::binary_search(listed.begin(), listed.end(), key_of(shape, other))) return;
        if (!may_collide(shape, other) || note_trigger(shape, other)) return;
        if (are_joined(body, in.shapes.links[other].body)) return;
        add(mover, shape, other, known_contact(shape, other));
    });
}

// Whether the bounding balls of the two bodies stay apart while their centers of mass move straight: then they do so
// along the direction between their nearest positions. The test is cheap, and holds for a third of all pairs.
bool SweptPairs::stay_far_apart(SweptPair& pair, const RigidPath& a, const RigidPath& b, double from) const {
    const Geometry& other = in.shapes.geometry[pair.other];
    if (other.type == ShapeType::plane || is_strip(other)) return false; // unbounded
    const double end = std::min(a.until, b.until);
    const DVec3 start = b.start - a.start, speed = b.translation - a.translation;
    const double square = math::dot(speed, speed);
    const double time = square > 0 ? std::clamp(-math::dot(start, speed) / square, from, std::max(from, end)) : from;
    const DVec3 nearest = start + time * speed;
    const double reach = double(in.bodies.links[in.shapes.links[pair.shape].body].radius) +
                         double(in.bodies.links[in.shapes.links[pair.other].body].radius);
    const double apart = math::dot(nearest, nearest);
    if (!(apart > reach * reach)) return false;
    const DVec3 n = (1 / std::sqrt(apart)) * nearest;
    pair.known = {n, std::max(math::dot(start + end * speed, n) - reach, 0.0)};
    return true;
}

double SweptPairs::time_of(SweptPair& pair, double from) const {
    pair.known.slack = 0;
    const Mover& first = movers_[pair.first];
    const auto swept = [&](std::uint32_t shape, const Geometry& g, const RigidPath& path, double until) {
        const std::int32_t body = in.shapes.links[shape].body;
        return SweptShape{g, in.shapes.data[shape], math::to_double(g.position - in.bodies.mass[body].center), path,
                          until};
    };
    // Relative to the start of the first path, for precision far from the origin.
    const DVec3 origin = first.path.start;
    const auto seen = [&](RigidPath p) {
        p.start = p.start - origin;
        return p;
    };
    const RigidPath path_a = seen(first.path);
    const Mover* const second = pair.second != none ? &movers_[pair.second] : nullptr;
    const RigidPath path_b = seen(second ? second->path : movers_.path_of(in.shapes.links[pair.other].body));
    const double until_b = second ? second->until : 1;
    if (first.until >= 1 && until_b >= 1 && stay_far_apart(pair, path_a, path_b, from)) return never;
    const bool turns = first.turns_over || (second && second->turns_over);
    Geometry ball_a, ball_b;
    if (first.turns_over) ball_a = inner_ball(in.bodies, first.body);
    if (second && second->turns_over) ball_b = inner_ball(in.bodies, second->body);
    const SweptShape a =
        swept(pair.shape, first.turns_over ? ball_a : in.shapes.geometry[pair.shape], path_a, first.until);
    const SweptShape b =
        swept(pair.other, second && second->turns_over ? ball_b : in.shapes.geometry[pair.other], path_b, until_b);
    const auto lets_through = [&](const SweptShape& shape, const SweptShape& other, std::uint32_t number) {
        const ShapeTraits& traits = in.shapes.traits[number];
        return traits.is_one_way && !begins_beyond(shape, other, traits.one_way);
    };
    if (!pair.is_known && !pair.touches && (lets_through(a, b, pair.other) || lets_through(b, a, pair.shape)))
        return never;
    // A body held by a contact is pressed in slightly, and would catch at the edges of adjacent shapes. (A pair in
    // flight may have a body that has come into contact with another one in this step.)
    const bool catches = !pair.flies && !first.is_free && !(second && in.bodies.is_dynamic(second->body));
    const bool gyrates = first.gyrates || (second && second->gyrates);
    // A body that turned over moves freely from its first pose, whatever contacts the solver had.
    const bool is_held = pair.is_known && !first.is_free && !(second && second->is_free);
    const Held by = gyrates ? Held::by_nothing : Held::perhaps;
    const Held held = !is_held ? by : pair.touches ? Held::by_struck_contact : Held::by_contact;
    if ((pair.touches || pair.is_known) && !turns) return time_of_sinking(a, b, held, from, pair.known);
    if (turns || catches) return core_time_of_impact(a, b, false, from, pair.known);
    return time_of_impact(a, b, held, from, pair.known);
}

} // namespace cairn
