// The visibility of shapes to queries.
#pragma once

#include "state/state.h"

#include <cairn/query.h>

namespace cairn {

// Decides which shapes a query sees. Keeps references to the state and the filter, which must not change meanwhile.
class QueryVisibility {
  public:
    QueryVisibility(const State& state, const QueryFilter& filter);
    bool sees(std::uint32_t shape) const {
        const ShapeTraits& traits = state_.shapes.traits[shape];
        if (traits.is_trigger && !filter_.triggers) return false;
        return sees_all_others_ || passes(traits.filter, state_.shapes.links[shape].body);
    }
    bool any() const { return filter_.any; }

  private:
    bool passes(const CollisionFilter& layers, std::int32_t body) const;
    const State& state_;
    const QueryFilter& filter_;
    bool sees_all_others_; // no filter applies to shapes other than triggers
};

} // namespace cairn
