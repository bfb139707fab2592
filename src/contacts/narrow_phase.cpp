#include "contacts/narrow_phase.h"

#include "bodies/motion_budget.h"
#include "collision/far_apart.h"
#include "contacts/contact_record.h"
#include "contacts/contact_update.h"
#include "contacts/convex_tests.h"
#include "contacts/flight.h"
#include "contacts/internal_edges.h"
#include "contacts/midway.h"
#include "contacts/pairs.h"
#include "contacts/patches.h"
#include "contacts/prefetch.h"
#include "contacts/round_touch.h"
#include "contacts/shared_tests.h"
#include "contacts/touch.h"
#include "core/cache.h"
#include "core/room.h"
#include "jobs/ordered_list.h"
#include "state/substeps.h"

#include <algorithm>
#include <atomic>

namespace cairn {

using math::to_vec;

namespace {

constexpr int pairs_per_chunk = 512; // items per chunk of a parallel loop
constexpr int convex_pairs_per_chunk = 32, groups_per_chunk = 8;

// Takes the result of a pair that does not overlap yet; pairs that may meet in free flight are settled later.
[[gnu::noinline]] std::uint8_t take_gap(const NarrowInput& in, Contacts& contacts, const NarrowScratch& narrow,
                                        std::uint32_t place, const Manifold& m, NarrowBatch& own, float dt) {
    const std::uint32_t id = narrow.candidates[place];
    const ContactInfo& c = contacts.info[id];
    if (stays_apart(in.bodies, in.shapes, c, m, dt)) return take_apart(in.bodies, contacts, id, m);
    if (!may_meet_in_flight(in, contacts, c, m, dt)) return take_test(in, contacts, narrow, id, m, dt);
    own.flights.add(place, &m, 1);
    return may_be_in_free_flight;
}

// Takes the result of a test at the start of the step. It is final unless the pair may meet in free flight.
std::uint8_t take_first_test(const NarrowInput& in, Contacts& contacts, const NarrowScratch& narrow, std::uint32_t id,
                             std::uint32_t place, const Manifold& m, NarrowBatch& own, float dt) {
    const ContactInfo& c = contacts.info[id];
    if (!stays_in_contact(in.bodies, c, m, dt)) return take_gap(in, contacts, narrow, place, m, own, dt);
    keep_separation(in.bodies, contacts, id, 0);
    return take_points(in.bodies, in.shapes, contacts, in.islands, id, m, moment_of_start(in.bodies, in.shapes, c));
}

// Whether points approach so fast that their time of impact is needed: until the middle of the step they come nearer by
// more than the margin, or they are to bounce.
bool meets_before(const NarrowInput& in, const ContactInfo& c, float approach, float time) {
    return approach * time > c.base_margin || (c.bounces && approach > in.settings.restitution_speed);
}

// Whether a test in the middle of the step shows that the shapes stay in contact; if so, its result is final. If the
// normal has turned by more than 90 degrees since the last step, the shapes may have passed through each other.
bool take_midway_test(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, std::uint32_t id,
                      std::uint32_t place, const Manifold& m, float margin, float time, float dt) {
    const ContactInfo& c = contacts.info[id];
    if (m.count == 0) return false;
    if (c.touching) {
        const float along = math::dot(to_vec(m.normal), to_vec(contacts.records[id].normal));
        if ((c.flipped ? -along : along) <= 0) return false;
        if (leaves_face(in.shapes, c, contacts.records[id], m, midway_pose(in.shapes, narrow, c.shape_a, c.body_a),
                        midway_pose(in.shapes, narrow, c.shape_b, c.body_b)))
            return false;
    } else if (least_separation(m) > c.base_margin + (1 - time / dt) * (margin - c.base_margin)) {
        return false; // at the start of the step the separation may exceed the margin
    }
    if (meets_before(in, c, (margin - c.base_margin) / dt, time) &&
        meets_before(in, c, approach_of(in.bodies, in.shapes, c, m), time))
        return false;
    if ((m.points[0][3] > 0 || may_turn_away(in.bodies, c, dt)) &&
        (stays_apart(in.bodies, in.shapes, c, m, dt) || may_meet_in_flight(in, contacts, c, m, dt) ||
         moves_far(in, c, m, dt)))
        return false;
    keep_separation(in.bodies, contacts, id, 0);
    narrow.outcomes[place] = take_points(in.bodies, in.shapes, contacts, in.islands, id, m,
                                         moment_midway(in.bodies, in.shapes, narrow, c, time));
    return true;
}

// Tests pairs of one kind by its wide kernel, at the start of the step or in its middle.
class WideTest {
  public:
    WideTest(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, PairKind kind, NarrowBatch& own,
             float dt)
        : in(in), contacts_(contacts), narrow_(narrow), own_(own), kind_(kind), dt_(dt),
          midway_(midway_time(in.substeps, dt)) {}

