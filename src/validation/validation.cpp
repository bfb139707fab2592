#include "validation/validation.h"

#include "validation/cases.h"

#include <cmath>
#include <string>

namespace cairn::validation {

bool Row::passes() const {
    if (!std::isfinite(measured)) return false;
    switch (kind) {
    case Bar::relative:
        return std::fabs(measured - expected) <= bar * std::fabs(expected);
    case Bar::absolute:
        return std::fabs(measured - expected) <= bar;
    case Bar::at_most:
        return measured <= bar;
    case Bar::at_least:
        return measured >= bar;
    }
    return false;
}

const Case* find_case(std::string_view name_or_number) {
    for (const Case& entry : cases())
        if (entry.name == name_or_number || std::to_string(entry.number) == name_or_number) return &entry;
    return nullptr;
}

} // namespace cairn::validation
