// Data of the solver kernels. Plain data, no functions: kernel translation units of every instruction set include it.
// The members of blocks are listed in block_fields.h, which fails to compile when one is missing.
#pragma once

#include <cstdint>

namespace cairn {

// --- Bodies of one solver batch, gathered in each step, one row per body.

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

// A linear and an angular quantity of a body; each kernel says which.
struct alignas(32) SolverTwist {
    float v[3], pad0;
    float w[3], pad1;
};

// Rows of a batch's body arrays that are not bodies: the first stands for everything that does not move (all zero).
// After the bodies there is one discard row per block, for the writes of lanes that have nothing to write; a single one
// would be written by all threads.
inline constexpr std::uint32_t row_bytes = 32; // size of a row of every body array
inline constexpr std::int32_t fixed_row = 0, first_body_row = 1;

// --- Contacts.

// A pair of shapes that touch or nearly touch, at a stable index. The narrow phase writes it and the solver's prepare
// kernel reads it; the store kernel writes the impulses back, and moves the points with the bodies to the end of the
// step. Body A is always dynamic; body B may be of any kind. World axes; arms are relative to A's center of mass.
// Contacts with one point use the first two cache lines only, unless they need more_points for a rim or an axis.
struct alignas(64) ContactRecord {
    float normal[3];        // unit, from A to B
    float friction;         // combined dynamic coefficient
    float center_offset[3]; // center of mass of A minus that of B, at touch_time
    float restitution;
    float first_point[4]; // arm from A's center of mass, and separation
    float impulses[4];    // normal impulses of the last substep, N s; the warm start

    float friction_impulse[3]; // tangential impulse of the last substep, world axes, on B
    float torsion_impulse;     // about the normal, N m s
    float static_friction;     // combined static coefficient, >= friction
    float rolling_radius;      // combined lever arm of rolling resistance, m
    float torsion_radius;      // combined patch radius for one-point contacts, m
    float approach_speed;      // greatest approach speed of its points when the contact began, m/s, for hit events
    float total_friction[3];   // tangential impulse summed over the last step's substeps, on B
    float first_total;         // normal impulse of the first point, summed likewise
    float radius_a, radius_b;  // radius of a round surface, from its center or axis to the point; 0 for flat surfaces,
                               // corners and edges; or one of the markers below
    std::uint32_t features;    // the lowest byte of each point's feature, the first point's lowest; or no_features; for
                               // two convex shapes without a wide kernel: a ContactMemory
    float touch_time;          // s from the start of the step: the moment whose poses the record describes; 0 after the
                               // step

