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
