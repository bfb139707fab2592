// The cells of the table of impacts: each sets up small worlds, shoots bodies, and returns measurements. They are pure
// functions of their parameters, for the program (main.cpp) and for tests. Steps of 1/60 s, default settings and no
// gravity unless stated otherwise. Results are judged by positions and velocities of bodies, never by contacts.
//
// The cells were validated with steps so short (1/12,000 to 1/8,000,000 s) that nothing moves far in one. Then no ghost
// collision, loss, escape or wrong impact due to long steps remains, and billiards agree to 0.03 degrees.
#pragma once

#include "bodies.h"

namespace cairn_test {

// --- ghosts.cpp: bodies that pass others
struct PassBy {
    Kind kind = Kind::sphere;
    double size = 0.05; // m, of both bodies
    double gap = 0.02;  // m, least distance of the two on the path
    double speed = 10;  // m/s
    double spin = 0;    // rad/s, about a random axis; `gap` is then that of the bounding spheres
    int shots = 40;
    unsigned seed = 1;
};
struct Ghosts {
    int shots = 0;
    int deflected = 0;     // by more than 0.01 degrees, or the equivalent change of speed
    double mean_angle = 0; // degrees, of the deflected ones
    Vec3 first{0, 0, 0};   // m/s, velocity of the first one deflected, along and across its path
};
// A body passes another of its kind that is at rest.
Ghosts pass_by(const PassBy& cell);
// A ball passes the edge of a static box; `kind` and `spin` are not used.
Ghosts pass_edge(const PassBy& cell);

// --- walls.cpp: bodies that hit a target
enum class Target : std::uint8_t { box, plane, mesh, height_field, plate, kinematic, bullet };
inline constexpr Target all_targets[] = {Target::box,   Target::plane,     Target::mesh,  Target::height_field,
                                         Target::plate, Target::kinematic, Target::bullet};
const char* name_of(Target target);
struct Shooting {
    Kind kind = Kind::box;
    Target target = Target::box;
    double size = 0.01;      // m, of the bullet: half its width (bodies.h)
    double speed = 100;      // m/s
    double spin = 0;         // rad/s
    double thickness = 0.01; // m, of box, plate and kinematic wall
    double restitution = 0;
    double steepest = 60;  // degrees, greatest angle of the directions to the normal
    bool is_turned = true; // false: the bullet starts with the identity rotation
    int shots = 20;
    unsigned seed = 1;
};
struct Lost {
    int shots = 0;
    int through = 0; // the center passed the middle of the wall, or the inscribed balls of two bullets met
    int core_in = 0; // not through, but at the end of a step the inscribed ball of the core was in the wall
};
Lost shoot(const Shooting& cell);

// --- cores.cpp: checked by the oracle
struct Crowd {
    int bodies = 14;         // of all kinds in turn
    double size = 0.05;      // m
    double width = 1;        // m, inner width
    double thickness = 0.01; // m, of the walls
    double speed = 50;       // m/s
    double spin = 20;        // rad/s
    double seconds = 0.5;
    int shots = 10;
    unsigned seed = 1;
};
// Counts of pairs of bodies over all steps, as defined in core_watch.h.
struct CrowdSeen {
    int steps = 0;
    int overlapping = 0, passed = 0, deep = 0;
};
CrowdSeen watch_crowd(const Crowd& cell);

// --- chances.cpp: other ways to tunnel
struct Chance {         // parameters of these cells
    double speed = 100; // m/s, or rad/s
    int shots = 20;
    unsigned seed = 1;
};
// A ball 0.3 m in front of a wall is hit by another from behind. The number of hit balls that end behind the wall.
int strike_before_wall(const Chance& cell);
struct Bounced {
    int escaped = 0;
    int miscounted = 0; // not escaped, but not where the right number of bounces would take it
};
// An elastic ball between two walls at a distance of 1 m, for a second.
Bounced bounce_between_walls(const Chance& cell);
struct Room {
    Kind kind = Kind::sphere;
    int bodies = 10;
    double size = 0.05;      // m, of the bodies: half their width (bodies.h)
    double width = 1;        // m, inner width
    double thickness = 0.01; // m, of the walls
    double speed = 30;       // m/s
    double restitution = 1;
    double seconds = 2;
    int shots = 5; // number of rooms
    unsigned seed = 1;
};
// The number of bodies of a closed room that are outside at the end, mean of all rooms.
double escape_room(const Room& cell);
// The final energy of the bodies of a room relative to the initial energy, minus 1; of all rooms the value farthest
// from 0.
double energy_of_room(const Room& cell);
// A force brings a ball to the given speed within a step, 0.3 m above a floor. The number that pass through.
int push_through_floor(const Chance& cell);
// A paddle of 1 cm, with the given tip speed, sweeps over balls at rest. The number that it passes through.
int swing_paddle(const Chance& cell);
// A rod of 1 m on a ball joint rotates (speed in rad/s) toward a pole of 1 cm. The number that pass it.
int swing_rod(const Chance& cell);

// --- collisions.cpp: bodies that collide with each other
struct GasCell {
    double speed = 10; // m/s, of every ball, in random directions
    int balls = 40;
    double radius = 0.05; // m
    int shots = 200;
    unsigned seed = 1;
};
struct Changes { // changes of balls' velocities within one step, against the exact reference
    int right = 0, false_ = 0, missing = 0;
    double worst_error = 0; // of the velocities of all balls, relative to the speed
};
Changes step_gas(const GasCell& cell);

struct Oblique {
    double velocity_error = 0; // worst of the shots, relative to the speed
    double mean_error = 0;
    double energy_error = 0; // worst of the shots, relative to the energy
};
// Two elastic balls, one of them at rest, with an offset of their lines of 0.6 of the sum of the radii.
Oblique hit_obliquely(const Chance& cell);

struct HeadOn {
    int shots = 0;
    int missed = 0; // they continue as if nothing were there
};
// Boxes of 2 to 20 cm, randomly rotated, collide; each has the given speed.
HeadOn meet_head_on(const Chance& cell);

struct Range {
    double least = 0, most = 0;
};
// Two frictionless elastic bodies, 20 cm wide, which spin at 10 rad/s, collide. Their energy relative to that before,
// minus 1.
Range energy_of_meeting(Kind kind, const Chance& cell);
// A frictionless elastic body, dropped from 1 m, bounces on the ground under gravity: its energy relative to the
// initial energy, minus 1, over all steps.
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
    // A game counts if the exact game, with initial positions and velocities disturbed by this fraction of the radius
    // and of themselves, ends within a tenth of the bar.
    double disturbance = 1e-5;
    int shots = 20; // number of games that count
    unsigned seed = 1;
};
struct BilliardsResult {
    int games = 0, skipped = 0;
    int differ = 0;         // by more than 0.5 degrees or 0.5 % of the speed
    double worst_angle = 0; // degrees
    double worst_speed = 0; // relative
};
// 16 balls, the first 10 impacts, compared with validation/billiards.h.
BilliardsResult play_billiards(const BilliardsCell& cell);

// --- rest.cpp: standing, sliding and rolling under gravity
double rebound_of_stack(int boxes, double height); // m/s, greatest rebound speed of the center of mass
// The rotation, degrees, of a box that slides for 14 m. Its center of mass is `offset` m off its center.
double turn_of_sliding_box(double offset);
// Two cards of 1 m x 2 cm lean on each other, at `degrees` to the vertical: whether they still stand after 5 s.
// `heading`: of both, rad.
bool do_cards_stand(double degrees, double friction, double heading);
double least_friction_of_cards(double degrees, double heading);
double energy_of_disk(double degrees, double seconds);                       // relative change
double slide_on_slope(double friction, double degrees_more, double seconds); // m
struct Apart {
    double speed = 0;  // m/s, greatest upward or sideways: falling is not counted
    double height = 0; // m, greatest rise above the start
};
// Bodies created in one place on the ground. `half`: of their height. `before`: the number of bodies that already exist
// elsewhere.
Apart made_in_one_place(const Shape& shape, int bodies, double half, int before);
double height_left_of_stack(int cubes, double edge, double seconds); // relative to the initial height

} // namespace cairn_test