    float more_points[3][4]; // unused points: {0, 0, 0, 1e30}. One point on a face: the first holds the axis and the
                             // radius of the rim. Two round surfaces: see below. A cone on its side: the last holds the
                             // direction of the contact line times the growth of the radius of curvature along it
    float more_totals[3];
    float more_padding;
};

// Markers in place of a radius, which say how the contact points move over the surfaces: on_face, that they move over a
// face of that body (several points do if the other surface is round); rolls_somehow, as radius_a, that the motion is
// unknown.
inline constexpr float rolls_somehow = -1, on_face = -2;

// Kinds of one-point contacts of two round surfaces, for the solver to follow the normal: both are round about points,
// or A or B is round about an axis. The kind is stored as the separation of the second point, the axis as its position.
// 0: any other contact.
inline constexpr float round_about_points = 1, round_about_axis_of_a = 2, round_about_axis_of_b = 3;
inline bool are_round(const ContactRecord& r) { return r.radius_a > 0 && r.radius_b > 0; }
inline bool is_round_touch(const ContactRecord& r) { return are_round(r) && r.more_points[0][3] > 0; }

// Per-point data of a block. The arms are j_i = r_i x n for A and j_i + c for B, with c = (x_A - x_B) x n.
template <int N> struct PointRows {
    static constexpr int share_count = N * (N - 1);
    // Used by relax only.
    float separation0[N][8], height[N][8]; // separation at the start of the step; r_i . n
    float square_lever[N][8];              // m^2: squared distance of each point from the friction center
    float total_impulse[N][8];
    float slip_rate_slope[3][8]; // 1/s^2: gradient of the normal part of `slip_rate` over the contact points; set where
                                 // the block has moving points
    // Used by solve and relax.
    float arm[N][3][8];          // j_i
    float share[share_count][8]; // K_ji / K_jj, i != j, see share_index; 0 for unused points j
    float effective_mass[N][8];  // 1 / K_ii; 0 for unused points
    float impulse[N][8], separation[N][8];
};
// A single point is the friction center: its arm and height are computed from that.
template <> struct PointRows<1> {
    // Contact points that are followed over a face (rims.h), set where the block has any: the axis of the rim, the arm
    // of its center and its radius, at the start of the step; the arm of the point for the body with the face, at the
    // moment at which the contact was found; the displacement of the point in half a substep; the moment on A that the
    // impulses carried over lack because the point has moved.
    float rim_axis[3][8], rim_middle[3][8], rim_radius[8], face_arm[3][8], rim_lead[3][8], rim_moment[3][8];
    // Two round surfaces (rounds.h) use the same members, in order: the axis of the surface that is round about one,
    // the arms of both centers of curvature at the start of the step, the distance of these centers at which the
    // surfaces touch, the displacement of the point, and the moment.
    float separation0[1][8], total_impulse[1][8];
    float effective_mass[1][8], impulse[1][8], separation[1][8];
};

// A block of 8 contacts with N points each, one per lane. Built by prepare, used by all substeps. In large islands
// blocks are read from the third-level cache: values that can be recomputed are not stored, and the data that solve
// uses is contiguous.
template <int N> struct alignas(64) ContactBlock : PointRows<N> {
    // Byte offsets of the bodies' rows, the same in all body arrays. write_b: the row that B's velocity is written to,
    // its own or the discard row of the block. Lanes without a contact read and write the discard row.
    std::uint32_t a[8], b[8], write_b[8];
    float center[3][8]; // arm of the friction center
    float normal[3][8];
    float d[3][8]; // x_A - x_B at the latest poses
    float mass_a[8], mass_b[8], inertia_a[6][8], inertia_b[6][8];
    float moved_moment[3][8];                 // on B: the moment that the impulses carried over lack because d has
                                              // changed
    std::uint8_t moved;                       // whether the next solve has to apply moved_moment
    std::uint8_t isotropic;                   // all inertia tensors are multiples of 1: only their xx are stored
    std::uint8_t rolls;                       // any rolling resistance
    std::uint8_t bounces;                     // any restitution
    std::uint8_t round;                       // any round surface
    std::uint8_t moving_points;               // lane bits: contact points move within the step
    std::uint8_t rims_a, rims_b;              // lane bits: the point is followed over a face, as a point of A or of B
    std::uint8_t round_pairs, axes_a, axes_b; // lane bits: both surfaces are round; A or B is round about an axis
    std::uint8_t round_arms;                  // of `round_pairs`: a center of curvature is not a center of mass
    std::uint8_t round_pairs_moved;           // of `round_pairs`: `slip_rate` holds an impulse
    std::uint8_t joined;                      // lane bits: a body is jointed; such contacts bounce in an impact
    std::uint8_t in_impact;                   // lane bits: left to the passes of an impact
    std::uint8_t in_impact_once, in_impact_twice; // lane bits: so left once, or twice, in this step
    // Used by relax only.
    alignas(32) float d0[3][8];     // d at the start of the step
    float d_touch[3][8];            // d at the moment at which the contact was found, for which the couplings hold; two
                                    // round surfaces: the current axis
    float found[8];                 // s from the start of the step: the moment at which the contact was found
    float radius_a[8], radius_b[8]; // of round surfaces, see refresh_separations; else 0
    float max_offset_change_square[8]; // m^2: square of the greatest distance of d from d_touch
    float slip_rate[3][8];             // m/s^2: see slip_of_moving_points, for lanes of `moving_points`; for lanes of
                           // round_pairs_moved, N s: the impulse on B that the impulses carried over lack
    float departure[8];  // m/s^2: for lanes of `moving_points`; the points separate by this times the squared time,
                         // as they slide over a face that rotates
    float tangent[3][8]; // the first tangent; the second is this x normal
    float tangent_mass[3][8]; // inverse of the 2x2 tangential K: 11, 12, 22
    float torsion_mass[8], torsion_coupling[2][8];
    float friction[8], static_friction[8], torsion_radius[8];
    float tangent_impulse[2][8], torsion_impulse[8], total_tangent[2][8];
    float rolling_radius[8], rolling_impulse[3][8], restitution[8]; // used where any lane has them
};

// Softness and limits of the contacts of one batch, for a substep of h seconds.
struct ContactSoftness {
    float h, inverse_h;
    float inverse_elapsed; // 1/s: reciprocal of the time from the start of the step to the end of the substep
    float middle;          // s: middle of the substep, from the start of the step
    struct Spring {
        float scale;        // factor on the rigid impulse
        float push_rate;    // 1/s: push-out speed per meter of penetration, before `scale`
        float fastest_push; // m/s: greatest push-out speed, before `scale`
    };
    Spring on_movable, on_immovable; // selected by whether B can move
    float impact_speed;              // m/s: contacts that approach faster are left to the passes of an impact
};

// Impulses of an impact on a block, apart from those that are carried from substep to substep (impact.cpp).
template <int N> struct alignas(64) ContactImpact {
    float impulse[N][8], tangent[2][8];
    std::uint8_t active; // lane bits: contacts that take part
};

// Results of a step for one contact, besides its record.
struct ContactReport {
    float impulse;      // N s: total of its normal impulses; NaN if any impulse is not finite
    float separation;   // m: separation of its deepest point at the start of the step
    float inverse_mass; // 1/kg: sum over both bodies
};

// The contact in each lane of a list of blocks, and the rows of its bodies. A record of -1 is an empty lane (its rows
// are fixed_row).
struct ContactLanes {
    const std::int32_t* record;
    const std::int32_t* row_a;
    const std::int32_t* row_b;
    std::int32_t first_discard; // discard row of the first block; those of the other blocks follow
};

// The body arrays of one batch.
struct SolverBodies {
    SolverVelocity* velocity;
    SolverVelocity* reference; // velocity after external forces, before any constraint of the substep
    SolverVelocity* rounding;  // rounding error of the last sum for `velocity` (integrate.cpp)
    SolverPose* pose;
    const SolverInertia* inertia;
    const SolverTwist* drive;         // what external forces add to the velocity in one substep
    const SolverTwist* damping;       // factors on the velocity for one substep; null: none
    SolverTwist* velocity_correction; // added to the velocity to integrate the pose; null: none
};

struct BounceSettings {
    float h;               // substep, s
    float threshold;       // slower approaches do not bounce, m/s
    float velocity_offset; // lag of the velocity of the discrete path behind the stored one, in units of h a (see
                           // bounce.cpp)
};

// Numbers of blocks that bounced, and of blocks with lanes that are left to the passes of an impact.
struct BounceCount {
    int bounced, in_impact;
};

// Rebounds of the contacts that bounce in an impact, 8 values per point of a block. does_not_arrive marks points that
// do not reach the surface within the substep, or too slowly to bounce.
inline constexpr float does_not_arrive = -1e30f;
struct ReboundTargets {
    float* speed;   // m/s: opening speed after the impact, with what is carried over; or does_not_arrive
    float* arrival; // time of impact, in units of the substep
};

// 8 bodies with unequal moments of inertia, see spin.cpp.
struct alignas(64) SpinBlock {
    std::uint32_t row[8]; // offsets in bytes; lanes without a body: a discard row
    float axes[4][8];     // principal axes in the world at the start of the step, x y z w
    float moments[3][8], inverse_moments[3][8];
    float contact_inertia[6][8];        // the inertia that contacts act on
    float momentum[3][8], free_w[3][8]; // angular momentum and velocity after the substep's free motion, or when the
                                        // inertia was renewed
    float renewed[8];                   // 1: the inertia follows the poses, as joints need it; 0: it is that of the
                                        // start of the step
    std::uint8_t any_renewed;
    std::uint8_t turns; // whether its rows have a drive or a correction
};

// rad/s: the torque-free rotation of slower bodies without joints is not followed within a step. In 1/60 s the axis of
// such a rotation errs by less than 1e-4 of itself, and the error of the pose is below single precision. (On a joint
// the error would show, in the period of a pendulum.)
inline constexpr float calm_speed = 0.004f;

// m/s, rad/s: bodies whose velocities change by less in a pass of an impact have settled.
struct SettledChange {
    float v, w;
};

struct BodyMotion;
struct HalfLimits;

struct SolverKernels {
    // The `blocks` argument of each kernel is an array of ContactBlock<1> or ContactBlock<4>.
    struct ForPoints {
        // `half_step`: half of the step, s; `h`: a substep, s.
        void (*prepare)(void* blocks, int count, const ContactLanes& lanes, const ContactRecord* records,
                        const SolverInertia* inertia, const SolverVelocity* velocity, float half_step, float h);
        void (*warm_start)(const void* blocks, int count, SolverVelocity* velocity);
        // `bounce` changes velocity_correction, which must not be null. `solve` and `relax` return the number of blocks
        // with lanes that they left to the passes of an impact.
        int (*solve)(void* blocks, int count, SolverVelocity* velocity, const ContactSoftness& softness);
        int (*relax)(void* blocks, int count, const SolverBodies& bodies, const ContactSoftness& softness);
        // Recomputes the effective masses and couplings with the current inertia. `lanes`: for each block the bits of
        // its lanes; null: all lanes.
        void (*renew_masses)(void* blocks, const std::uint8_t* lanes, int count, const SolverInertia* inertia);
        // One pass of an impact. `impacts`: an array of ContactImpact, parallel to the blocks; `rebound_speed`: as
        // written by `find_rebounds`; null: nothing bounces.
        void (*impact_pass)(void* blocks, void* impacts, const float* rebound_speed, int count,
                            SolverVelocity* velocity, float inverse_h);
        // Before the first pass: computes the rebound speeds of arriving contacts. Contacts with restitution that do
        // not arrive take no part: they may bounce next, as the balls of a cradle do one after the other.
        void (*find_rebounds)(const void* blocks, void* impacts, const ReboundTargets& aimed, int count,
                              const SolverBodies& bodies, const BounceSettings& settings);
        BounceCount (*bounce)(void* blocks, int count, const SolverBodies& bodies, const BounceSettings& settings);
        // `free_correction`: velocity_correction as it was before the bounces.
        void (*refresh_arms)(void* blocks, int count, const SolverBodies& bodies, const SolverTwist* free_correction,
                             float h);
        // Writes back the impulses, and the contact points at `pose`, the end of the step. Records and reports are
        // indexed by the contact.
        void (*store)(const void* blocks, int count, const ContactLanes& lanes, const SolverPose* pose,
                      ContactRecord* records, ContactReport* reports, float dt);
    } one_point, four_points;

