// Validation of character definitions and of characters in snapshots.
#pragma once

#include "state/character_state.h"

#include <cairn/character.h>

namespace cairn {

// Throws Error(invalid_value).
void validate(const CharacterDef& def);
// Whether every member of a character read from a snapshot is within its valid range.
bool is_sound_character(const Character& character);

} // namespace cairn
