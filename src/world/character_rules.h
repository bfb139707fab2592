// What characters may be asked for.
#pragma once

#include "state/character_state.h"

#include <cairn/character.h>

namespace cairn {

// Throws Error(invalid_value).
void validate(const CharacterDef& def);
// Whether a snapshot has it as it may be.
bool is_sound_character(const Character& character);

} // namespace cairn
