# What makes a first build short.

if(PROJECT_IS_TOP_LEVEL)
    set(default OFF)
else()
    set(default ON)
endif()
# ./dev sets it. By hand it is off: who changes a header that is read so builds all of the engine anew.
option(CAIRN_PRECOMPILED "Read the headers that nearly all files of the engine include once for all" ${default})
unset(default)
option(CAIRN_UNITY "Compile several files at a time, where headers take most of the time (not the engine)" ON)

# cairn_quick_build(LEVEL TARGET...): for what takes no time in a step. The sources of these targets are compiled several
# at a time, and a Release build optimizes them by LEVEL (-O1, -O2). Never for the engine: its hot loops want -O3, and what
# a file keeps to itself would be seen by those after it, where a call may choose another overload without a word.
# Names in unnamed namespaces must differ within a target; SKIP_UNITY_BUILD_INCLUSION leaves a file alone.
function(cairn_quick_build level)
    if(EMSCRIPTEN) # there it is the size that counts: it is sent to each page
        set(level -Os)
    endif()
    foreach(target ${ARGN})
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ${CAIRN_UNITY} UNITY_BUILD_BATCH_SIZE 8)
    endforeach()
endfunction()

# cairn_quick_tests(FOLDER): the tests below it. In a Release build they are optimized by -O1 (what takes time in them is
# the engine), and read the headers that nearly all of them include once for all.
function(cairn_quick_tests folder)
    if(NOT TARGET cairn_test_headers)
        add_executable(cairn_test_headers EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tests/headers.cpp)
        target_link_libraries(cairn_test_headers PRIVATE cairn_flags GTest::gtest)
        target_precompile_headers(cairn_test_headers PRIVATE <gtest/gtest.h> <algorithm> <array> <chrono> <cmath> <filesystem>
                                   <fstream> <functional> <random> <span> <string> <thread> <vector>)
        target_compile_options(cairn_test_headers PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target ${targets})
        get_target_property(type ${target} TYPE)
        get_target_property(libraries ${target} LINK_LIBRARIES)
        if(NOT type STREQUAL "EXECUTABLE" OR target STREQUAL "cairn_test_headers")
            continue()
        endif()
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
        get_target_property(sources ${target} SOURCES)
        if(CAIRN_UNITY AND "GTest::gtest" IN_LIST libraries AND "cairn_flags" IN_LIST libraries AND NOT sources MATCHES "\\.c(;|$)")
            target_precompile_headers(${target} REUSE_FROM cairn_test_headers)
        endif()
    endforeach()
    get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    foreach(below ${folders})
        cairn_quick_tests(${below})
    endforeach()
endfunction()
