// What the solver kernels work on. Plain data, no functions: kernel translation units of every instruction
// set include it. The members of blocks are listed in block_fields.h, which fails to compile when one is missing.
#pragma once

#include <cstdint>

namespace cairn {

// --- Bodies of one solver batch, gathered anew each step, one row each.

// Linear and angular velocity, world axes.
struct alignas(32) SolverVelocity {
    float v[3], pad0;
    float w[3], pad1;
};

// How far the body has moved since the start of the step: translation of the center of mass, and rotation.
struct alignas(32) SolverPose {
    float dx[3], pad0;
    float dq[4]; // x y z w
};

// Inverse mass and inverse inertia about the center of mass in world axes, as at the start of the step.
struct alignas(32) SolverInertia {
    float inverse_mass;
    float xx, xy, xz, yy, yz, zz;
    float pad;
};

// A linear and an angular quantity per body, of whatever kind the kernel that takes it says.
struct alignas(32) SolverTwist {
    float v[3], pad0;
    float w[3], pad1;
};

// The rows of a batch's body arrays that are not bodies: the first is what does not move (all zero). Behind the bodies
// there is one for each block, its discard row, where lanes write that have nothing to write: one for all would have
// all threads write there.
inline constexpr std::uint32_t row_bytes = 32; // of every body array
inline constexpr std::int32_t fixed_row = 0, first_body_row = 1;

// --- Contacts.

// One touching or nearly touching pair of shapes, at a stable index. Written by the narrow phase, read by
// the solver's prepare kernel; its store kernel writes the impulses back, and moves the points along with the bodies to
// the end of the step. Body A always moves by forces (is dynamic); body B may be anything. World axes; arms are
// relative to A's center of mass. Contacts with one point use the first two cache lines alone.
struct alignas(64) ContactRecord {
    float normal[3];        // unit, from A to B
    float friction;         // combined dynamic coefficient
    float center_offset[3]; // center of mass of A minus that of B, at the touch
    float restitution;
    float first_point[4]; // arm from A's center of mass, and separation
    float impulses[4];    // normal impulses of the last substep, N s; the warm start

    float friction_impulse[3]; // tangential impulse of the last substep, world axes, on B
    float torsion_impulse;     // about the normal, N m s
    float static_friction;     // combined static coefficient, >= friction
    float rolling_radius;      // combined lever arm of rolling resistance, m
    float torsion_radius;      // combined patch radius for one-point contacts, m
    float approach_speed;      // greatest approach speed of its points when it began, for hit events
    float total_friction[3];   // tangential impulse summed over the last step's substeps, on B
    float first_total;         // normal impulse of the first point, likewise
    float radius_a, radius_b;  // of a round surface, from its center or axis to the point; 0 for flat ones, for corners
                               // and edges; of contacts with one point also what is below
    std::uint32_t features;    // the lowest byte of each point's feature, the first point's lowest; or no_features; of
                               // two convex shapes that no wide kernel tests: a ContactMemory
    float touch_time;          // s from the start of the step: when the shapes are where all of this is of; after it, 0

