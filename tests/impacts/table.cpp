#include "table.h"

#include "cells.h"

#include <string>

namespace cairn_test {
namespace {

using Rows = std::vector<Row>;

constexpr double step_seconds = 1.0 / 60;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

// A row whose count should be zero.
Row none(const std::string& quantity, double measured, const std::string& note = {}) {
    return {quantity, step_seconds, 0, measured, 0, Bar::at_most, note};
}
Row within(const std::string& quantity, double measured, double bar) {
    return {quantity, step_seconds, 0, measured, bar, Bar::absolute};
}
Row at_most(const std::string& quantity, double measured, double bar) {
    return {quantity, step_seconds, 0, measured, bar, Bar::at_most};
}
Row at_least(const std::string& quantity, double measured, double bar) {
    return {quantity, step_seconds, 1, measured, bar, Bar::at_least};
}

int or_default(int shots, int usual) { return shots > 0 ? shots : usual; }

// --- ghosts

Row ghosts_row(const std::string& what, const Ghosts& ghosts) {
    return none(what + ": deflected of " + std::to_string(ghosts.shots), ghosts.deflected,
                "by " + number(ghosts.mean_angle) + " degrees on average; the first left at (" +
                    number(double(ghosts.first.x)) + ", " + number(double(ghosts.first.y)) + ") m/s");
}

Rows ghost_balls(int shots) {
    Rows rows;
    for (const double speed : {5.0, 10.0, 30.0, 100.0}) {
        PassBy cell{.speed = speed, .shots = or_default(shots, 40)};
        rows.push_back(ghosts_row("balls, 2 cm of air, " + number(speed) + " m/s", pass_by(cell)));
    }
    PassBy far{.gap = 0.3, .speed = 100, .shots = or_default(shots, 40)};
    rows.push_back(ghosts_row("balls, 30 cm of air, 100 m/s", pass_by(far)));
    return rows;
}

Rows ghost_edge(int shots) {
    Rows rows;
    for (const double speed : {10.0, 30.0, 100.0, 300.0, 1000.0}) {
        PassBy cell{.gap = 0.01, .speed = speed, .shots = or_default(shots, 20)};
        rows.push_back(ghosts_row("ball past an edge, 1 cm of air, " + number(speed) + " m/s", pass_edge(cell)));
    }
    return rows;
}

Rows ghost_shapes(int shots) {
    Rows rows;
    for (const Kind kind : all_kinds)
        for (const double spin : {0.0, 100.0}) {
            Ghosts sum;
            for (const double size : {0.01, 0.05, 0.2})
                for (const double speed : {10.0, 100.0, 1000.0, 2000.0}) {
                    PassBy cell{kind, size, 0.0005, speed, spin, or_default(shots, 40)};
                    const Ghosts ghosts = pass_by(cell);
                    sum.shots += ghosts.shots;
                    sum.deflected += ghosts.deflected;
                    sum.mean_angle += ghosts.mean_angle * ghosts.deflected;
                }
            const double angle = sum.deflected > 0 ? sum.mean_angle / sum.deflected : 0;
            rows.push_back(none(std::string(name_of(kind)) + ", 0.5 mm of air, " + number(spin) +
                                    " rad/s: deflected of " + std::to_string(sum.shots),
                                sum.deflected, "by " + number(angle) + " degrees on average"));
        }
    return rows;
}

// --- tunnelling

Row lost_row(const std::string& what, const Lost& lost) {
    return none(what + ": through, of " + std::to_string(lost.shots), lost.through,
                "cores left in the wall at the end of a step: " + std::to_string(lost.core_in));
}

Rows walls_of_issue(int shots) {
    Rows rows;
    struct Line {
        Kind kind;
        double size, speed;
    };
    const Line lines[] = {{Kind::box, 0.01, 30},   {Kind::box, 0.01, 100},    {Kind::box, 0.01, 300},
                          {Kind::box, 0.01, 1000}, {Kind::hull, 0.01, 30},    {Kind::hull, 0.01, 100},
                          {Kind::hull, 0.01, 300}, {Kind::hull, 0.01, 1000},  {Kind::box, 0.05, 300},
                          {Kind::hull, 0.05, 100}, {Kind::sphere, 0.05, 1000}};
    for (const Line& line : lines) {
        Shooting cell{.kind = line.kind, .size = line.size, .speed = line.speed, .shots = or_default(shots, 20)};
        rows.push_back(lost_row(std::string(name_of(line.kind)) + " of " + number(100 * line.size) + " cm, " +
                                    number(line.speed) + " m/s",
                                shoot(cell)));
    }
    return rows;
}

Rows round_things(int shots) {
    Rows rows;
    for (const Kind kind : {Kind::cylinder, Kind::cone}) {
        Shooting cell{.kind = kind, .speed = 400, .shots = or_default(shots, 100)};
        rows.push_back(lost_row(std::string(name_of(kind)) + " of 1 cm, 400 m/s", shoot(cell)));
    }
    return rows;
}

void add(Lost& sum, const Lost& lost) {
    sum.shots += lost.shots;
    sum.through += lost.through;
    sum.core_in += lost.core_in;
}

// All shapes, targets, sizes, speeds and spins; the counts by shape and by target.
Rows all_walls(int shots) {
    constexpr double speeds[] = {10, 30, 100, 300, 1000, 2000};
    Lost by_kind[std::size(all_kinds)], by_target[std::size(all_targets)], by_speed[std::size(speeds)], by_spin[2], sum;
    unsigned seed = 1;
    for (const Kind kind : all_kinds)
        for (const Target target : all_targets)
            for (const double size : {0.01, 0.05, 0.2})
                for (std::size_t i = 0; i < std::size(speeds); ++i)
                    for (const double spin : {0.0, 100.0}) {
                        Shooting cell{kind, target, size, speeds[i], spin};
                        cell.restitution = seed % 3 == 0 ? 0.5 : 0;
                        cell.shots = or_default(shots, 200);
                        cell.seed = seed++;
                        const Lost lost = shoot(cell);
                        add(by_kind[std::size_t(kind)], lost);
                        add(by_target[std::size_t(target)], lost);
                        add(by_spin[spin > 0], lost);
                        add(by_speed[i], lost);
                        add(sum, lost);
                    }
    Rows rows;
    for (const Kind kind : all_kinds) rows.push_back(lost_row(name_of(kind), by_kind[std::size_t(kind)]));
    for (const Target target : all_targets)
        rows.push_back(lost_row(std::string("against ") + name_of(target), by_target[std::size_t(target)]));
    for (std::size_t i = 0; i < std::size(speeds); ++i)
        rows.push_back(lost_row("at " + number(speeds[i]) + " m/s", by_speed[i]));
    rows.push_back(lost_row("without spin", by_spin[0]));
    rows.push_back(lost_row("at 100 rad/s", by_spin[1]));
    rows.push_back(none("cores left in walls, of " + std::to_string(sum.shots), sum.core_in));
    return rows;
}

Rows struck(int shots) {
    Rows rows;
    for (const double speed : {30.0, 100.0, 300.0}) {
        const Chance cell{speed, or_default(shots, 20)};
        rows.push_back(
            none(number(speed) + " m/s: behind the wall, of " + std::to_string(cell.shots), strike_before_wall(cell)));
    }
    return rows;
}

Rows between_walls(int shots) {
    Rows rows;
    for (const double speed : {30.0, 100.0, 300.0}) {
        const Chance cell{speed, or_default(shots, 20)};
        const Bounced bounced = bounce_between_walls(cell);
        const std::string of = ", of " + std::to_string(cell.shots);
        rows.push_back(none(number(speed) + " m/s: escaped" + of, bounced.escaped));
        rows.push_back(none(number(speed) + " m/s: wrong number of bounces" + of, bounced.miscounted));
    }
    return rows;
}

Rows closed_room(int shots) {
    Rows rows;
    for (const double speed : {30.0, 100.0})
        for (const Kind kind : {Kind::sphere, Kind::box, Kind::hull}) {
            Room cell{.kind = kind, .speed = speed, .shots = or_default(shots, 10)};
            rows.push_back(none(std::string("10 of kind ") + name_of(kind) + ", " + number(speed) + " m/s: outside",
                                escape_room(cell)));
        }
    return rows;
}

Rows cores(int shots) {
    Rows rows;
    for (const double speed : {10.0, 50.0, 200.0}) {
        const CrowdSeen met = watch_crowd({.speed = speed, .shots = or_default(shots, 5)});
        const std::string of = " (pairs, in " + std::to_string(met.steps) + " steps)";
        rows.push_back(none(number(speed) + " m/s: passed" + of, met.passed));
        rows.push_back(none(number(speed) + " m/s: half of one in half of the other" + of, met.deep));
        rows.push_back(none(number(speed) + " m/s: overlap at the end" + of, met.overlapping));
    }
    return rows;
}

Rows force(int shots) {
    const Chance cell{30, or_default(shots, 20)};
    return {none("30 m/s: through, of " + std::to_string(cell.shots), push_through_floor(cell))};
}

Rows paddle(int shots) {
    Rows rows;
    for (const double speed : {30.0, 90.0}) {
        const Chance cell{speed, or_default(shots, 20)};
        rows.push_back(
            none("tip " + number(speed) + " m/s: balls left, of " + std::to_string(cell.shots), swing_paddle(cell)));
    }
    return rows;
}

Rows rod(int shots) {
    Rows rows;
    for (const double rate : {50.0, 100.0}) {
        const Chance cell{rate, or_default(shots, 20)};
        rows.push_back(none(number(rate) + " rad/s: past the pole, of " + std::to_string(cell.shots), swing_rod(cell)));
    }
    return rows;
}

// --- impacts

Rows gas(int shots) {
    Rows rows;
    for (const double speed : {3.0, 10.0, 30.0}) {
        const Changes changes = step_gas({.speed = speed, .shots = or_default(shots, 200)});
        const std::string right = "right: " + std::to_string(changes.right);
        rows.push_back(none(number(speed) + " m/s: false changes of velocity", changes.false_, right));
        rows.push_back(none(number(speed) + " m/s: missing changes", changes.missing, right));
        rows.push_back(within(number(speed) + " m/s: worst velocity error", changes.worst_error, 0.002));
    }
    return rows;
}

Rows oblique(int shots) {
    Rows rows;
    for (const double speed : {1.0, 5.0, 10.0}) {
        const Oblique hit = hit_obliquely({speed, or_default(shots, 40)});
        Row row = within(number(speed) + " m/s: worst velocity error", hit.velocity_error, 0.002);
        row.note = "mean " + number(hit.mean_error) + ", worst energy error " + number(hit.energy_error);
        rows.push_back(row);
    }
    return rows;
}

Rows head_on(int shots) {
    Rows rows;
    for (const double speed : {10.0, 20.0, 30.0}) {
        const HeadOn met = meet_head_on({speed, or_default(shots, 20)});
        rows.push_back(none("2 x " + number(speed) + " m/s: missed, of " + std::to_string(met.shots), met.missed));
    }
    return rows;
}

Rows spinning_boxes(int shots) {
    Rows rows;
    for (const Kind kind : {Kind::box, Kind::plank})
        for (const double speed : {3.0, 10.0}) {
            const Range energy = energy_of_meeting(kind, {speed, or_default(shots, 300)});
            const std::string what = std::string(name_of(kind)) + ", 2 x " + number(speed) + " m/s: ";
            rows.push_back(within(what + "most energy lost", energy.least, 0.001));
            rows.push_back(within(what + "most energy gained", energy.most, 0.001));
        }
    return rows;
}

Rows elastic_room(int shots) {
    Rows rows;
    for (const Kind kind : {Kind::box, Kind::plank, Kind::capsule, Kind::sphere}) {
        Room cell{.kind = kind, .bodies = 100, .size = 0.1, .width = 3, .thickness = 1, .speed = 8};
        cell.seconds = 20;
        cell.shots = or_default(shots, 1);
        rows.push_back(within(std::string("100 of kind ") + name_of(kind) + ": change of energy in 20 s",
                              energy_of_room(cell), 0.01));
    }
    return rows;
}

Rows elastic_box(int shots) {
    Rows rows;
    for (const Kind kind : {Kind::box, Kind::plank})
        for (const double size : {0.5, 0.05}) {
            const Range energy = energy_of_bouncing({.kind = kind, .size = size, .shots = or_default(shots, 10)});
            const std::string what = std::string(name_of(kind)) + " of " + number(200 * size) + " cm: ";
            rows.push_back(within(what + "most energy lost", energy.least, 0.01));
            rows.push_back(within(what + "most energy gained", energy.most, 0.01));
        }
    return rows;
}

Rows billiards(int shots) {
    Rows rows;
    for (const bool is_planar : {true, false})
        for (const double speed : {3.0, 10.0, 30.0}) {
            const BilliardsResult result =
                play_billiards({.speed = speed, .is_planar = is_planar, .shots = or_default(shots, 20)});
            const std::string what = std::string(is_planar ? "planar, " : "in space, ") + number(speed) + " m/s";
            rows.push_back(none(what + ": games that differ, of " + std::to_string(result.games), result.differ,
                                "worst " + number(result.worst_angle) + " degrees, " + number(result.worst_speed) +
                                    " of speed; skipped as ill-conditioned: " + std::to_string(result.skipped)));
        }
    return rows;
}

// --- standing, sliding and rolling

Rows dropped_stack(int) { return {at_most("10 boxes from 1 m: rises at, m/s", rebound_of_stack(10, 1), 0.05)}; }

Rows sliding_box(int) {
    Rows rows;
    for (const double offset : {0.05, 0.18})
        rows.push_back(at_most("center of mass " + number(100 * offset) + " cm aside, 14 m: degrees",
                               turn_of_sliding_box(offset), 2));
    return rows;
}

Rows cards(int) {
    double least = 0;
    int below = 0;
    for (int i = 0; i < 20; ++i) {
        const double heading = 0.3 * i;
        least = std::max(least, least_friction_of_cards(30, heading));
        below += do_cards_stand(30, 0.97 * 0.2787, heading);
    }
    return {{"30 degrees: stand from friction, of 20 headings", step_seconds, 0.2887, least, 0.31, Bar::at_most},
            {"30 degrees: stand at 3 % below theory", step_seconds, 0, double(below), 0, Bar::at_most}};
}

Rows disk(int) {
    Rows rows;
    for (const double lean : {10.0, 30.0})
        rows.push_back(within("lean of " + number(lean) + " degrees: energy after 1 s", energy_of_disk(lean, 1), 0.02));
    return rows;
}

Rows slope(int) {
    return {{"0.25 degrees steeper than friction 0.5: slides in 5 s, m", step_seconds, 0.598,
             slide_on_slope(0.5, 0.25, 5), 0.03, Bar::relative}};
}

Rows one_place(int) {
    Apart apart;
    for (int before = 0; before < 20; ++before) {
        const Apart one = made_in_one_place(Sphere{0.5f}, 10, 0.5, before);
        apart = {std::max(apart.speed, one.speed), std::max(apart.height, one.height)};
    }
    return {at_most("10 balls, the fastest of 20 starts, m/s", apart.speed, 3.1),
            {"10 balls, the highest, m", step_seconds, 1.5, apart.height, 2, Bar::at_most}};
}

Rows small_stack(int) {
    Rows rows;
    for (const double edge : {0.01, 0.005, 0.002})
        rows.push_back(
            at_least("5 cubes of " + number(1000 * edge) + " mm: height left", height_left_of_stack(5, edge, 5), 0.98));
    return rows;
}

constexpr ImpactRow all_rows[] = {
    {"ghost-balls", "a ball passes a fixed one, radius 5 cm", ghost_balls},
    {"ghost-edge", "a ball passes the edge of a box, radius 5 cm", ghost_edge},
    {"ghost-shapes", "all shapes of 1, 5 and 20 cm pass their like at 10 to 2,000 m/s", ghost_shapes},
    {"walls", "random shots at a static wall of 1 cm", walls_of_issue},
    {"walls-round", "cylinders and cones at a static wall of 1 cm", round_things},
    {"walls-all", "all shapes, 1, 5 and 20 cm, 10 to 2,000 m/s, all targets, no spin and 100 rad/s", all_walls},
    {"struck", "an elastic ball 0.3 m before a wall is struck by another", struck},
    {"between-walls", "an elastic ball between two walls 1 m apart, 1 s", between_walls},
    {"closed-room", "10 elastic bodies, 10 cm wide, in a room of 1 m with walls of 1 cm, 2 s", closed_room},
    {"cores", "14 mixed bodies in a room of 1 m with walls of 1 cm: cores, by the slow oracle", cores},
    {"force", "a force that acts for one step, 5 to 30 cm above a floor of 1 cm", force},
    {"paddle", "a turning kinematic paddle of 1 cm and a ball in its way", paddle},
    {"rod", "a rod of 1 m on a ball joint and a pole of 1 cm in its way", rod},
    {"gas", "40 elastic balls in a cubic meter, one step, against the exact answer", gas},
    {"oblique", "oblique elastic hit of two balls, offset 0.6", oblique},
    {"head-on", "randomly turned boxes of 2 to 20 cm meet head on", head_on},
    {"spinning-boxes", "two elastic boxes at 10 rad/s meet: energy over that before, less 1", spinning_boxes},
    {"elastic-room", "100 smooth elastic bodies, 20 cm wide, at 8 m/s in a room of 3 m, 20 s", elastic_room},
    {"elastic-box", "a smooth elastic box bounces on the ground for 60 s, dropped from 1 m", elastic_box},
    {"billiards", "16 balls, the first 10 impacts, against the exact game", billiards},
    {"dropped-stack", "a stack dropped with restitution 0", dropped_stack},
    {"sliding-box", "a box whose center of mass is beside its middle slides", sliding_box},
    {"cards", "two cards that lean on each other", cards},
    {"disk", "Euler's disk without losses", disk},
    {"slope", "a box on a slope that is a little too steep", slope},
    {"one-place", "balls made in one place, recovery speed 3 m/s", one_place},
    {"small-stack", "a stack of small cubes, 5 s", small_stack},
};

} // namespace

std::span<const ImpactRow> impact_rows() { return all_rows; }

} // namespace cairn_test