    // Tests up to PairBatch::capacity pairs, given by their places among the candidates.
    void run(const std::uint32_t* places, int count) {
        own_.at_start.clear(), own_.midway.clear();
        for (int i = 0; i < count; ++i) {
            if (i + 2 * ahead < count) prefetch(&contacts_.info[narrow_.candidates[places[i + 2 * ahead]]]);
            if (i + ahead < count) prefetch_touching(narrow_.candidates[places[i + ahead]]);
            const std::uint32_t id = narrow_.candidates[places[i]];
            const bool is_midway = is_looked_for_midway(in.bodies, in.shapes, contacts_, narrow_, id, midway_);
            (is_midway ? own_.midway : own_.at_start).push_back(places[i]);
        }
        if (!own_.midway.empty()) test_midway();
        if (!own_.at_start.empty()) test_at_start();
    }

  private:
    static constexpr int ahead = int(contacts_ahead);

    void fill(int i, const ContactInfo& c, std::uint32_t id) {
        PairBatch& batch = own_.pairs;
        const bool keeps_features = kind_ == PairKind::box_box;
        batch.margin[i] = contact_margin(narrow_, c, dt_);
        batch.kept[i] = keeps_features && c.force > 0 ? contacts_.records[id].features : no_features;
    }
    void collide(const ShapePose* poses, int count) {
        PairBatch& batch = own_.pairs;
        const int padded = (count + 7) & ~7;
        for (int i = count; i < padded; ++i) {
            batch.first[i] = batch.first[0], batch.second[i] = batch.second[0];
            batch.margin[i] = batch.margin[0], batch.kept[i] = batch.kept[0];
        }
        wide_kernel(kind_)(poses, batch.first, batch.second, batch.margin, batch.kept, padded, own_.manifolds);
    }
    void prefetch_touching(std::uint32_t id) const {
        const ContactInfo& c = contacts_.info[id];
        for (const std::int32_t body : {c.body_a, c.body_b}) prefetch(&narrow_.motion_ahead[std::size_t(body)]);
        if (c.touching) prefetch_record(contacts_, id);
    }
    void prefetch_midway(std::uint32_t id) const {
        const ContactInfo& c = contacts_.info[id];
        prefetch(&narrow_.midway_poses[c.shape_a]), prefetch(&narrow_.midway_poses[c.shape_b]);
    }
    // Prefetches what the result of a test is written to, and what it is written from.
    void prefetch_for_result(const std::vector<std::uint32_t>& places, int i, int count) const {
        if (i >= count || own_.manifolds[i].count == 0) return;
        const std::uint32_t id = narrow_.candidates[places[std::size_t(i)]];
        const ContactInfo& c = contacts_.info[id];
        prefetch_record(contacts_, id);
        for (const std::int32_t body : {c.body_a, c.body_b}) prefetch(&in.bodies.motion[body]);
        if (may_be_round(kind_))
            for (const std::uint32_t shape : {c.shape_a, c.shape_b}) prefetch(&in.shapes.geometry[shape]);
    }

    // Pairs that have separated by the middle of the step are tested at its start instead.
    void test_midway() {
        const int count = int(own_.midway.size());
        PairBatch& batch = own_.pairs;
        for (int i = 0; i < count; ++i) {
            const std::uint32_t id = narrow_.candidates[own_.midway[std::size_t(i)]];
            const ContactInfo& c = contacts_.info[id];
            if (i + ahead < count) prefetch_midway(narrow_.candidates[own_.midway[std::size_t(i + ahead)]]);
            own_.poses[2 * i + c.flipped] = midway_pose(in.shapes, narrow_, c.shape_a, c.body_a);
            own_.poses[2 * i + 1 - c.flipped] = midway_pose(in.shapes, narrow_, c.shape_b, c.body_b);
            batch.first[i] = std::uint32_t(2 * i), batch.second[i] = std::uint32_t(2 * i + 1);
            fill(i, c, id);
        }
        collide(own_.poses, count);
        for (int i = 0; i < count; ++i) {
            prefetch_for_result(own_.midway, i + ahead, count);
            const std::uint32_t place = own_.midway[std::size_t(i)];
            if (!take_midway_test(in, contacts_, narrow_, narrow_.candidates[place], place, own_.manifolds[i],
                                  own_.pairs.margin[i], midway_, dt_))
                own_.at_start.push_back(place);
        }
    }

