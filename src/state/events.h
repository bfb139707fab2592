// Events: those that can be read after the last step, and those that are gathered for the next.
#pragma once

#include <cairn/world.h>

#include <vector>

namespace cairn {

// A queue for events that may also arise between steps. Such an event belongs to the later step: it is gathered in
// `next`, and can be read once that step has published it.
template <class Event> struct EventQueue {
    std::vector<Event> now, next;

    void publish() {
        now.swap(next);
        next.clear();
    }
};

struct StepEvents {
    std::vector<ContactBegin> begins; // gathered within a step only
    std::vector<ContactHit> hits;     // gathered within a step only
    EventQueue<ContactEnd> ends;
    std::vector<ContactEnd> brief; // ends of touches that began within the same step: they are reported in the next one
    EventQueue<TriggerEvent> triggers;
    EventQueue<JointEvent> joints;
    EventQueue<SleepEvent> sleeps;

    void begin_step() { begins.clear(), hits.clear(); }
    // Removes the events that can be read; those gathered for the next step stay.
    void forget() {
        begins.clear(), hits.clear(), brief.clear();
        ends.now.clear(), triggers.now.clear(), joints.now.clear(), sleeps.now.clear();
    }
    void publish() {
        ends.publish(), triggers.publish(), joints.publish(), sleeps.publish();
        ends.next.swap(brief);
        brief.clear();
    }
};

} // namespace cairn
