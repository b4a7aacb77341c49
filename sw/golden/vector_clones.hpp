// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>  // names the C library

/// Before a function: what it calls becomes part of it, and it is compiled a second time for
/// processors with AVX2. The program loader picks one; integers make both give the same numbers.
/// Needs GCC and glibc; elsewhere the function is compiled once.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define TRIHEDRON_VECTOR_CLONES [[gnu::target_clones("avx2", "default"), gnu::flatten]]
#else
#define TRIHEDRON_VECTOR_CLONES
#endif
