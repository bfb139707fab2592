// Copies a world with the information that the C API gives about it.
#pragma once

#include <cairn/c/cairn.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cairn_test {

// Requires that the call succeeds; otherwise the test ends with its error message.
#define CAIRN_CALL(call)                                                                                               \
    do {                                                                                                               \
        const cairn_result called = (call);                                                                            \
        ASSERT_EQ(called, CAIRN_OK) << #call << ": " << cairn_last_error();                                            \
    } while (false)

// Copies bodies, shapes and joints of `from` in their order, with all their properties. `to` receives a new world.
void copy_world(const cairn_world* from, cairn_world** to);

} // namespace cairn_test
