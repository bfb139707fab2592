// A world made anew from what the C API tells of another one.
#pragma once

#include <cairn/c/cairn.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cairn_test {

// The call must have gone well; else the test ends with what it had to say.
#define CAIRN_CALL(call)                                                                                               \
    do {                                                                                                               \
        const cairn_result called = (call);                                                                            \
        ASSERT_EQ(called, CAIRN_OK) << #call << ": " << cairn_last_error();                                            \
    } while (false)

// Bodies, shapes and joints of `from`, in their order, with all that can be asked of them. `to` gets a new world.
void copy_world(const cairn_world* from, cairn_world** to);

} // namespace cairn_test
