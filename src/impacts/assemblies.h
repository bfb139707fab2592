// Assemblies: bodies that joints connect, found on demand while impacts are resolved.
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

    // Number of the body's assembly, the same for all of its bodies; none: the body has no joints.
    std::int32_t of(std::int32_t body);
    // Inverse of the mass that must move with a body so that its joints stay closed, 1/kg; 0: they hold it in place.
    double inverse_mass(std::int32_t body) {
        const std::int32_t assembly = of(body);
        return assembly == none ? double(bodies_.mass[body].inverse_mass) : scratch_.assemblies[assembly].inverse_mass;
    }
    // Calls f(body) for all bodies of a body's assembly, or for the body alone if it has none.
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
