// Comes before the scenes of tests/determinism when they are compiled to be recorded.
#pragma once

#include "generated/recorded_world.h"

#define World RecordedWorld
#define Body RecordedBody
