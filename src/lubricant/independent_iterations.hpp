// GEARFILM_INDEPENDENT_ITERATIONS before a loop: its iterations do not depend on each other, so the compiler may use
// vectors where it cannot see that for itself.
// GEARFILM_NOT_UNROLLED behind it, before a loop as short as a few vectors: gcc would write it out before it looks for
// vectors, and then find them across other loops.
#pragma once

#if defined(__clang__)
#define GEARFILM_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define GEARFILM_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define GEARFILM_INDEPENDENT_ITERATIONS
#endif

#if defined(__GNUC__) && !defined(__clang__)
#define GEARFILM_NOT_UNROLLED _Pragma("GCC unroll 1")
#else
#define GEARFILM_NOT_UNROLLED
#endif
