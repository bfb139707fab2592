// Watches the bodies of a world from step to step, and asks the oracle for every pair whether their cores met.
#pragma once

#include "flown_way.h"
#include "oracle.h"

#include <string>
#include <vector>

namespace cairn_test {

// Counts of pairs of bodies in one step. Pairs whose joint disables their collision do not count; filters are ignored.
struct CoreEncounters {
    int overlapping = 0; // cores overlap at the end of the step
    // The paths of both are known (flown_way.h), without impact or contact, and their cores met.
    int passed = 0;
    // Their hearts overlap at the end, or met on known paths. The heart is the part of a shape deeper than half of its
    // inner radius, where the pressing of the solver does not reach.
    int deep = 0;
    std::string worst{}; // the last that passed or is deep: the pair, and how
};

class CoreWatch {
  public:
    // Watches all bodies of the world, from their present state. Its `hit_speed` should be 0, so that every impact is
    // reported.
    explicit CoreWatch(const cairn::World& world);
    // Evaluates the one step of `dt` seconds since the last call. The world must have the same bodies and shapes.
    CoreEncounters look(const cairn::World& world, double dt);

  private:
    struct Inside {               // an inset part of a shape
        double depth = 0;         // inset from the surface, m
        Core at_rest{}, on_way{}; // on_way: smaller by the error of the path
    };
    struct Part { // a shape of a body
        cairn::Shape shape;
        glm::dvec3 position{0, 0, 0}; // in the body's frame, m
        glm::dquat rotation{1, 0, 0, 0};
        Inside core{}, heart{};
    };
    struct Member {
        cairn::BodyId id;
        bool is_static = false;
        std::vector<Part> parts{};
        glm::dvec3 center{0, 0, 0}; // center of mass in the body's frame, m
        FreeBody free{};
        BodyState state{};
        BodyPath way{};
        glm::dvec3 low{0, 0, 0}, high{0, 0, 0}; // bounds over the step
    };

    static Member make_member(const cairn::World& world, cairn::BodyId id);
    static BodyState state_of(const cairn::World& world, cairn::BodyId id);
    static void bound_static(Member& member);
    static void move(Member& member, const BodyState& to, double dt, int impacts);
    static Moving moving(const Member& member, const Part& part, const Knot& from, const Knot& to, const Core& core);
    static bool do_meet_between(const Member& a, const Member& b, double from, double to, Inside Part::*inside);
    static bool do_meet_at_end(const Member& a, const Member& b, Inside Part::*inside);
    static bool do_meet_on_way(const Member& a, const Member& b, Inside Part::*inside);
    std::vector<bool> touching(const cairn::World& world) const; // pairs of members
    void judge(const cairn::World& world, std::size_t a, std::size_t b, CoreEncounters& met);

    std::vector<Member> members_;
    std::vector<bool> overlapped_, touched_; // per pair of members, at the last call
};

} // namespace cairn_test