    // The greatest change of the given rows since `last`, in units of `settled`; `last` is set to the current
    // velocities.
    float (*change_since)(const SolverVelocity* velocity, const std::int32_t* rows, int count, SolverVelocity* last,
                          SettledChange settled);

    // At the start of a step: computes the inertia of the bodies from the principal axes and moments.
    void (*begin_spin)(SpinBlock* blocks, int count, SolverInertia* inertia);
    // The torque-free rotation of one substep: sets the angular parts of the rows' drive and correction.
    void (*spin)(SpinBlock* blocks, int count, const SolverBodies& bodies, SolverTwist* drive, SolverTwist* correction,
                 float h, bool first);
    // After the poses of a substep have been integrated: updates the inertia of bodies with joints.
    void (*renew_inertia)(SpinBlock* blocks, int count, const SolverVelocity* velocity, const SolverPose* pose,
                          SolverInertia* inertia);
    // After the last substep: computes the angular velocities from the angular momenta and the final rotations.
    void (*finish_spin)(const SpinBlock* blocks, int count, SolverVelocity* velocity, const SolverPose* pose);

    // Rows begin to end - 1. `first`: the first substep of a step, whose velocities have no constraint part to carry
    // over.
    void (*integrate_velocities)(const SolverBodies& bodies, int begin, int end, bool first);
    void (*integrate_poses)(const SolverBodies& bodies, int begin, int end, float h); // in whole groups of 8 rows

    // At the end of a step: moves 8 `bodies` by the motion of their rows, those among `lanes` (bits) whose motion is
    // finite and below half of all limits. Returns the bits of these; the other bodies are left as they are.
    int (*move_bodies)(const std::int32_t* bodies, int lanes, const SolverVelocity* velocity, const SolverPose* pose,
                       BodyMotion* motion, const HalfLimits& half);
};

} // namespace cairn
