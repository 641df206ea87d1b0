// GEARFILM_INDEPENDENT_ITERATIONS before a loop: its iterations do not depend on each other, so the compiler may use
// vectors where it cannot see that for itself.
#pragma once

#if defined(__clang__)
#define GEARFILM_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define GEARFILM_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define GEARFILM_INDEPENDENT_ITERATIONS
#endif
