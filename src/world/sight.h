// What queries see.
#pragma once

#include "state/state.h"

#include <cairn/query.h>

namespace cairn {

// Which shapes a query sees. Of a state and a filter that stay as they are.
class Sight {
  public:
    Sight(const State& state, const QueryFilter& filter);
    bool sees(std::uint32_t shape) const {
        const ShapeTraits& traits = state_.shapes.traits[shape];
        if (traits.is_trigger && !filter_.triggers) return false;
        if (filter_.layers != all_layers && (traits.filter.layers & filter_.layers) == 0) return false;
        if (filter_.own_layers != all_layers && (traits.filter.collides_with & filter_.own_layers) == 0) return false;
        return sees_all_bodies_ || sees_body(state_.shapes.links[shape].body);
    }
    bool any() const { return filter_.any; }

  private:
    bool sees_body(std::int32_t body) const;
    const State& state_;
    const QueryFilter& filter_;
    bool sees_all_bodies_;
};

} // namespace cairn
