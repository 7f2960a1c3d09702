#pragma once

// With g++ 12 or later on x86-64 a function with this mark is compiled twice, for every processor
// and for those with 256-bit integer vectors and a count of leading zeros (x86-64-v3), and the
// loader picks one; `flatten` inlines what it calls into both. The results are the same integers.
// Sanitizers get the plain one: the choice would run before their own set-up.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define REPOUSSE_VECTOR_CLONES __attribute__((flatten, target_clones("default", "arch=x86-64-v3")))
#else
#define REPOUSSE_VECTOR_CLONES
#endif

// Before a loop: no element's result is a later element's operand, so that a result's array may be
// an operand's. (clang finds out at run time.)
#if defined(__clang__)
#define REPOUSSE_INDEPENDENT
#else
#define REPOUSSE_INDEPENDENT _Pragma("GCC ivdep")
#endif

// Before a short loop of constant length, which -O2 would leave a loop.
#if defined(__GNUC__) && !defined(__clang__)
#define REPOUSSE_UNROLLED _Pragma("GCC unroll 16")
#else
#define REPOUSSE_UNROLLED
#endif