    void test_at_start() {
        const int count = int(own_.at_start.size());
        PairBatch& batch = own_.pairs;
        for (int i = 0; i < count; ++i) {
            const std::uint32_t id = narrow_.candidates[own_.at_start[std::size_t(i)]];
            const ContactInfo& c = contacts_.info[id];
            batch.first[i] = c.flipped ? c.shape_b : c.shape_a;
            batch.second[i] = c.flipped ? c.shape_a : c.shape_b;
            fill(i, c, id);
            prefetch(&in.shapes.links[c.shape_a]); // for write_record
        }
        collide(in.shapes.poses.data(), count);
        std::uint8_t* const outcomes = narrow_.outcomes.data();
        for (int i = 0; i < count; ++i) {
            prefetch_for_result(own_.at_start, i + ahead, count);
            const std::uint32_t place = own_.at_start[std::size_t(i)], id = narrow_.candidates[place];
            outcomes[place] = take_first_test(in, contacts_, narrow_, id, place, own_.manifolds[i], own_, dt_);
        }
    }

    const NarrowInput& in;
    Contacts& contacts_;
    NarrowScratch& narrow_;
    NarrowBatch& own_;
    const PairKind kind_;
    const float dt_, midway_;
};

// Tests a pair that has no wide kernel, starting from the normal of the last step.
void test_convex(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, PairKind kind, std::uint32_t place,
                 NarrowBatch& own, float dt) {
    const std::uint32_t id = narrow.candidates[place];
    const ContactInfo& c = contacts.info[id];
    const PosedShape a = posed_shape(in.shapes, c.shape_a), b = posed_shape(in.shapes, c.shape_b);
    const float margin = contact_margin(narrow, c, dt), midway = midway_time(in.substeps, dt);
    const math::Vec3 guess = to_vec(contacts.records[id].normal);
    ContactMemory memory = contacts.records[id].features;
    bool is_settled = false;
    if (kind == PairKind::convex_convex && c.point_count == 0) {
        const float distance = gap_lower_bound(a.geometry, a.pose, b.geometry, b.pose);
        if (distance > margin) {
            narrow.outcomes[place] = take_distance(in.bodies, contacts, id, distance);
            return;
        }
    }
    if (is_looked_for_midway(in.bodies, in.shapes, contacts, narrow, id, midway)) {
        const PosedShape a_then = shape_midway(in.shapes, narrow, c.shape_a, c.body_a),
                         b_then = shape_midway(in.shapes, narrow, c.shape_b, c.body_b);
        Manifold m = test_convex_pair(kind, a_then, b_then, guess, margin, memory);
        if (kind == PairKind::convex_convex && !c.touching) part_points(a_then, b_then, m);
        drop_separated_points(in, c, c.touching != 0, a_then, b_then, dt, m);
        is_settled = take_midway_test(in, contacts, narrow, id, place, m, margin, midway, dt);
    }
    if (!is_settled) {
        Manifold m = test_convex_pair(kind, a, b, guess, margin, memory);
        if (kind == PairKind::convex_convex && !c.touching) part_points(a, b, m);
        drop_separated_points(in, c, c.touching != 0, a, b, dt, m);
        narrow.outcomes[place] = take_first_test(in, contacts, narrow, id, place, m, own, dt);
    }
    if (kind == PairKind::convex_convex) contacts.records[id].features = memory; // kept for separated pairs, too
}

void test_convex_pairs(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, PairKind kind, int begin,
                       int end, NarrowBatch& own, float dt) {
    const std::vector<std::uint32_t>& places = narrow.lists[std::size_t(kind)];
    constexpr int ahead = int(contacts_ahead);
    const int count = int(places.size()); // not `end`: the chunk that begins there is tested next
    const auto contact_at = [&](int i) { return narrow.candidates[places[i]]; };
    for (int i = begin; i < end; ++i) {
        if (i + 2 * ahead < count) prefetch(&contacts.info[contact_at(i + 2 * ahead)]);
        if (i + ahead < count) prefetch_pair(in.bodies, in.shapes, contacts, contact_at(i + ahead));
        test_convex(in, contacts, narrow, kind, places[i], own, dt);
    }
}

// Whether the solver keeps the contact of a pair up to date while its bodies move little: several points of faces, and
// the point of two round surfaces. Balls that bounce are tested in each step all the same, as a test decides whether
// they are in flight: only there are impacts in order of time, as Newton's cradle needs them.
bool is_kept_by_solver(const ContactInfo& c) {
    if (c.point_count == 1 && c.is_round_touch) return !c.bounces;
    return c.point_count > 0 && !c.is_round && (is_group(c) || c.point_count > 1);
}

// Whether go_along changes the record of such a contact.
bool is_kept_apart(const ContactInfo& c) { return !c.touching && is_kept_by_solver(c); }

// Keeps the contact of a pair whose bodies have moved little since its test: the solver has moved its points along.
std::uint8_t go_along(const Bodies& bodies, Contacts& contacts, const Islands& islands, std::uint32_t id) {
    for_each_patch(contacts, id, [&](std::uint32_t contact) {
        ContactInfo& c = contacts.info[contact];
        if (c.touching || !contacts.records.has(contact)) return;
        ContactRecord& r = contacts.records[contact];
        r.approach_speed = approach_speed(bodies, c, r);
    });
    return persisting_outcome(bodies, islands, contacts.info[id]);
}

std::uint8_t before_test(const Bodies& bodies, Contacts& contacts, const Islands& islands, std::uint32_t id) {
    const ContactInfo& c = contacts.info[id];
    const bool rests = !c.b_moves && !is_awake(bodies, islands, c.body_a) && !moves(bodies, c.body_b);
    if (rests && bodies.is_dynamic(c.body_a)) // otherwise it is a trigger and a kinematic body
        return c.point_count > 0 ? skipped : apart;
    if (!is_placed(bodies, c)) {
        // Pairs without points are tested, as points may come near each other on the way, the more so the larger the
        // shapes are. So are other pairs with one point or with round shapes: their points move over both surfaces as
        // they roll and rock.
        if (is_kept_by_solver(c) && is_near(bodies, contacts, id)) return go_along(bodies, contacts, islands, id);
        return std::uint8_t(to_test + int(c.kind));
    }
    if (c.is_trigger) return apart;
    return c.point_count > 0 ? persists : apart;
}

// The same for a one-way shape: A passes through it while it has no points and is not beyond it.
[[gnu::noinline]] std::uint8_t before_one_way_test(const Shapes& shapes, const ContactInfo& c, std::uint8_t outcome) {
    if (c.point_count > 0 || !goes_through(shapes, c)) return outcome;
    return c.touching ? ended : apart;
}

// Lists the pairs that may not stay separated. Most do, which Contacts::answers tells without reading the contact. The
// loop is branch-free, as the branch would be unpredictable.
void list_open_pairs(const Bodies& bodies, const Contacts& contacts, NarrowScratch& narrow, ThreadPool& thread_pool) {
    const std::uint32_t* const candidates = narrow.candidates.data();
    const SeparationBudget* const pairs = contacts.separation_budgets.data();
    const Travel* const ahead = bodies.ahead.data();
    list_in_order(&thread_pool, int(narrow.candidates.size()), pairs_per_chunk, narrow.open, narrow.parts,
                  [=](int begin, int end, std::uint32_t* next) {
                      const auto look_at = [&](int k) {
                          *next = std::uint32_t(k);
                          next += !stays_apart(ahead, pairs[candidates[k]]);
                      };
                      constexpr int early = 2 * int(contacts_ahead);
                      int k = begin;
                      for (; k < end - early; ++k) {
                          prefetch(&pairs[candidates[k + early]]);
                          look_at(k);
                      }
                      for (; k < end; ++k) look_at(k);
                      return next;
                  });
}

// Sorts the open pairs that are to be tested into the lists of their kinds. `counts`: pairs by kind in each chunk.
std::size_t sort_by_kind(NarrowScratch& narrow, std::vector<KindCounts>& counts, ThreadPool& thread_pool) {
    KindCounts all{};
    for (KindCounts& chunk : counts)
        for (std::size_t kind = 0; kind < tested_kinds; ++kind) {
            const std::uint32_t begin = all[kind];
            all[kind] += chunk[kind];
            chunk[kind] = begin;
        }
    std::size_t count = 0;
    for (std::size_t kind = 0; kind < tested_kinds; ++kind) {
        if (narrow.lists[kind].size() != all[kind]) set_size_anew(narrow.lists[kind], all[kind]);
        count += all[kind];
    }
    if (count == 0) return 0;
    thread_pool.for_chunks(int(narrow.open.size()), pairs_per_chunk, [&](int begin, int end, int) {
        KindCounts& next = counts[std::size_t(begin / pairs_per_chunk)];
        for (int i = begin; i < end; ++i) {
            const std::uint32_t place = narrow.open[std::size_t(i)];
            const std::uint8_t outcome = narrow.outcomes[place];
            if (outcome < to_test) continue;
            const auto kind = std::size_t(outcome - to_test);
            narrow.lists[kind][next[kind]++] = place;
        }
    });
    return count;
}

// Lists the pairs that may have moved, by kind, and counts them.
std::size_t list_pairs(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, const Islands& islands,
                       const BroadPhase& broad_phase, NarrowScratch& narrow, ThreadPool& thread_pool) {
    broad_phase.list_contacts(narrow.candidates, narrow.parts, thread_pool);
    list_open_pairs(bodies, contacts, narrow, thread_pool);
    set_size_anew(narrow.outcomes, narrow.candidates.size());
    const int open = int(narrow.open.size());
    narrow.kinds_in_chunk.assign(std::size_t(open / pairs_per_chunk + 1), {});
    std::atomic<bool> any_groups = false;
    thread_pool.for_chunks(open, pairs_per_chunk, [&](int begin, int end, int) {
        // Writes of bytes may alias anything, so without local copies the compiler would reload the pointers after
        // each.
        const std::uint32_t *const places = narrow.open.data(), *const candidates = narrow.candidates.data();
        const ContactInfo* const info = contacts.info.data();
        std::uint8_t* const outcomes = narrow.outcomes.data();
        MotionAhead* const motion_ahead = narrow.motion_ahead.data();
        KindCounts kinds{};
        bool any = false;
        for (int i = begin; i < end; ++i) {
            constexpr int ahead = int(contacts_ahead);
            if (i + 2 * ahead < end) prefetch(&info[candidates[places[i + 2 * ahead]]]);
            if (i + ahead < end)
                if (const std::uint32_t next = candidates[places[i + ahead]]; is_kept_apart(info[next]))
                    prefetch_record(contacts, next);
            const std::uint32_t id = candidates[places[i]];
            any |= is_group(info[id]);
            std::uint8_t outcome = before_test(bodies, contacts, islands, id);
            if (info[id].is_one_way) [[unlikely]]
                outcome = before_one_way_test(shapes, info[id], outcome);
            outcomes[places[i]] = outcome;
            if (outcome < to_test) continue;
            ++kinds[std::size_t(outcome - to_test)];
            for (const std::int32_t b : {info[id].body_a, info[id].body_b})
                __atomic_store_n(&motion_ahead[b].is_tested, true, __ATOMIC_RELAXED);
        }
        narrow.kinds_in_chunk[std::size_t(begin / pairs_per_chunk)] = kinds;
        if (any) any_groups = true;
    });
    narrow.any_groups = any_groups;
    return sort_by_kind(narrow, narrow.kinds_in_chunk, thread_pool);
}

void test_all(const NarrowInput& in, Contacts& contacts, NarrowScratch& narrow, ThreadPool& thread_pool, float dt) {
    const auto for_kind = [&](PairKind kind, int per_chunk, auto&& test) {
        thread_pool.for_chunks(int(narrow.lists[std::size_t(kind)].size()), per_chunk,
                               [&](int begin, int end, int thread) { test(begin, end, narrow.at_work[thread]); });
    };
    for (int kind = 0; kind < wide_kinds; ++kind)
        for_kind(PairKind(kind), PairBatch::capacity, [&](int begin, int end, NarrowBatch& own) {
            WideTest(in, contacts, narrow, PairKind(kind), own, dt)
                .run(narrow.lists[std::size_t(kind)].data() + begin, end - begin);
        });
    for (const PairKind kind : {PairKind::convex_plane, PairKind::convex_rectangle, PairKind::convex_convex})
        for_kind(kind, convex_pairs_per_chunk, [&](int begin, int end, NarrowBatch& own) {
            test_convex_pairs(in, contacts, narrow, kind, begin, end, own, dt);
        });
    begin_groups(contacts, narrow);
    for_kind(PairKind::group, groups_per_chunk,
             [&](int begin, int end, NarrowBatch& own) { test_groups(in, contacts, narrow, begin, end, own, dt); });
    collect_fresh_patches(narrow);
}

// Applies the outcomes of all tests: first of contacts that merely continue, which are the most, then of all others, in
// the order of the pairs.
void follow_up_all(const FollowUpContext& s, ThreadPool& thread_pool, float dt) {
    NarrowScratch& narrow = s.narrow;
    const std::vector<std::uint32_t>& open = narrow.open;
    const std::uint32_t* const candidates = narrow.candidates.data();
    const std::uint8_t* const outcomes = narrow.outcomes.data();
    const bool any_groups = narrow.any_groups;
    const auto goes_on_alone = [&](std::uint32_t k) {
        return outcomes[k] == persists && !(any_groups && is_group(s.contacts.info[candidates[k]]));
    };
    list_in_order(&thread_pool, int(open.size()), pairs_per_chunk, s.solved, narrow.parts,
                  [&](int begin, int end, std::uint32_t* next) {
                      for (int i = begin; i < end; ++i)
                          if (const std::uint32_t k = open[std::size_t(i)]; goes_on_alone(k)) *next++ = candidates[k];
                      return next;
                  });
    list_in_order(&thread_pool, int(open.size()), pairs_per_chunk, narrow.changed, narrow.parts,
                  [&](int begin, int end, std::uint32_t* next) {
                      for (int i = begin; i < end; ++i) {
                          const std::uint32_t k = open[std::size_t(i)];
                          const std::uint8_t outcome = outcomes[k];
                          if (outcome != apart && outcome != may_be_in_free_flight && !goes_on_alone(k)) *next++ = k;
                      }
                      return next;
                  });
    const std::vector<std::uint32_t>& changed = narrow.changed;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        for (int n = 0; n < patches_at_hand && any_groups; ++n)
            if (const std::size_t at = i + patch_ahead(n); at < changed.size())
                prefetch_patch(s.contacts, candidates[changed[at]], n, false);
        const std::uint32_t k = changed[i], id = candidates[k];
        if (is_group(s.contacts.info[id]))
            follow_up_group(s, k, dt);
        else
            follow_up(s, id, outcomes[k], dt);
    }
}

} // namespace

