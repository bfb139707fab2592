// Contacts that have nothing to do in a step, and are left out of the solver (docs/decisions/apart.md): their points
// are apart, bear nothing, and cannot meet however their bodies move, or are hit by what is about to hit them.
#include "solver/idle_contacts.h"

#include "bodies/bodies.h"
#include "bodies/integrators.h"
#include "contacts/contact_record.h"
#include "contacts/contact_update.h"
#include "state/joint_links.h"
#include "state/state.h"

#include <algorithm>

namespace cairn {

namespace {

// Of the margin of a contact: as little apart, it may still touch (contacts.cpp).
constexpr float touching_part = 0.25f;
// What bodies at rest may begin to do within the step: twice the way that they fall.
float way_of_fall(const State& s, float dt) {
    const auto& g = s.settings.gravity;
    return dt * dt * math::length(math::Vec3{g.x, g.y, g.z});
}
// Likewise, of the forces that were asked for in this step.
float way_of_forces(const State& s, std::int32_t body, float dt) {
    const BodyForces& f = s.forces[std::size_t(body)];
    const BodyMass& mass = s.mass[std::size_t(body)];
    const math::Vec3 i = mass.inverse_inertia;
    const double speed =
        math::length(f.force) * double(mass.inverse_mass) +
        math::length(f.torque) * double(std::max({i.x, i.y, i.z}) * s.bodies[std::size_t(body)].radius);
    return dt * dt * float(speed);
}
// What is slower pushes its like no farther than there is room for.
float least_push(const State& s, float dt) { return 4 * way_of_fall(s, dt); }
// It is looked for what is pushed only where at least one contact in so many may be left out.
constexpr std::size_t least_share = 32;
// And where no more than one body in so many is fast, and as many pushes or a little more tell all that they move: in
// what comes to rest after a fall, 100 limbs pushed each other 97,000 times, which took longer than the solver.
constexpr std::size_t most_fast = 32, most_pushes = 16;

// What is struck goes on together with what struck it: the speed is that of a plastic hit, and the next is struck by
// the mass of both. True if `other` moves farther by that, or with much more behind it.
bool push(const Mover& by, Mover& other) {
    constexpr float alike = 0.5f, much_more = 4;
    if (!(other.own_mass > 0)) return false;
    const float mass = by.mass + other.own_mass;
    const float reach = mass < heaviest ? by.reach * (by.mass / mass) : by.reach;
    const bool is_driven = reach > alike * other.reach && by.mass > much_more * other.mass;
    if (reach <= other.reach && !is_driven) return false;
    other.reach = std::max(other.reach, reach), other.mass = mass;
    return true;
}

// Follows what moves fast to what it pushes, by contacts that are closed or may be in the step and by joints, and on.
class Pushes {
  public:
    Pushes(State& s, float least) : s_(s), work_(s.narrow.pushes), least_(least) {}

    // False if there are so many that it is not worth knowing.
    bool find() {
        const std::size_t most = s_.narrow.awake.size() / most_pushes;
        list_contacts();
        for (std::size_t k = 0; k < work_.fast.size(); ++k) { // which grows
            if (k >= most) return false;
            const std::int32_t body = work_.fast[k];
            const Mover by = s_.narrow.movers[std::size_t(body)];
            const std::size_t end = work_.first[std::size_t(body) + 1];
            for (std::size_t i = work_.first[std::size_t(body)]; i < end; ++i) {
                const SortedContact& c = s_.solver.unsorted[work_.contacts[i]];
                const std::int32_t other = c.body_a == body ? c.body_b : c.body_a;
                if (c.spare <= by.reach + s_.narrow.movers[std::size_t(other)].reach) push_on(by, other);
            }
            for_each_joint(s_, body, [&](std::uint32_t joint, int side) {
                if (const std::int32_t other = other_body(s_.joints[joint], side); other != none) push_on(by, other);
            });
        }
        return true;
    }

  private:
    // Between bodies that move, by body.
    void list_contacts() {
        std::vector<std::uint32_t>& first = work_.first;
        first.assign(s_.bodies.size() + 2, 0);
        const std::vector<SortedContact>& all = s_.solver.unsorted;
        for (const SortedContact& c : all)
            if (c.body_b != none) ++first[std::size_t(c.body_a) + 2], ++first[std::size_t(c.body_b) + 2];
        for (std::size_t b = 2; b < first.size(); ++b) first[b] += first[b - 1];
        work_.contacts.resize(first.back());
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (all[k].body_b == none) continue;
            work_.contacts[first[std::size_t(all[k].body_a) + 1]++] = std::uint32_t(k);
            work_.contacts[first[std::size_t(all[k].body_b) + 1]++] = std::uint32_t(k);
        }
    }

    void push_on(const Mover& by, std::int32_t other) {
        Mover& mover = s_.narrow.movers[std::size_t(other)];
        if (mover.mass == 0 && s_.is_dynamic(other)) // it has been woken in this pass
            mover.mass = mover.own_mass = s_.mass[std::size_t(other)].mass;
        if (push(by, mover) && mover.reach > least_) work_.fast.push_back(other);
    }

    State& s_;
    PushScratch& work_;
    float least_;
};

float reach_of(const State& s, std::int32_t a, std::int32_t b) {
    return s.narrow.movers[std::size_t(a)].reach + (b == none ? 0 : s.narrow.movers[std::size_t(b)].reach);
}

} // namespace

bool find_fast(State& s, float dt) {
    if (any_field(s)) return false; // what it does to a body depends on where that is
    for (const std::int32_t b : s.pushed) s.narrow.movers[std::size_t(b)].reach += way_of_forces(s, b, dt);
    const float least = least_push(s, dt);
    std::vector<std::int32_t>& fast = s.narrow.pushes.fast;
    fast.clear();
    for (const std::vector<std::int32_t>* bodies : {&s.narrow.awake, &s.kinematics})
        for (const std::int32_t b : *bodies)
            if (s.narrow.movers[std::size_t(b)].reach > least) fast.push_back(b);
    return fast.size() * most_fast <= s.narrow.awake.size();
}

float spare_gap(const State& s, const SortedContact& sorted, float dt) {
    const ContactInfo& c = s.contacts[sorted.id];
    const float needed = std::max(touching_part * c.base_margin, way_of_fall(s, dt));
    return std::max(noted_gap(c) - needed - reach_of(s, sorted.body_a, sorted.body_b), 0.0f);
}

void leave_out_idle(State& s, float dt) {
    std::vector<SortedContact>& contacts = s.solver.unsorted;
    std::vector<std::uint32_t>& idle = s.solver.idle;
    idle.resize(contacts.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        idle[count] = std::uint32_t(k);
        count += contacts[k].spare > 0;
    }
    idle.resize(count);
    if (count * least_share <= contacts.size()) return;
    for (const std::uint32_t k : idle) // to see what has been pushed
        contacts[k].spare += reach_of(s, contacts[k].body_a, contacts[k].body_b);
    if (!s.narrow.pushes.fast.empty() && !Pushes(s, least_push(s, dt)).find()) return;
    for (const std::uint32_t k : idle) {
        SortedContact& c = contacts[k];
        c.is_left_out = c.spare > reach_of(s, c.body_a, c.body_b);
        if (c.is_left_out) s.contacts[c.id].load = 0;
    }
}

} // namespace cairn
