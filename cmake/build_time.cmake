# What makes a first build short.

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
