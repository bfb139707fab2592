// Watches the bodies of a world from step to step, and asks the oracle of every pair whether their cores met.
#pragma once

#include "flown_way.h"
#include "oracle.h"

#include <string>
#include <vector>

namespace cairn_test {

// Pairs of bodies in one step. What a joint holds together without colliding does not count; filters do not matter.
struct CoresMet {
    int overlapping = 0; // their cores overlap at the end
    // The ways of both are known (flown_way.h), nothing struck them, they did not touch, and their cores met.
    int passed = 0;
    // Their hearts overlap at the end, or met on ways that are known: a heart is what is deeper inside of a shape than
    // half of its inner radius. What the solver presses into something does not get so far.
    int deep = 0;
    std::string worst{}; // of the last that passed or is deep: which, and how
};

class CoreWatch {
  public:
    // Of all its bodies, as they are now. Its `hit_speed` should be 0, so that every impact is told.
    explicit CoreWatch(const cairn::World& world);
    // What happened since the last look, one step of `dt` seconds ago. The world must have the same bodies and shapes.
    CoresMet look(const cairn::World& world, double dt);

  private:
    struct Inside {               // what is left of a shape
        double depth = 0;         // m: how far inside of the shape it ends
        Core at_rest{}, on_way{}; // the latter smaller by what is not known of the way
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
        glm::dvec3 center{0, 0, 0}; // of mass, in the body's frame, m
        FreeBody free{};
        BodyState state{};
        FlownWay way{};
        glm::dvec3 low{0, 0, 0}, high{0, 0, 0}; // of where it was in the step
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
    void judge(const cairn::World& world, std::size_t a, std::size_t b, CoresMet& met);

    std::vector<Member> members_;
    std::vector<bool> overlapped_, touched_; // of a pair of members, at the last look
};

} // namespace cairn_test