    float more_points[3][4]; // unused: {0, 0, 0, 1e30}; of what touches a face the first is the axis and the radius of
                             // its rim; of a cone on its side the last is the direction of that, times how its radius
                             // of curvature grows along it
    float more_totals[3];
    float more_padding;
};

// How the points of a contact move over the surfaces, in place of a radius of A or B: over a face of that one, or in a
// way that nobody knows, as A's radius. Several points move if what is round touches a face.
inline constexpr float rolls_somehow = -1, on_face = -2;

// Of two round surfaces that touch by one point, in place of the separation of the second: what they are round about,
// for the solver to follow the normal; and in its place the axis, if that is one. Of others 0.
inline constexpr float round_about_points = 1, round_about_axis_of_a = 2, round_about_axis_of_b = 3;
inline bool are_round(const ContactRecord& r) { return r.radius_a > 0 && r.radius_b > 0; }
inline bool is_round_touch(const ContactRecord& r) { return are_round(r) && r.more_points[0][3] > 0; }

// What a block keeps of its points, with the arms j_i = r_i x n for A and j_i + c for B, c = (x_A - x_B) x n.
template <int N> struct PointRows {
    static constexpr int share_count = N * (N - 1);
    // Used by relax only.
    float separation0[N][8], height[N][8]; // separation at the start of the step; r_i . n
    float square_lever[N][8];              // m^2: of each point from the friction center
    float total_impulse[N][8];
    float turning_slope[3][8]; // 1/s^2: how the normal part of `turning` grows with the place; where the block turns
    // And by solve.
    float arm[N][3][8];          // j_i
    float share[share_count][8]; // K_ji / K_jj, i != j, see share_index; 0 for unused points j
    float effective_mass[N][8];  // 1 / K_ii; 0 for unused points
    float impulse[N][8], separation[N][8];
};
// The only point is the friction center: its arm and height are found from that.
template <> struct PointRows<1> {
    // Of what is followed over a face, where the block has any, see rims.h: the axis of its rim, the arm of the middle
    // of that and its radius, at the start of the step; the arm of the point for the body with the face, at the moment
    // that the contact is of; how far the point runs in half a substep; the moment on A of the impulses carried over,
    // as it has run.
    float rim_axis[3][8], rim_middle[3][8], rim_radius[8], face_arm[3][8], rim_lead[3][8], rim_moment[3][8];
    // Of two round surfaces, see rounds.h, in the same places: the axis of that which is round about one, the arms of
    // both centers at the start of the step, how far those are apart where the surfaces touch, how far the point runs,
    // and the moment.
    float separation0[1][8], total_impulse[1][8];
    float effective_mass[1][8], impulse[1][8], separation[1][8];
};

// One block of 8 contacts with N points each, 8 lanes side by side. Built by prepare, used by all substeps. In large
// islands blocks come from the third-level cache: what can be computed is not kept, and what solve uses lies together.
template <int N> struct alignas(64) ContactBlock : PointRows<N> {
    // Rows of the bodies as offsets in bytes, the same in all body arrays; where B's velocity goes: its row, or the
    // discard row of the block. Lanes without a contact read and write that.
    std::uint32_t a[8], b[8], write_b[8];
    float center[3][8]; // arm of the friction center
    float normal[3][8];
    float d[3][8]; // x_A - x_B as of the last poses
    float mass_a[8], mass_b[8], inertia_a[6][8], inertia_b[6][8];
    float moved_moment[3][8];               // on B, of the impulses carried over, as d has changed
    std::uint8_t moved;                     // whether moved_moment holds anything
    std::uint8_t isotropic;                 // all tensors are multiples of 1: only their xx are kept
    std::uint8_t rolls;                     // any rolling resistance
    std::uint8_t bounces;                   // any restitution
    std::uint8_t round;                     // any round surface
    std::uint8_t turns;                     // lanes, as bits, of which points move within the step
    std::uint8_t rims_a, rims_b;            // lanes, as bits, of which the place on A or on B is followed over a face
    std::uint8_t rounds, axes_a, axes_b;    // likewise: of which both are round; of which A or B is so about an axis
    std::uint8_t round_arms;                // of those: of which a center of curvature is not that of mass
    std::uint8_t rounds_moved;              // likewise: which have a push in `turning`
    std::uint8_t joined;                    // lanes, as bits: of bodies that joints hold, which bounce in an impact
    std::uint8_t struck;                    // lanes, as bits, that are left to the passes of an impact
    std::uint8_t struck_once, struck_twice; // likewise, in this step
    // Used by relax only.
    alignas(32) float d0[3][8];     // d at the start of the step
    float d_touch[3][8];            // where the couplings are of: at the moment that the contact is of; of round on
                                    // round, the axis now
    float found[8];                 // s from the start of the step: that moment
    float radius_a[8], radius_b[8]; // of round surfaces, see refresh_separations
    float passing_square[8];        // of how far d may be from there
    float turning[3][8];            // m/s^2: see slip_of_turning, of lanes that turn; of round on round, see
                                    // rounds_moved, what the impulses carried over push more on B
    float sliding[8];               // m/s^2: likewise, how fast the points part as they slide over a face that turns
    float tangent[3][8];            // the second tangent is this x normal
    float tangent_mass[3][8];       // inverse of the 2x2 tangential K: 11, 12, 22
    float torsion_mass[8], torsion_coupling[2][8];
    float friction[8], static_friction[8], torsion_radius[8];
    float tangent_impulse[2][8], torsion_impulse[8], total_tangent[2][8];
    float rolling_radius[8], rolling_impulse[3][8], restitution[8]; // where there is any
};

// Softness and limits of the contacts of one batch, for a substep of h seconds.
struct ContactSoftness {
    float h, inverse_h;
    float inverse_elapsed; // 1/s: of the time from the start of the step to the end of the substep
    float middle;          // s: of the substep, from the start of the step
    struct Spring {
        float scale;        // of the rigid impulse
        float push_rate;    // 1/s: speed at which an overlap is pushed out, before that scale
        float fastest_push; // m/s: likewise
    };
    Spring on_movable, on_immovable; // by what B is
    float impact_speed;              // m/s: faster approaches are left to the passes of an impact
};

// What an impact gives to a block, beside the impulses that are carried from substep to substep (impact.cpp).
template <int N> struct alignas(64) ContactImpact {
    float impulse[N][8], tangent[2][8];
    std::uint8_t active; // lanes, as bits, that take part
};

// What a step has done to one contact, beside its record.
struct ContactReport {
    float impulse;      // N s: the total of its normal impulses; not a number if any impulse is not finite
    float separation;   // m: of its deepest point, at the start of the step
    float inverse_mass; // 1/kg: of both bodies together
};

// Which contact sits in each lane of a list of blocks, and the rows of its bodies. A record of -1 is an empty lane
// (its rows are fixed_row).
struct ContactLanes {
    const std::int32_t* record;
    const std::int32_t* row_a;
    const std::int32_t* row_b;
    std::int32_t first_discard; // discard row of the first block; those of the others follow
};

// The body arrays of one batch.
struct SolverBodies {
    SolverVelocity* velocity;
    SolverVelocity* reference; // velocity after external forces, before any constraint of the substep
    SolverVelocity* rounding;  // what the last rounding of `velocity` has left over
    SolverPose* pose;
    const SolverInertia* inertia;
    const SolverTwist* drive;         // what external forces add to the velocity in one substep
    const SolverTwist* damping;       // factors on the velocity, one substep; null: none
    SolverTwist* velocity_correction; // what to add to the velocity to move the pose by; null: none
};

struct BounceSettings {
    float h;               // substep, s
    float threshold;       // slower approaches do not bounce, m/s
    float velocity_offset; // velocity of the discrete path behind the stored one, in units of h a (see bounce.cpp)
};

// Blocks that bounced, and those that have lanes left to the passes of an impact.
struct BounceCount {
    int bounced, struck;
};

// Of contacts that bounce in an impact, 8 for each point of a block.
inline constexpr float does_not_arrive = -1e30f;
struct AimedSpeeds {
    float* leave; // m/s: how fast it is to leave, with what is carried over; does_not_arrive
    float* meets; // when it arrives, in units of the substep
};

// 8 bodies with unequal moments of inertia, see spin.cpp.
struct alignas(64) SpinBlock {
    std::uint32_t row[8]; // offsets in bytes; lanes without a body: a discard row
    float axes[4][8];     // principal axes in the world at the start of the step, x y z w
    float moments[3][8], inverse_moments[3][8];
    float contact_inertia[6][8];        // what contacts act on
    float momentum[3][8], free_w[3][8]; // after the substep's free motion, or when the inertia was renewed
    float renewed[8];                   // 1: the inertia follows the poses, as joints need it; else it is of the start
    std::uint8_t any_renewed;
    std::uint8_t turns; // its rows have a drive or a correction
};

// rad/s: the free turning of slower bodies that are in no joint is not followed within a step. In 1/60 s the axis of
// such a turn goes astray by less than 1e-4 of itself, and what the pose is off is not seen in single precision.
// (Joints would show it: the period of a pendulum.)
inline constexpr float calm_speed = 0.004f;

// m/s, rad/s: bodies that change by less in a pass of an impact have settled.
struct SettledChange {
    float v, w;
};

struct BodyMotion;
struct HalfLimits;

struct SolverKernels {
    // The blocks argument of each is an array of ContactBlock<1> or ContactBlock<4>.
    struct ForPoints {
        // `half_step`: half of the step, `h`: a substep, s.
        void (*prepare)(void* blocks, int count, const ContactLanes& lanes, const ContactRecord* records,
                        const SolverInertia* inertia, const SolverVelocity* velocity, float half_step, float h);
        void (*warm_start)(const void* blocks, int count, SolverVelocity* velocity);
        // `bounce` changes velocity_correction, which must be there.
        // `solve` and `relax` return the number of blocks with lanes that were struck.
        int (*solve)(void* blocks, int count, SolverVelocity* velocity, const ContactSoftness& softness);
        int (*relax)(void* blocks, int count, const SolverBodies& bodies, const ContactSoftness& softness);
        // One pass of an impact; `impacts`: an array of ContactImpact, beside the blocks.
        // The masses and couplings by the inertia as it is now.
        void (*renew_masses)(void* blocks, int count, const SolverInertia* inertia);
        // `leave`: as `aim` has it, null: none.
        void (*strike)(void* blocks, void* impacts, const float* leave, int count, SolverVelocity* velocity,
                       float inverse_h);
        // Before the first pass: the speeds at which what arrives is to leave. What bounces and does not arrive takes
        // no part: it may bounce next, as the balls of a cradle do one after the other.
        void (*aim)(const void* blocks, void* impacts, const AimedSpeeds& aimed, int count, const SolverBodies& bodies,
                    const BounceSettings& settings);
        BounceCount (*bounce)(void* blocks, int count, const SolverBodies& bodies, const BounceSettings& settings);
        // `free_correction`: what velocity_correction was before the bounces.
        void (*refresh_arms)(void* blocks, int count, const SolverBodies& bodies, const SolverTwist* free_correction,
                             float h);
        // Impulses, and the points as they are at `pose`, the end of the step. Records and reports are indexed by the
        // contact.
        void (*store)(const void* blocks, int count, const ContactLanes& lanes, const SolverPose* pose,
                      ContactRecord* records, ContactReport* reports, float dt);
    } one_point, four_points;

