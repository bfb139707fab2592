// Bodies that joints hold together, as far as impacts ask for them.
#pragma once

#include "state/state.h"
#include "state/sweep_scratch.h"

namespace cairn {

class Assemblies {
  public:
    Assemblies(const Bodies& bodies, const Joints& joints, SweepScratch& scratch);
    ~Assemblies();
    Assemblies(const Assemblies&) = delete;
    Assemblies& operator=(const Assemblies&) = delete;

    // Equal for bodies of one assembly; none: no joint holds the body.
    std::int32_t of(std::int32_t body);
    // f(body) for all of the assembly of a body, or for that alone.
    template <class F> void for_each_beside(std::int32_t body, F&& f) {
        const std::int32_t assembly = of(body);
        if (assembly == none) return f(body);
        for (std::int32_t k = scratch_.assemblies[assembly].begin; k < scratch_.assemblies[assembly].end; ++k)
            f(scratch_.members[k]);
    }

  private:
    void take(std::int32_t body, std::int32_t assembly);

    const Bodies& bodies_;
    const Joints& joints_;
    SweepScratch& scratch_;
};

} // namespace cairn
