// Included before the scenes of tests/determinism when they are compiled for the recorder.
#pragma once

#include "generated/recorded_world.h"

#define World RecordedWorld
#define Body RecordedBody
