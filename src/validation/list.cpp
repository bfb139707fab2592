// The list of all cases. Their laws are those of docs/validation.md.
#include "validation/cases.h"

namespace cairn::validation {

std::span<const Case> cases() {
    static constexpr Case all[] = {
        // --- free motion and joints
        // --- friction
        // --- collisions
        // --- structures
        // --- literature
    };
    return all;
}

} // namespace cairn::validation
