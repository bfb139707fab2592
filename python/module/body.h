// Python's accessor to one body.
#pragma once

#include "module/world.h"

namespace cairn::python {

struct PyBody {
    std::shared_ptr<PyWorld> world;
    BodyId id;

    const Body get(const char* call) const { return world->use(call).body(id); }
    // Runs a change of the body, and updates the arrays of all bodies.
    template <class F> void change(const char* call, F&& f) const {
        Body body = world->use(call).body(id);
        f(body);
        world->update(id);
    }
};

} // namespace cairn::python
