// All calls of the C API that are made from the table, with what they take.
#include "c_api_calls.h"

#include "c_api_calls.inc"
