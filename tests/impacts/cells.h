// The cells of the table of impacts: each sets up small worlds, shoots, and says what it saw. Pure functions of their
// parameters, for the program (main.cpp) and for tests. Steps of 1/60 s, default settings and no gravity unless said.
// All is judged by where bodies are and how fast, never by contacts.
//
// The cells were themselves judged by steps so short (1/12,000 to 1/8,000,000 s) that nothing goes far in one: then no
// ghost, loss, escape or wrong impact is left of those that only long steps make, and billiards agree to 0.03 degrees.
#pragma once

#include "bodies.h"

namespace cairn_test {

// --- ghosts.cpp: what flies past
struct PassBy {
    Kind kind = Kind::sphere;
    double size = 0.05; // m, of both
    double gap = 0.02;  // m: least distance of the two on the way
    double speed = 10;  // m/s
    double spin = 0;    // rad/s, about a random axis; the gap is then that of the balls around the two
    int shots = 40;
    unsigned seed = 1;
};
struct Ghosts {
    int shots = 0;
    int deflected = 0;     // by more than 0.01 degrees, or changed in speed as much
    double mean_angle = 0; // degrees, of those
    Vec3 first{0, 0, 0};   // m/s: the velocity of the first, along and across
};
// One body flies past another of its kind that stands still.
Ghosts pass_by(const PassBy& cell);
// A ball flies past the edge of a static box; the kind and the spin do not count.
Ghosts pass_edge(const PassBy& cell);

// --- walls.cpp: what flies at something
enum class Target : std::uint8_t { box, plane, mesh, height_field, plate, kinematic, bullet };
inline constexpr Target all_targets[] = {Target::box,   Target::plane,     Target::mesh,  Target::height_field,
                                         Target::plate, Target::kinematic, Target::bullet};
const char* name_of(Target target);
struct Shooting {
    Kind kind = Kind::box;
    Target target = Target::box;
    double size = 0.01;      // m, of the bullet: half the width (bodies.h)
    double speed = 100;      // m/s
    double spin = 0;         // rad/s
    double thickness = 0.01; // m, of box, plate and kinematic wall
    double restitution = 0;
    double steepest = 60;  // degrees: directions are at most so far from the normal
    bool is_turned = true; // false: the bullet begins in the rotation 1
    int shots = 20;
    unsigned seed = 1;
};
struct Lost {
    int shots = 0;
    int through = 0; // the center went through the middle of the wall, or the inner balls of two bullets met
    int core_in = 0; // not through, but at the end of a step the core's inner ball was in the wall
};
Lost shoot(const Shooting& cell);

// --- cores.cpp: the oracle
struct Crowd {
    int bodies = 14;         // of all kinds in turn
    double size = 0.05;      // m
    double width = 1;        // m, inside
    double thickness = 0.01; // m, of the walls
    double speed = 50;       // m/s
    double spin = 20;        // rad/s
    double seconds = 0.5;
    int shots = 10;
    unsigned seed = 1;
};
// Pairs of bodies, counted in every step as core_watch.h says.
struct CrowdSeen {
    int steps = 0;
    int overlapping = 0, passed = 0, deep = 0;
};
CrowdSeen watch_crowd(const Crowd& cell);

// --- chances.cpp: other ways to fall through
struct Chance {         // what each of them needs
    double speed = 100; // m/s, or rad/s
    int shots = 20;
    unsigned seed = 1;
};
// A ball 0.3 m before a wall is struck by another from behind. How many of the struck end behind the wall.
int strike_before_wall(const Chance& cell);
struct Bounced {
    int escaped = 0;
    int miscounted = 0; // not escaped, but not where the right number of bounces would have it
};
// An elastic ball between two walls 1 m apart, for a second.
Bounced bounce_between_walls(const Chance& cell);
struct Room {
    Kind kind = Kind::sphere;
    int bodies = 10;
    double size = 0.05;      // m, of the bodies: half the width (bodies.h)
    double width = 1;        // m, inside
    double thickness = 0.01; // m, of the walls
    double speed = 30;       // m/s
    double restitution = 1;
    double seconds = 2;
    int shots = 5; // rooms
    unsigned seed = 1;
};
// How many bodies of a closed room are outside at the end, mean of the rooms.
double escape_room(const Room& cell);
// Energy of the bodies of a room at the end over that at the start, less 1; the farthest from 0 of the rooms.
double energy_of_room(const Room& cell);
// A force that brings a ball to the speed within the step, 0.3 m above a floor: through.
int push_through_floor(const Chance& cell);
// A paddle of 1 cm whose tip has the speed turns through where balls rest: balls left behind.
int swing_paddle(const Chance& cell);
// A rod of 1 m on a ball joint turns (speed in rad/s) at a pole of 1 cm: past it.
int swing_rod(const Chance& cell);

// --- collisions.cpp: bodies against each other
struct GasCell {
    double speed = 10; // m/s, of every ball, in random directions
    int balls = 40;
    double radius = 0.05; // m
    int shots = 200;
    unsigned seed = 1;
};
struct Changes { // of balls' velocities within one step, against the exact answer
    int right = 0, false_ = 0, missing = 0;
    double worst_error = 0; // of the velocities, over the speed, of all balls
};
Changes step_gas(const GasCell& cell);

struct Oblique {
    double velocity_error = 0; // worst of the shots, over the speed
    double mean_error = 0;
    double energy_error = 0; // likewise, over the energy
};
// Two elastic balls of which one rests, the offset of their lines 0.6 of the sum of the radii.
Oblique hit_obliquely(const Chance& cell);

struct HeadOn {
    int shots = 0;
    int missed = 0; // they fly on as if there had been nothing
};
// Boxes of 2 to 20 cm, randomly turned, fly at each other; each has the speed.
HeadOn meet_head_on(const Chance& cell);

struct Range {
    double least = 0, most = 0;
};
// Two smooth elastic bodies, 20 cm wide, that spin at 10 rad/s meet; energy over that before, less 1.
Range energy_of_meeting(Kind kind, const Chance& cell);
// A smooth elastic body, dropped from 1 m, bounces on the ground under gravity: energy over that of the start, less 1,
// at any step.
struct Bouncing {
    Kind kind = Kind::box;
    double size = 0.5; // m
    double seconds = 60;
    int shots = 10;
    unsigned seed = 1;
};
Range energy_of_bouncing(const Bouncing& cell);

struct BilliardsCell {
    double speed = 10; // m/s, of the cue ball
    bool is_planar = true;
    // Games count of which the exact one, begun with places and velocities off by so much of the radius and of
    // themselves, ends within a tenth of the bar.
    double disturbance = 1e-5;
    int shots = 20; // that count
    unsigned seed = 1;
};
struct BilliardsResult {
    int games = 0, skipped = 0;
    int differ = 0;         // by more than 0.5 degrees, or 0.5 % of the speed
    double worst_angle = 0; // degrees
    double worst_speed = 0; // relative
};
// 16 balls, the first 10 impacts, against validation/billiards.h.
BilliardsResult play_billiards(const BilliardsCell& cell);

// --- rest.cpp: what stands, slides and rolls; all under gravity
double rebound_of_stack(int boxes, double height); // m/s: at which a dropped stack's center of mass rises, at most
// Degrees by which a box whose center of mass is beside its middle (m) has turned after it slid for 14 m.
double turn_of_sliding_box(double offset);
// Two cards of 1 m by 2 cm that lean on each other, so many degrees from the vertical: whether they still do after 5 s.
// `heading`: of both, rad.
bool do_cards_stand(double degrees, double friction, double heading);
double least_friction_of_cards(double degrees, double heading);
double energy_of_disk(double degrees, double seconds);                       // over that of the start, less 1
double slide_on_slope(double friction, double degrees_more, double seconds); // m
struct Apart {
    double speed = 0;  // m/s, the greatest upwards or sideways: what falls is not pushed
    double height = 0; // m, above where they began
};
// On the ground. `half`: of their height. `before`: how many bodies there are already, elsewhere.
Apart made_in_one_place(const Shape& shape, int bodies, double half, int before);
double height_left_of_stack(int cubes, double edge, double seconds); // over that at the start

} // namespace cairn_test
