# SPDX-License-Identifier: Apache-2.0
# Options and compiler settings that every target shares.
option(TRIHEDRON_SIM "Build the SystemC simulation of the RTL (needs Verilator and SystemC)" ON)
option(TRIHEDRON_TESTS "Build the tests" ON)
option(TRIHEDRON_BENCH "Build the benchmarks" OFF)

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

# Same input, same output: no contraction of a*b+c, which differs between machines.
add_compile_options(-ffp-contract=off)

# ASan and UBSan at a speed at which fuzzing gets somewhere; a finding ends the program.
option(TRIHEDRON_SANITIZE "Build everything with sanitizers, the fuzzing harnesses with libFuzzer (clang)" OFF)
if(TRIHEDRON_SANITIZE)
  set(CMAKE_CXX_FLAGS_DEBUG "-O1 -gline-tables-only")
  add_compile_options(-fsanitize=address,undefined,float-cast-overflow,fuzzer-no-link
    -fno-sanitize-recover=all -fno-omit-frame-pointer
    -D_GLIBCXX_ASSERTIONS "$<$<COMPILE_LANGUAGE:CXX>:-fconstexpr-steps=10000000>")
  add_link_options(-fsanitize=address,undefined)
endif()
