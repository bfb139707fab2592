// Gathers the bodies and contacts of a batch into rows and lanes, and scatters the bodies after solving.
#include "solver/batch_rows.h"

#include "bodies/bodies.h"
#include "bodies/finalize.h"
#include "bodies/free_body.h"
#include "bodies/integrators.h"
#include "bodies/motion_budget.h"
#include "core/cache.h"
#include "core/order.h"
#include "core/room.h"
#include "islands/slenderness.h"
#include "jobs/ordered_list.h"
#include "joints/joint_layout.h"
#include "kernels/kernels.h"
#include "solver/batch_lanes.h"
#include "solver/rank_border.h"
#include "solver/row_motion.h"
#include "state/state.h"
#include "state/substeps.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

namespace cairn {

namespace {

constexpr int rows_per_chunk = 128; // for threads

// Adding 0 removes negative zeros, which sums do not produce. A row is then the same whether a contact added zero to it
// or was skipped because no contact of its block had anything to add.
SolverVelocity to_row(math::Vec3 v, math::Vec3 w) {
    return {{v.x + 0.0f, v.y + 0.0f, v.z + 0.0f}, 0, {w.x + 0.0f, w.y + 0.0f, w.z + 0.0f}, 0};
}

// Bodies per partial sum, whatever the number of threads, so that the result does not depend on it.
constexpr int bodies_per_sum = 256;

void add(MotionSum& sum, const BodyMass& mass, const BodyMotion& motion, float weight, math::DVec3 origin,
         math::DVec3 pull) {
    if (!(mass.inverse_mass > 0)) return;
    add_to_extent(sum.extent, mass, motion, origin, pull);
    const math::DVec3 v = math::to_double(motion.v);
    sum.mass += double(mass.mass);
    sum.weight += double(weight);
    sum.momentum += double(mass.mass) * v;
    sum.energy += double(mass.mass) * math::dot(v, v);
}

void prefetch_mass(const Bodies& bodies, std::int32_t b) {
    prefetch(&bodies.mass[b]), prefetch(&bodies.motion[b].x), prefetch(&bodies.motion[b].v);
    prefetch(&bodies.settings[b]);
}

// Computes the weight, agitation and extent of an island. An island without contacts cannot buckle: its loads are zero
// until it has any.
void weigh(const Bodies& bodies, std::span<const std::int32_t> members, Island& island, bool has_contacts,
           const BodyWeights& weights, std::vector<MotionSum>& sums, ThreadPool* thread_pool) {
    const math::DVec3 origin = bodies.motion[members.front()].x;
    const auto sum = [&](std::span<const std::int32_t> part) {
        MotionSum r;
        for (std::size_t k = 0; k < part.size(); ++k) {
            if (k + bodies_ahead < part.size()) prefetch_mass(bodies, part[k + bodies_ahead]);
            const std::int32_t b = part[k];
            add(r, bodies.mass[b], bodies.motion[b], weights(b), origin, weights.pull(b));
        }
        return r;
    };
    const std::size_t count = members.size();
    MotionSum all;
    if (count <= bodies_per_sum) {
        all = sum(members);
    } else {
        sums.resize(count / bodies_per_sum + 1);
        for_chunks(thread_pool, int(sums.size()), 1, [&](int begin, int end, int) {
            for (auto part = std::size_t(begin); part < std::size_t(end); ++part) {
                const std::size_t first = part * bodies_per_sum;
                sums[part] = sum(members.subspan(first, std::min<std::size_t>(bodies_per_sum, count - first)));
            }
        });
        for (const MotionSum& part : sums) {
            all.mass += part.mass, all.weight += part.weight, all.momentum += part.momentum, all.energy += part.energy;
            add_to_extent(all.extent, part.extent);
        }
    }
    island.weight = float(all.weight);
    if (!(all.mass > 0)) return;
    if (has_contacts) island.min_buckling_penetration = min_buckling_penetration(all.extent);
    island.pull_by_width = pull_by_width(all.extent);
    const math::DVec3 mean = (1 / all.mass) * all.momentum;
    island.agitation = float(std::sqrt(std::max(all.energy / all.mass - math::dot(mean, mean), 0.0)));
}

// For a batch that is cut: keeps the bodies of this rank and the ghosts that its contacts refer to.
void keep_needed_bodies(const RankBorder& border, BatchScratch& scratch) {
    std::erase_if(scratch.touching_bodies, [&](std::int32_t b) { return !is_needed(border, b); });
}

// Numbers rows in the order of body indices, which is that of memory (decisions/cache.md).
void number_rows(BatchScratch& scratch, ThreadPool* thread_pool) {
    sort_distinct(scratch.touching_bodies, scratch.row_marks);
    const int count = int(scratch.touching_bodies.size());
    scratch.row_bodies.assign(std::size_t(first_body_row), none);
    scratch.row_bodies.resize(std::size_t(first_body_row + count));
    for_chunks(thread_pool, count, rows_per_chunk, [&](int begin, int end, int) {
        for (int k = begin; k < end; ++k) {
            const std::int32_t body = scratch.touching_bodies[std::size_t(k)];
            scratch.row_bodies[std::size_t(first_body_row + k)] = body;
            scratch.row_of_body[body] = first_body_row + k;
        }
    });
}

// The tangential velocity of a moving surface. Its normal component is ignored, as the shape itself does not move.
math::Vec3 belt_velocity(const Shapes& shapes, const Contacts& contacts, std::uint32_t contact) {
    const math::Vec3 n = math::to_vec(contacts.records[contact].normal);
    const std::uint32_t shape = contacts.info[contact].shape_b;
    const math::Vec3 u = math::rotate(shape_rotation(shapes.poses[shape]), shapes.traits[shape].surface_velocity);
    return u - math::dot(u, n) * n;
}
void fill_conveyor_rows(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, BatchScratch& scratch) {
    for (const ConveyorRow& conveyor : scratch.conveyor_rows) {
        const BodyMotion& b = bodies.motion[contacts.info[conveyor.contact].body_b];
        const std::size_t row = std::size_t(conveyor.row);
        scratch.velocity[row] = scratch.reference[row] =
            to_row(b.v + belt_velocity(shapes, contacts, conveyor.contact), b.w);
    }
}

// Fills the row of one body; rows without a body stay all zero.
void fill_row(Bodies& bodies, const WorldDef& settings, BatchScratch& scratch, std::size_t row,
              std::uint64_t& clamped_speeds) {
    const std::int32_t b = scratch.row_bodies[row];
    if (b == none) return;
    BodyMotion& motion = bodies.motion[b];
    const bool is_dynamic = bodies.is_dynamic(b); // kinematic bodies may be in other batches as well
    if (is_dynamic && clamp_velocity(settings, motion.v, motion.w))
        clamped_speeds += !scratch.border || is_own(*scratch.border->cut, b);
    scratch.velocity[row] = scratch.reference[row] = to_row(motion.v, motion.w);
    if (!is_dynamic) return;
    const BodyMass& mass = bodies.mass[b];
    const std::uint8_t traits = row_traits(bodies, settings, b);
    SolverInertia inertia{mass.inverse_mass, 0, 0, 0, 0, 0, 0, 0};
    if (!(traits & spins_wide)) { // otherwise the kernel computes it (prepare_free_motion)
        const math::Sym3 i = contact_inverse_inertia(motion, mass);
        inertia = {mass.inverse_mass, i.xx, i.xy, i.xz, i.yy, i.yz, i.zz, 0};
    }
    scratch.inertia[row] = inertia;
    scratch.row_traits[row] = traits; // last, since a byte store may alias anything for the compiler
}

// Rows without a body, and discard rows, which have no traits, keep these values.
void clear_rows(BatchScratch& scratch, std::size_t begin, std::size_t end) {
    const auto clear = [=](auto& rows, std::size_t last, auto value) {
        std::fill(rows.data() + std::min(begin, last), rows.data() + std::min(end, last), value);
    };
    clear(scratch.velocity, end, SolverVelocity{});
    clear(scratch.reference, end, SolverVelocity{});
    clear(scratch.rounding, end, SolverVelocity{});
    clear(scratch.pose, end, SolverPose{{0, 0, 0}, 0, {0, 0, 0, 1}});
    clear(scratch.inertia, end, SolverInertia{});
    clear(scratch.row_traits, scratch.row_traits.size(), std::uint8_t(0));
}

void fill_rows(Bodies& bodies, const Shapes& shapes, const Contacts& contacts, const WorldDef& settings,
               BatchScratch& scratch, ThreadPool* thread_pool) {
    while (scratch.row_bodies.size() % 8 != 0) scratch.row_bodies.push_back(none);
    const std::size_t rows = scratch.row_count();
    const std::size_t all = rows + std::max(scratch.block_count(), rows / 8);
    set_size_anew(scratch.velocity, all);
    set_size_anew(scratch.reference, all);
    set_size_anew(scratch.rounding, all);
    set_size_anew(scratch.pose, all);
    set_size_anew(scratch.inertia, all);
    scratch.row_traits.resize(rows);
    std::atomic<std::uint64_t> clamped_speeds = 0;
    for_chunks(thread_pool, int(all), rows_per_chunk, [&](int begin, int end, int) {
        clear_rows(scratch, std::size_t(begin), std::size_t(end));
        std::uint64_t clamped = 0;
        for (int row = begin; row < std::min(end, int(rows)); ++row) {
            if (const auto ahead = std::size_t(row) + bodies_ahead; ahead < rows && scratch.row_bodies[ahead] != none)
                prefetch_motion(bodies, scratch.row_bodies[ahead]);
            fill_row(bodies, settings, scratch, std::size_t(row), clamped);
        }
        if (clamped > 0) clamped_speeds += clamped;
    });
    scratch.clamped_speeds += clamped_speeds;
    fill_conveyor_rows(bodies, shapes, contacts, scratch);
}

// Limits a displacement to that of the world's greatest speed. Nothing else bounds it within a step: joints that
// contradict each other, or whose bodies were placed far apart, pull without limit.
bool cut_way(const WorldDef& settings, float dt, math::DVec3& dx, math::Quat& dq) {
    const double most = double(settings.max_linear_speed) * double(dt), square = math::dot(dx, dx);
    const float turn = ((dq.x * dq.x + dq.y * dq.y) + dq.z * dq.z) + dq.w * dq.w;
    const bool is_far = square > most * most, is_turn = turn > 0.25f && turn < 4.0f;
    if (is_far) dx = (most / std::sqrt(square)) * dx;
    if (!is_turn) dq = {};
    return is_far || !is_turn;
}

// Moves a body by the displacement of its row. A body whose values are not finite stops where it was; it is counted.
std::uint64_t scatter_body(Bodies& bodies, const WorldDef& settings, const BatchScratch& scratch, std::int32_t b,
                           std::size_t row, float dt) {
    const SolverVelocity& velocity = scratch.velocity[row];
    const SolverPose& pose = scratch.pose[row];
    BodyMotion& motion = bodies.motion[b];
    math::DVec3 dx = math::to_double(math::Vec3{pose.dx[0], pose.dx[1], pose.dx[2]});
    math::Quat dq{pose.dq[0], pose.dq[1], pose.dq[2], pose.dq[3]};
    math::Vec3 v{velocity.v[0], velocity.v[1], velocity.v[2]}, w{velocity.w[0], velocity.w[1], velocity.w[2]};
    const math::DVec3 sum = (dx + math::to_double(v)) + math::to_double(w);
    const double sum_q = ((double(dq.x) + dq.y) + dq.z) + dq.w;
    const bool is_finite = 0 * ((sum.x + sum.y) + (sum.z + sum_q)) == 0,
               was_cut = is_finite && cut_way(settings, dt, dx, dq);
    if (!is_finite || !is_place(motion.x + dx)) {
        motion.v = motion.w = {};
        motion.turned = {};
        spend_separations(bodies, b); // its contacts were stored as if it had moved with its row
        return 1;
    }
    motion.x += dx;
    motion.q = math::normalized(math::to_double(dq) * motion.q);
    motion.turned = dq;
    motion.v_rest = motion.w_rest = {};
    const bool clamped = clamp_velocity(settings, v, w);
    motion.v = v;
    motion.w = w;
    if (was_cut) spend_separations(bodies, b); // for the same reason
    return clamped || was_cut ? 1 : 0;
}

// Prefetches bodies ahead of a place in a list; some entries are none.
void prefetch_ahead(const Bodies& bodies, const Shapes& shapes, const BroadPhase& broad_phase,
                    const std::vector<std::int32_t>& list, std::size_t place) {
    const auto body_at = [&](std::size_t at) { return at < list.size() ? list[at] : none; };
    if (const std::int32_t b = body_at(place + bodies_ahead); b != none) prefetch_body(bodies, b);
    if (const std::int32_t b = body_at(place + bodies_ahead / 2); b != none)
        prefetch_shape_of(bodies, shapes, broad_phase, b);
}

// Clears the traits of ghosts, so that they are not moved here: their owners send the final state.
void leave_out_ghosts(BatchScratch& scratch) {
    for (std::size_t row = first_body_row; row < scratch.row_count(); ++row) {
        const std::int32_t b = scratch.row_bodies[row];
        if (b != none && (scratch.row_traits[row] & is_dynamic_row) && !is_own(*scratch.border->cut, b))
            scratch.row_traits[row] = 0;
    }
}

} // namespace

void gather_bodies(const Bodies& bodies, Islands& islands, const ForceFields& fields, const WorldDef& settings,
                   const SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch,
                   ThreadPool* thread_pool) {
    const BodyWeights weights(bodies, fields, settings);
    scratch.row_of_body.resize(bodies.links.size(), none);
    std::vector<std::int32_t>& members = scratch.members;
    members.clear();
    for (std::int32_t k = 0; k < batch.island_count; ++k) {
        const std::int32_t number = solver.batch_islands[batch.first_island + k];
        Island& island = islands.all[number];
        const std::size_t begin = members.size();
        for (std::int32_t b = island.first_body; b != none; b = bodies.links[b].next_in_island) members.push_back(b);
        weigh(bodies, std::span(members).subspan(begin), island, solver.contacts_of_island[number] > 0, weights,
              scratch.sums, thread_pool);
    }
    const auto list = [&](bool free, std::vector<std::int32_t>& out) {
        list_in_order(thread_pool, int(members.size()), bodies_per_sum, out, scratch.parts,
                      [&](int begin, int end, std::int32_t* next) {
                          for (int k = begin; k < end; ++k) {
                              const BodyLinks& links = bodies.links[members[std::size_t(k)]];
                              if ((links.contact_count + links.joint_count == 0) == free)
                                  *next++ = members[std::size_t(k)];
                          }
                          return next;
                      });
    };
    list(false, scratch.touching_bodies);
    list(true, scratch.free_bodies);
}

namespace {

// Copies the bodies of a batch that is distributed among ranks, which `cut_batches` has gathered already.
bool take_listed_bodies(const Bodies& bodies, const SolverScratch& solver, const IslandBatch& batch,
                        BatchScratch& scratch) {
    const auto number = std::size_t(&batch - solver.batches.data());
    if (solver.cut.owner_of_batch.empty() || solver.cut.owner_of_batch[number] == every_rank) return false;
    const std::span<const std::int32_t> touching = touching_of(solver.cut, number);
    scratch.row_of_body.resize(bodies.links.size(), none);
    scratch.touching_bodies.assign(touching.begin(), touching.end());
    scratch.free_bodies.clear(); // all ranks move the free bodies
    return true;
}

} // namespace

void gather_batch(Bodies& bodies, const Shapes& shapes, const Contacts& contacts, Islands& islands, Joints& joints,
                  const ForceFields& fields, const WorldDef& settings, SolverScratch& solver, const DirectSets& direct,
                  const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool, float h) {
    if (!take_listed_bodies(bodies, solver, batch, scratch))
        gather_bodies(bodies, islands, fields, settings, solver, batch, scratch, thread_pool);
    if (scratch.border) keep_needed_bodies(*scratch.border, scratch);
    scratch.row_bodies.clear();
    if (scratch.touching_bodies.empty() && batch.contact_count + batch.joint_count == 0) return;
    number_rows(scratch, thread_pool);
    fill_lanes(solver, batch, scratch, thread_pool);
    fill_joint_lanes(bodies, joints, solver, direct, batch, scratch, thread_pool, h);
    fill_rows(bodies, shapes, contacts, settings, scratch, thread_pool);
    if (scratch.border) number_border_rows(*scratch.border, scratch);
}

void leave_belts_in_place(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, BatchScratch& scratch,
                          float dt) {
    for (const ConveyorRow& conveyor : scratch.conveyor_rows) {
        const BodyMotion& b = bodies.motion[contacts.info[conveyor.contact].body_b];
        SolverPose& pose = scratch.pose[std::size_t(conveyor.row)];
        const math::Vec3 belt = belt_velocity(shapes, contacts, conveyor.contact);
        const math::Vec3 moved = b.v == math::Vec3{} ? math::Vec3{} : math::to_vec(pose.dx) - dt * belt;
        // The belt counts as moving until the touch time of the contact, as it does for the contact points.
        math::put(pose.dx, moved + contacts.records[conveyor.contact].touch_time * belt);
    }
}

void scatter_batch(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const ForceFields& fields,
                   const WorldDef& settings, SolverScratch& solver, BatchScratch& scratch, ThreadPool* thread_pool,
                   float dt) {
    if (scratch.border) leave_out_ghosts(scratch);
    std::vector<BatchScratch>& threads = solver.at_work;
    const int rows = int(scratch.row_count());
    const HalfLimits half{std::min(0.5f * settings.max_linear_speed * dt, 0.1f * float(farthest_place)),
                          0.5f * settings.max_linear_speed, 0.5f * settings.max_angular_speed};
    for_chunks(thread_pool, rows, rows_per_chunk, [&](int begin, int end, int thread) {
        BatchScratch& own = thread_pool ? threads[thread] : scratch;
        for (int row = begin; row < end; row += 8) {
            const std::int32_t* const group = scratch.row_bodies.data() + row;
            int lanes = 0;
            for (int i = 0; i < 8; ++i) {
                prefetch_ahead(bodies, shapes, broad_phase, scratch.row_bodies, std::size_t(row + i));
                if (group[i] != none) scratch.row_of_body[group[i]] = none;
                lanes |= (scratch.row_traits[row + i] & is_dynamic_row) << i;
            }
            const int moved = kernels().solver.move_bodies(group, lanes, scratch.velocity.data() + row,
                                                           scratch.pose.data() + row, bodies.motion.data(), half);
            for (int i = 0; i < 8; ++i) {
                if ((lanes >> i & 1) == 0) continue;
                if ((moved >> i & 1) == 0)
                    own.clamped_speeds += scatter_body(bodies, settings, scratch, group[i], std::size_t(row + i), dt);
                finalize_body(bodies, shapes, broad_phase, settings, group[i], dt, own.finalized);
            }
        }
    });
    move_free_bodies(bodies, shapes, broad_phase, fields, settings, solver, scratch.free_bodies, scratch, thread_pool,
                     dt);
}

void move_free_bodies(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const ForceFields& fields,
                      const WorldDef& settings, SolverScratch& solver, const std::vector<std::int32_t>& list,
                      BatchScratch& scratch, ThreadPool* thread_pool, float dt) {
    const int substeps = substeps_of(settings, dt);
    for_chunks(thread_pool, int(list.size()), rows_per_chunk, [&](int begin, int end, int thread) {
        BatchScratch& own = thread_pool ? solver.at_work[thread] : scratch;
        for (int k = begin; k < end; ++k) {
            prefetch_ahead(bodies, shapes, broad_phase, list, std::size_t(k));
            const std::int32_t b = list[k];
            own.clamped_speeds += move_free_body(bodies, fields, settings, b, dt, substeps);
            finalize_body(bodies, shapes, broad_phase, settings, b, dt, own.finalized);
        }
    });
}

} // namespace cairn
