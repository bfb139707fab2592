// All calls of the C API that are generated from the table, with their arguments.
#include "c_api_calls.h"

#include "c_api_calls.inc"
