# The instruction sets for which the kernels are compiled: cairn_isas, and cairn_flags_<set> for each.
set(cairn_isas scalar)
set(cairn_baseline scalar) # supported by every machine of this architecture
set(cairn_flags_scalar -DCAIRN_SIMD_SCALAR -O1) # the reference: a short build matters more than speed
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND cairn_isas sse2 avx2 avx512)
    set(cairn_baseline sse2)
    set(cairn_flags_sse2 -DCAIRN_SIMD_PAIR)
    set(cairn_flags_avx2 -DCAIRN_SIMD_AVX2 -mavx2)
    # AVX-512 is not used for its wide registers, which slow some processors down, but for its doubled number of 256-bit
    # registers.
    set(cairn_flags_avx512 -DCAIRN_SIMD_AVX2 -DCAIRN_SIMD_AVX512 -mavx2 -mavx512f -mavx512vl -mavx512dq -mavx512bw
                           -mprefer-vector-width=256)
    if(MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # Windows aligns the stack to 16 bytes, but gcc assumes 32 (gcc bug 54412): all moves must therefore be
        # unaligned.
        foreach(isa avx2 avx512)
            list(APPEND cairn_flags_${isa} -Wa,-muse-unaligned-vector-move)
        endforeach()
    endif()
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
    list(APPEND cairn_isas neon)
    set(cairn_baseline neon)
    set(cairn_flags_neon -DCAIRN_SIMD_PAIR)
elseif(EMSCRIPTEN)
    list(APPEND cairn_isas simd128)
    set(cairn_baseline simd128)
    set(cairn_flags_simd128 -DCAIRN_SIMD_PAIR -msimd128)
endif()

# Sets RESULT to whether this machine's processor has all of the given features.
include(CheckCXXSourceRuns)
function(cairn_runs_here result)
    if(CMAKE_CROSSCOMPILING)
        set(${result} FALSE PARENT_SCOPE)
        return()
    endif()
    list(TRANSFORM ARGN REPLACE "(.+)" "__builtin_cpu_supports(\"\\1\")")
    list(JOIN ARGN " && " condition)
    check_cxx_source_runs("int main() { return ${condition} ? 0 : 1; }" ${result})
endfunction()

# When Cairn is part of another project, short builds matter: only the kernels of this machine are built, and those that
# run on every machine.
set(kernels_by_default native)
if(PROJECT_IS_TOP_LEVEL)
    set(kernels_by_default "")
endif()
set(CAIRN_KERNELS "${kernels_by_default}" CACHE STRING
    "Instruction sets to compile kernels for, of ${cairn_isas}; native: the best of this machine, and one that all have; \
all of them if empty")
if(CAIRN_KERNELS STREQUAL "native")
    set(cairn_isas ${cairn_baseline})
    if(cairn_baseline STREQUAL "sse2")
        cairn_runs_here(CAIRN_RUNS_AVX512 avx512vl avx512dq avx512bw)
        cairn_runs_here(CAIRN_RUNS_AVX2 avx2)
        if(CAIRN_RUNS_AVX512)
            list(APPEND cairn_isas avx512)
        elseif(CAIRN_RUNS_AVX2)
            list(APPEND cairn_isas avx2)
        endif()
        if(CAIRN_RUNS_AVX2 AND NOT PROJECT_IS_TOP_LEVEL)
            list(APPEND cairn_flags_sse2 -O1) # not used on this machine: a short build matters more
        endif()
    endif()
elseif(CAIRN_KERNELS)
    foreach(isa ${CAIRN_KERNELS})
        if(NOT isa IN_LIST cairn_isas)
            message(FATAL_ERROR "CAIRN_KERNELS has ${isa}; there are ${cairn_isas} for this machine, and native")
        endif()
    endforeach()
    set(cairn_isas ${CAIRN_KERNELS})
endif()
