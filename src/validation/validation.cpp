#include "validation/validation.h"

#include "validation/cases.h"

#include <cmath>
#include <string>

namespace cairn::validation {

bool Row::keeps(double bound) const {
    if (!std::isfinite(measured)) return false;
    switch (kind) {
    case Bar::relative:
        return std::fabs(measured - expected) <= bound * std::fabs(expected);
    case Bar::absolute:
        return std::fabs(measured - expected) <= bound;
    case Bar::at_most:
        return measured <= bound;
    case Bar::at_least:
        return measured >= bound;
    }
    return false;
}

const Case* find_case(std::string_view name_or_number) {
    for (const Case& entry : cases())
        if (entry.name == name_or_number || std::to_string(entry.number) == name_or_number) return &entry;
    return nullptr;
}

} // namespace cairn::validation
