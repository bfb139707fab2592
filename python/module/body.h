// The accessor to one body, as Python holds it.
#pragma once

#include "module/world.h"

namespace cairn::python {

struct PyBody {
    std::shared_ptr<PyWorld> world;
    BodyId id;

    const Body get(const char* call) const { return world->use(call).body(id); }
    // Runs a change of the body, and brings the arrays up to date.
    template <class F> void change(const char* call, F&& f) const {
        Body body = world->use(call).body(id);
        f(body);
        world->update(id);
    }
};

} // namespace cairn::python
