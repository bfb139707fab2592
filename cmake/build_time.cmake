# Options that shorten a first build.

if(PROJECT_IS_TOP_LEVEL)
    set(default OFF)
else()
    set(default ON)
endif()
# ./dev sets this option. It is off by default: changing a precompiled header rebuilds the whole engine.
option(CAIRN_PRECOMPILED "Read the headers that nearly all files of the engine include once for all" ${default})
unset(default)
option(CAIRN_UNITY "Compile several files at a time, where headers take most of the time (not the engine)" ON)
# The number of files per unity build unit. Changing a file recompiles all files of its unit; a single full build is
# faster with larger units.
if(CAIRN_PRECOMPILED)
    set(cairn_unity_size 32)
else()
    set(cairn_unity_size 8)
endif()

# cairn_quick_build(LEVEL TARGET...): for targets outside the step. Their sources are compiled several at a time (unity
# build), and a Release build optimizes them with LEVEL (-O1, -O2). Not for the engine: its hot loops need -O3, and
# file-local declarations would be visible to the following files of a unit, where a call might silently select another
# overload. Names in unnamed namespaces must differ within a target; SKIP_UNITY_BUILD_INCLUSION excludes a file.
function(cairn_quick_build level)
    if(EMSCRIPTEN) # every page downloads the module: size matters more
        set(level -Os)
    endif()
    foreach(target ${ARGN})
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ${CAIRN_UNITY} UNITY_BUILD_BATCH_SIZE ${cairn_unity_size})
    endforeach()
endfunction()

# A target whose precompiled headers some tests reuse.
function(cairn_test_headers name)
    add_executable(${name} EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tests/headers.cpp)
    target_link_libraries(${name} PRIVATE cairn_flags cairn::cairn GTest::gtest)
    target_precompile_headers(${name} PRIVATE <gtest/gtest.h> <algorithm> <array> <chrono> <cmath> <filesystem> <fstream>
                              <functional> <random> <span> <string> <thread> <vector> ${ARGN})
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# cairn_quick_tests(FOLDER): for the tests in a folder. A Release build optimizes them with -O1 (their time is spent in
# the engine), with precompiled headers for those that nearly all of them include. White-box tests, where the engine's
# internal names differ from the public ones, do without the public headers.
function(cairn_quick_tests folder)
    # Unity builds, for targets whose headers take most of the time (JSON, scenes, the viewer), and whose names in
    # unnamed namespaces differ.
    set(together cairn_api_test cairn_character_test cairn_checkpoint_cli_test cairn_checkpoint_test cairn_cli_test
                 cairn_convex_test cairn_faults_test cairn_geometry_test cairn_impacts cairn_impacts_oracle_test
                 cairn_physics_test cairn_recording_test cairn_scene_test cairn_sweep_cli_test cairn_sweep_test
                 cairn_viewer_core_test)
    if(NOT TARGET cairn_test_headers)
        cairn_test_headers(cairn_test_headers)
        cairn_test_headers(cairn_public_test_headers <cairn/cairn.h>)
    endif()
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target ${targets})
        get_target_property(type ${target} TYPE)
        get_target_property(libraries ${target} LINK_LIBRARIES)
        if(NOT type STREQUAL "EXECUTABLE" OR target MATCHES "_test_headers$")
            continue()
        endif()
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
        get_target_property(sources ${target} SOURCES)
        if(target IN_LIST together)
            set_target_properties(${target} PROPERTIES UNITY_BUILD ${CAIRN_UNITY} UNITY_BUILD_BATCH_SIZE 12)
        endif()
        if(CAIRN_UNITY AND "GTest::gtest" IN_LIST libraries AND "cairn_flags" IN_LIST libraries AND NOT sources MATCHES "\\.c(;|$)")
            get_target_property(folders ${target} INCLUDE_DIRECTORIES)
            set(headers cairn_public_test_headers)
            if("${PROJECT_SOURCE_DIR}/src" IN_LIST folders)
                set(headers cairn_test_headers)
            endif()
            target_precompile_headers(${target} REUSE_FROM ${headers})
        endif()
    endforeach()
    get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    foreach(below ${folders})
        cairn_quick_tests(${below})
    endforeach()
endfunction()