    // The greatest change of some rows since `last`, in units of `settled`; `last` becomes what they are.
    float (*change_since)(const SolverVelocity* velocity, const std::int32_t* rows, int count, SolverVelocity* last,
                          SettledChange settled);

    // At the start of a step: their inertia, from the axes and moments.
    void (*begin_spin)(SpinBlock* blocks, int count, SolverInertia* inertia);
    // The free turning of one substep: drive and correction of the rows, angular parts only.
    void (*spin)(SpinBlock* blocks, int count, const SolverBodies& bodies, SolverTwist* drive, SolverTwist* correction,
                 float h, bool first);
    // After the poses of a substep: the inertia of rows in joints.
    void (*renew_inertia)(SpinBlock* blocks, int count, const SolverVelocity* velocity, const SolverPose* pose,
                          SolverInertia* inertia);
    // After the last substep: the angular velocities that go with the angular momenta and the rotations then.
    void (*finish_spin)(const SpinBlock* blocks, int count, SolverVelocity* velocity, const SolverPose* pose);

    // Rows begin..end. `first`: the first substep of a step, which has no constraint part to carry over.
    void (*integrate_velocities)(const SolverBodies& bodies, int begin, int end, bool first);
    void (*integrate_poses)(const SolverBodies& bodies, int begin, int end, float h); // whole groups of 8 rows

    // At the end of a step, 8 rows: moves `bodies` by what these have moved, of `lanes` (bits) those that are finite
    // and below half of all limits, whose bits it returns. The others are left as they are.
    int (*move_bodies)(const std::int32_t* bodies, int lanes, const SolverVelocity* velocity, const SolverPose* pose,
                       BodyMotion* motion, const HalfLimits& half);
};

} // namespace cairn