std::size_t update_contacts(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands,
                            const Joints& joints, const ForceFields& fields, const BroadPhase& broad_phase,
                            StepEvents& events, const WorldDef& settings, StepScratch& step, Communicator* ranks,
                            float dt) {
    NarrowScratch& narrow = step.narrow;
    ThreadPool& thread_pool = *step.thread_pool;
    const NarrowInput in{settings, bodies, shapes, islands, joints, fields, substeps_of(settings, dt)};
    const FollowUpContext follow{settings, fields, shapes, bodies,      contacts,
                                 islands,  events, narrow, step.solved, ranks};
    count_motion(bodies, islands, settings, narrow, thread_pool, dt);
    narrow.skipped.clear();
    narrow.lists.resize(tested_kinds);
    narrow.at_work.resize(std::size_t(thread_pool.threads()));
    const std::size_t tested = list_pairs(bodies, shapes, contacts, islands, broad_phase, narrow, thread_pool);
    if (ranks) leave_pairs_to_owners(contacts, narrow);
    pose_midway(bodies, shapes, narrow, thread_pool, midway_time(in.substeps, dt));
    test_all(in, contacts, narrow, thread_pool, dt);
    if (ranks) exchange_tests(in, follow, narrow.shared, dt);
    follow_up_all(follow, thread_pool, dt);
    settle_flights(in, follow, thread_pool, dt);
    drop_internal_edges(in, contacts, narrow, step.solved, thread_pool, ranks, dt);
    color_begun(bodies, contacts, narrow);
    const auto push_solved = [&](std::uint32_t id) {
        for_each_patch(contacts, id, [&](std::uint32_t contact) { step.solved.push_back(contact); });
    };
    // Islands that have just been woken: nothing in them has moved, so their records are still valid.
    for (const std::int32_t key : islands.waking)
        broad_phase.for_each_sleeping_pair(std::uint32_t(key), [&](std::uint32_t, std::uint32_t, std::uint32_t id) {
            if (contacts.info[id].point_count > 0) push_solved(id);
        });
    for (const std::uint32_t id : narrow.skipped)
        if (is_awake(bodies, islands, contacts.info[id].body_a)) push_solved(id);
    return tested;
}

} // namespace cairn
