// Events of two steps: those that can be read, and those that are being gathered.
#pragma once

#include <cairn/world.h>

#include <vector>

namespace cairn {

// What changes between two steps counts to the later one: it is gathered in `next`, and can be read once the step that
// follows has published it.
template <class Event> struct EventQueue {
    std::vector<Event> now, next;

    void publish() {
        now.swap(next);
        next.clear();
    }
};

struct StepEvents {
    std::vector<ContactBegin> begins; // found in a step alone
    std::vector<ContactHit> hits;     // likewise
    EventQueue<ContactEnd> ends;
    std::vector<ContactEnd> brief; // of touches that began and ended in a step: they end in the next one
    EventQueue<TriggerEvent> triggers;
    EventQueue<JointEvent> joints;
    EventQueue<SleepEvent> sleeps;

    void begin_step() { begins.clear(), hits.clear(); }
    // What can be read; what is gathered for the next step stays.
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
